#include "seahex/io/PositionParser.h"

#include <GeographicLib/DMS.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// The numbers are taken apart here and not by GeographicLib::DMS::DecodeLatLon: that one reads "21.635" as
// 21.635000000000002, takes "42 20.5'" for 4220.5 minutes once the blank is gone, and breaks when the program's locale
// groups digits.

namespace seahex
{

namespace
{

constexpr std::size_t LONGEST_TEXT = 100;  // bytes; no position is longer, and the pattern below costs stack by length

constexpr const char *HEMISPHERES = "NSEW";

struct Angle
{
    double deg = 0.0;
    char hemisphere = 0;  ///< 0 if there is none

    bool isLatitude() const { return hemisphere == 'N' || hemisphere == 'S'; }
    bool isLongitude() const { return hemisphere == 'E' || hemisphere == 'W'; }
};

/// Why a text is no position; parsePosition adds the text.
class Refusal : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

std::string quoted(const std::string &text)
{
    std::string shown = text.substr(0, LONGEST_TEXT);
    std::replace_if(
        shown.begin(), shown.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    return '"' + shown + (text.size() > LONGEST_TEXT ? "..." : "") + '"';
}

std::string number(double value)
{
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << value;
    return out.str();
}

/// Upper case, with D ' " for degrees, minutes and seconds whatever sign was used, and plain blanks and hyphens.
std::string inPlainSigns(std::string text)
{
    static const std::vector<std::pair<std::string, std::string>> signs = {
        {"\u00b0", "D"},  {"\u00ba", "D"},  {"\u02da", "D"}, {"\u2218", "D"},  {"\u2032", "'"}, {"\u2019", "'"},
        {"\u2018", "'"},  {"\u02b9", "'"},  {"\u00b4", "'"}, {"\u2033", "\""}, {"`", "'"},      {"\u201d", "\""},
        {"\u201c", "\""}, {"\u02ba", "\""}, {"''", "\""},    {"\u2212", "-"},  {"\u2013", "-"}, {"\u2014", "-"},
        {"\u2010", "-"},  {"\u2011", "-"},  {"\u00a0", " "}, {"\u2009", " "},  {"\u202f", " "}, {"\u2007", " "},
    };
    for (const auto &[sign, plain] : signs)
        for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + plain.size()))
            text.replace(at, sign.size(), plain);
    for (char &c : text)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

/// Where the second value begins in a text that has two degree signs and neither commas nor letters.
std::size_t secondDegreeValue(const std::string &text)
{
    std::size_t at = text.find('D', text.find('D') + 1);
    while (at > 0 && text[at - 1] == ' ')
        --at;
    while (at > 0 && (std::isdigit(static_cast<unsigned char>(text[at - 1])) != 0 || text[at - 1] == '.'))
        --at;
    return at > 0 && (text[at - 1] == '-' || text[at - 1] == '+') ? at - 1 : at;
}

/// Parts the text into its two values.
std::pair<std::string, std::string> parted(const std::string &text)
{
    const auto partedAt = [&text](std::size_t at, std::size_t skipped = 0)
    {
        return std::pair(text.substr(0, at), text.substr(at + skipped));
    };
    const auto commas = std::count(text.begin(), text.end(), ',');
    if (commas > 1)
        throw Refusal("one comma may part latitude and longitude, and decimals take a point");
    if (commas == 1)
        return partedAt(text.find(','), 1);

    const std::size_t letter = text.find_first_of(HEMISPHERES);
    if (letter != std::string::npos)
    {
        const std::size_t second = text.find_first_of(HEMISPHERES, letter + 1);
        if (second == std::string::npos)
            throw Refusal("a hemisphere letter stands on one value only, and no comma parts the two");
        return letter == text.find_first_not_of(' ') ? partedAt(second) : partedAt(letter + 1);
    }
    if (std::count(text.begin(), text.end(), 'D') == 2)
        return partedAt(secondDegreeValue(text));

    std::istringstream words(text);
    std::vector<std::string> values;
    for (std::string word; words >> word;)
        values.push_back(word);
    if (values.size() != 2)
        throw Refusal("a latitude and a longitude are needed, parted by a comma, a blank or hemisphere letters");
    return {values[0], values[1]};
}

/// Walks over the text of one angle.
class Scanner
{
public:
    explicit Scanner(const std::string &text) : text_(text) {}

    /// @return whether there were any
    bool skipBlanks()
    {
        const std::size_t before = at_;
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
        return at_ > before;
    }

    /// Takes one of the signs if it is next; 0 if none is.
    char take(const std::string &signs)
    {
        return !atEnd() && signs.find(text_[at_]) != std::string::npos ? text_[at_++] : '\0';
    }

