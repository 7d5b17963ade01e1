#include "seahex/io/PositionParser.h"

#include "support/Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <locale>
#include <string>
#include <vector>

namespace seahex
{

namespace
{

/// What parsePosition says about a text that is no position; empty if it takes it.
std::string refusal(const std::string &text)
{
    try
    {
        parsePosition(text);
        return "";
    }
    catch (const PositionError &error)
    {
        return error.what();
    }
}

struct Case
{
    std::string text;
    double latitudeDeg;
    double longitudeDeg;
};

void expectReadAs(const Case &expected)
{
    SCOPED_TRACE(expected.text);
    ASSERT_EQ(refusal(expected.text), "");
    const GeoPoint found = parsePosition(expected.text);
    EXPECT_NEAR(found.latitudeDeg(), expected.latitudeDeg, 1e-12);
    EXPECT_NEAR(found.longitudeDeg(), expected.longitudeDeg, 1e-12);
}

class CommaAsDecimalPoint : public std::numpunct<char>
{
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST(PositionParser, ReadsDecimalDegrees)
{
    for (const Case &c : std::vector<Case>{
             {"21.635,112.521", 21.635, 112.521},
             {"21.635 112.521", 21.635, 112.521},
             {"  21.635 ,\t112.521 ", 21.635, 112.521},
             {"-33.85, 151.2", -33.85, 151.2},
             {"-33.85 -70.5", -33.85, -70.5},
             {"+33.85,-070.5", 33.85, -70.5},
             {"\u221233.85 \u221270.5", -33.85, -70.5},
             {"21.635N 112.521E", 21.635, 112.521},
             {"N21.635 E112.521", 21.635, 112.521},
             {"21.635 s, 112.521 w", -21.635, -112.521},
             {"42N70W", 42.0, -70.0},
             {"42N, -70.5", 42.0, -70.5},
             {"21.635\u00b0,112.521\u00b0", 21.635, 112.521},
             {".5,5.", 0.5, 5.0},
             {"90,0", 90.0, 0.0},
             {"-90 0", -90.0, 0.0},
         })
        expectReadAs(c);
}

TEST(PositionParser, ReadsDegreesMinutesAndSeconds)
{
    const double latitude = 42.0 + 20.5 / 60.0;
    const double longitude = -(70.0 + 53.2 / 60.0);
    for (const Case &c : std::vector<Case>{
             {"42-20.5N 070-53.2W", latitude, longitude},
             {"42 20.5 N 70 53.2 W", latitude, longitude},
             {"42 20.5N,70 53.2W", latitude, longitude},
             {"N42 20.5 W70 53.2", latitude, longitude},
             {"N 42 20.5 W 70 53.2", latitude, longitude},
             {"42\u00b020.5'N 70\u00b053.2'W", latitude, longitude},
             {"42\u00b0 20.5\u2032 N, 70\u00b0 53.2\u2032 W", latitude, longitude},
             {"42\u00b0 20.5 N 70\u00b0 53.2 W", latitude, longitude},
             {"42 20.5' N 70 53.2' W", latitude, longitude},
             {"42\u00b0-20.5'N 070\u00b0-53.2'W", latitude, longitude},
             {"42d20.5', -70d53.2'", latitude, longitude},
             {"42\u00b0 20.5' -70\u00b0 53.2'", latitude, longitude},
             {"42\u00b020'30\" -70\u00b053'12\"", latitude, longitude},
             {"42\u00b0\u00a020'\u00a030\"N 70\u00b0\u00a053'\u00a012\"W", latitude, longitude},
             {"42-20.5 -70-53.2", latitude, longitude},
             {"42 20.5, -70 53.2", latitude, longitude},
             {"42:20:30N 70:53:12W", latitude, longitude},
             {"42 20 30 N 70 53 12 W", latitude, longitude},
             {"42-20-30N 070-53-12W", latitude, longitude},
             {"21 38.1N, 112 31.26E", 21.635, 112.521},
             {"21\u00b038'06\"N 112\u00b031'15.6\"E", 21.635, 112.521},
             {"21\u00b038\u203206\u2033N 112\u00b031\u203215.6\u2033E", 21.635, 112.521},
             {"21\u00b038'06''N 112\u00b031'15.6''E", 21.635, 112.521},
             {"21\u00ba38\u201906\u201dN 112\u00ba31\u201915.6\u201dE", 21.635, 112.521},
             {"-0 30, -0 15", -0.5, -0.25},
         })
        expectReadAs(c);
}

TEST(PositionParser, LettersWinOverOrder)
{
    for (const char *text : {"112.521E,21.635N", "112 31.26E 21 38.1N", "E112.521 N21.635", "112.521E,21.635"})
        expectReadAs({text, 21.635, 112.521});
}

TEST(PositionParser, BringsLongitudesIntoRange)
{
    for (const Case &c : std::vector<Case>{{"10,180", 10.0, -180.0},
                                           {"10,-180", 10.0, -180.0},
                                           {"10,289.5", 10.0, -70.5},
                                           {"10N 289.5E", 10.0, -70.5},
                                           {"10,360", 10.0, 0.0},
                                           {"10,179.5", 10.0, 179.5}})
        expectReadAs(c);
}

TEST(PositionParser, RefusesWhatIsNoPositionAndQuotesIt)
{
    for (const std::string text : {"",
                                   " ",
                                   ",",
                                   "hello",
                                   "nan,nan",
                                   "nan 10",
                                   "10,inf",
                                   "-inf,10",
                                   "21.635",
                                   "21.635,",
                                   ",112.5",
                                   "1,2,3",
                                   "1 2 3",
                                   "42 20.5 70 53.2",
                                   "21,635,112,521",
                                   "21,5N 112,5E",
                                   "90.0001,0",
                                   "-91,0",
                                   "112.521,21.635",
                                   "91N 0E",
                                   "10,361",
                                   "10,-180.5",
                                   "10N 190W",
                                   "10N 20S",
                                   "10E,20W",
                                   "10N 20E 30N",
                                   "-10S 20E",
                                   "N10S 20E",
                                   "10N 20",
                                   "42 60N 70 10W",
                                   "42 20 60N 70 10W",
                                   "42.5 20N 70 10W",
                                   "42 20.5 30N 70 10W",
                                   "42 -20N, 70W",
                                   "1e1,2e1",
                                   "1e5 2",
                                   "0x10,5",
                                   "1.2.3,4",
                                   "4::5,6",
                                   "10;20",
                                   "10,20 30 40 50",
                                   "20.5'42\u00b0N 70W",
                                   "\xff\xfe,10",
                                   "10\xc2,20"})
    {
        SCOPED_TRACE(text);
        const std::string message = refusal(text);
        EXPECT_NE(message.find("can't read \"" + text + "\" as a position: "), std::string::npos) << message;
    }
}

TEST(PositionParser, RefusesTextsOfAnyLengthOnOneLine)
{
    for (const std::string &text :
         {std::string(1000000, '1'), std::string(1000000, ' '), std::string("1\n2\n3"), std::string("1,2\0,", 5)})
    {
        const std::string message = refusal(text);
        EXPECT_NE(message, "");
        EXPECT_LT(message.size(), 400U);
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
}

TEST(PositionParser, HintsThatLatitudeComesFirst)
{
    const std::string message = refusal("112.521,21.635");
    EXPECT_NE(message.find("latitude 112.521 degrees lies beyond a pole"), std::string::npos) << message;
    EXPECT_NE(message.find("latitude comes first"), std::string::npos) << message;
}

TEST(PositionParser, ReadsEveryDoubleExactly)
{
    test::Random random(20261);
    SCOPED_TRACE(random.seedText());
    for (int i = 0; i < 2000; ++i)
    {
        const double latitude = random.real(-90.0, 90.0);
        const double longitude = random.real(-180.0, 180.0);
        char text[80];
        std::snprintf(text, sizeof text, "%.20f,%.20f", latitude, longitude);
        EXPECT_EQ(parsePosition(text), GeoPoint::fromLatLon(latitude, longitude)) << text;
    }
}

TEST(PositionParser, ReadsEveryFormAlike)
{
    test::Random random(20262);
    SCOPED_TRACE(random.seedText());
    for (int i = 0; i < 2000; ++i)
    {
        // tenths of a second, so that every form shows the position in full
        const long lat = random.integer(0, 90L * 36000);
        const long lon = random.integer(0, 180L * 36000 - 1);
        const char ns = random.chance(0.5) ? 'N' : 'S';
        const char ew = random.chance(0.5) ? 'E' : 'W';
        const double latitude = (ns == 'N' ? 1 : -1) * static_cast<double>(lat) / 36000.0;
        const double longitude = (ew == 'E' ? 1 : -1) * static_cast<double>(lon) / 36000.0;
        const long seconds[] = {lat % 600, lon % 600};
        for (const char *form : {"%ld-%ld-%ld.%ld%c %03ld-%02ld-%02ld.%ld%c", "%ld %ld %ld.%ld %c %ld %ld %ld.%ld %c",
                                 "%ld\u00b0%02ld'%02ld.%ld\"%c, %ld\u00b0%02ld\u2032%02ld.%ld\u2033%c"})
        {
            char text[120];
            std::snprintf(text, sizeof text, form, lat / 36000, lat / 600 % 60, seconds[0] / 10, seconds[0] % 10, ns,
                          lon / 36000, lon / 600 % 60, seconds[1] / 10, seconds[1] % 10, ew);
            expectReadAs({text, latitude, longitude});
        }
    }
}

TEST(PositionParser, DoesNotDependOnTheLocale)
{
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaAsDecimalPoint));
    const GeoPoint found = parsePosition("21.635N 112 31.26E");
    const std::string message = refusal("1234.5,10");
    std::locale::global(before);
    EXPECT_EQ(found.latitudeDeg(), 21.635);
    EXPECT_NEAR(found.longitudeDeg(), 112.521, 1e-12);
    EXPECT_NE(message.find("latitude 1234.5 degrees"), std::string::npos) << message;
}

}  // namespace seahex