    /// Digits with at most one point; empty if none are next.
    std::string takeNumber()
    {
        const std::size_t before = at_;
        bool point = false;
        bool digit = false;
        for (; !atEnd() && (isDigit(at_) || (text_[at_] == '.' && !point)); ++at_)
            (text_[at_] == '.' ? point : digit) = true;
        return digit ? text_.substr(before, at_ - before) : std::string();
    }

    /// Takes what parts two numbers: the mark of the first one, then perhaps a hyphen; a hyphen or colon; or blanks.
    /// @return whether a number follows it
    bool takeSeparator(char mark)
    {
        const bool blanks = skipBlanks();
        const bool marked = take({mark}) != 0;
        const bool free = marked ? skipBlanks() : blanks;
        const bool joined = !free && at_ + 1 < text_.size() && (isDigit(at_ + 1) || text_[at_ + 1] == '.') &&
                            take(marked ? "-" : "-:") != 0;
        return (blanks || marked || joined) && !atEnd() && (isDigit(at_) || text_[at_] == '.');
    }

    bool atEnd() const { return at_ == text_.size(); }

private:
    bool isDigit(std::size_t at) const { return std::isdigit(static_cast<unsigned char>(text_[at])) != 0; }

    const std::string &text_;
    std::size_t at_ = 0;
};

/// Degrees, minutes and seconds, as many of them as there are.
std::vector<std::string> takeNumbers(Scanner &scanner)
{
    std::vector<std::string> numbers;
    for (const char mark : {'D', '\'', '"'})
    {
        numbers.push_back(scanner.takeNumber());
        if (!scanner.takeSeparator(mark) || numbers.back().empty())
            break;
    }
    return numbers;
}

double toNumber(const std::string &digits)
{
    double value = 0.0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);  // takes whatever the scanner takes
    return value;
}

Angle readAngle(const std::string &text)
{
    Scanner scanner(text);
    scanner.skipBlanks();
    const char letterBefore = scanner.take(HEMISPHERES);
    scanner.skipBlanks();
    const char sign = scanner.take("+-");
    scanner.skipBlanks();
    std::vector<std::string> numbers = takeNumbers(scanner);
    const char letterBehind = scanner.take(HEMISPHERES);
    scanner.skipBlanks();
    if (!scanner.atEnd() || numbers.back().empty())
        throw Refusal(quoted(text) + " is no angle in degrees, minutes and seconds");

    if ((letterBefore != 0) + (sign != 0) + (letterBehind != 0) > 1)
        throw Refusal(quoted(text) + " has more than one sign or hemisphere letter");
    for (std::size_t i = 0; i + 1 < numbers.size(); ++i)
        if (numbers[i].find('.') != std::string::npos)
            throw Refusal(quoted(text) + " has decimals before the last number");
    numbers.resize(3, "0");
    const double minutes = toNumber(numbers[1]);
    const double seconds = toNumber(numbers[2]);
    if (minutes >= 60.0 || seconds >= 60.0)
        throw Refusal(quoted(text) + " has 60 or more minutes or seconds");

    const double deg = GeographicLib::DMS::Decode(toNumber(numbers[0]), minutes, seconds);
    const char hemisphere = letterBefore != 0 ? letterBefore : letterBehind;
    return {sign == '-' || hemisphere == 'S' || hemisphere == 'W' ? 0.0 - deg : deg, hemisphere};
}

GeoPoint readPosition(const std::string &text)
{
    if (text.size() > LONGEST_TEXT)
        throw Refusal("it has " + std::to_string(text.size()) + " bytes");
    const auto [first, second] = parted(inPlainSigns(text));
    Angle latitude = readAngle(first);
    Angle longitude = readAngle(second);
    if ((latitude.isLatitude() && longitude.isLatitude()) || (latitude.isLongitude() && longitude.isLongitude()))
        throw Refusal("both letters belong to " + std::string(latitude.isLatitude() ? "latitudes" : "longitudes"));
    if (latitude.isLongitude() || longitude.isLatitude())
        std::swap(latitude, longitude);

    if (std::abs(latitude.deg) > 90.0)
        throw Refusal("latitude " + number(latitude.deg) +
                      " degrees lies beyond a pole (without letters the latitude comes first)");
    if (longitude.deg < -180.0 || longitude.deg > 360.0)
        throw Refusal("longitude " + number(longitude.deg) + " degrees lies outside -180 to 360");
    return GeoPoint::fromLatLon(latitude.deg, longitude.deg >= 180.0 ? longitude.deg - 360.0 : longitude.deg);
}

}  // namespace

GeoPoint parsePosition(const std::string &text)
{
    try
    {
        return readPosition(text);
    }
    catch (const Refusal &refusal)
    {
        throw PositionError("can't read " + quoted(text) + " as a position: " + refusal.what());
    }
}

}  // namespace seahex
