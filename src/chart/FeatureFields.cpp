#include "FeatureFields.h"

#include "seahex/chart/HazardCatalogue.h"

#include <cpl_conv.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace seahex
{
namespace
{

/// What the S-57 driver writes for a number that is there but empty, if it is told to keep those.
constexpr double EMPTY_NUMBER = 2147483641.0;

bool isKnown(double value)
{
    return std::isfinite(value) && value != EMPTY_NUMBER;
}

/// The part of "(2:7,8)" behind the count; any other text as it is.
std::string withoutCount(const std::string &text)
{
    const std::size_t open = text.find_first_not_of(" \t");
    const std::size_t colon = text.find(':');
    return open != std::string::npos && text[open] == '(' && colon != std::string::npos ? text.substr(colon + 1) : text;
}

std::string upperCase(std::string text)
{
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::toupper(letter)); });
    return text;
}

template <class Number>
std::vector<double> copyList(const Number *values, int count)
{
    return std::vector<double>(values, values + count);
}

std::vector<double> textNumbers(const OGRFeature &feature, int index)
{
    std::string joined;
    for (char **text = feature.GetFieldAsStringList(index); text != nullptr && *text != nullptr; ++text)
        joined += (joined.empty() ? "" : ",") + std::string(*text);
    return parseNumbers(joined);
}

std::string text(const OGRFeature &feature, int index)
{
    return index < 0 || !feature.IsFieldSetAndNotNull(index) ? std::string() : feature.GetFieldAsString(index);
}

std::vector<double> fieldNumbers(const OGRFeature &feature, int index)
{
    int count = 0;
    switch (feature.GetFieldDefnRef(index)->GetType())
    {
        case OFTInteger:
        case OFTInteger64:
        case OFTReal:
            return {feature.GetFieldAsDouble(index)};
        case OFTIntegerList:
        {
            const int *values = feature.GetFieldAsIntegerList(index, &count);
            return copyList(values, count);
        }
        case OFTInteger64List:
        {
            const GIntBig *values = feature.GetFieldAsInteger64List(index, &count);
            return copyList(values, count);
        }
        case OFTRealList:
        {
            const double *values = feature.GetFieldAsDoubleList(index, &count);
            return copyList(values, count);
        }
        case OFTStringList:
            return textNumbers(feature, index);
        case OFTString:
            return parseNumbers(feature.GetFieldAsString(index));
        default:
            return {};
    }
}

}  // namespace

std::vector<double> parseNumbers(const std::string &text)
{
    static const std::string SEPARATORS = " \t,;[](){}\"'";
    const std::string list = withoutCount(text);
    std::vector<double> numbers;
    std::size_t begin = list.find_first_not_of(SEPARATORS);
    while (begin != std::string::npos)
    {
        const std::size_t end = std::min(list.find_first_of(SEPARATORS, begin), list.size());
        const std::string token = list.substr(begin, end - begin);
        char *rest = nullptr;
        const double value = CPLStrtod(token.c_str(), &rest);
        if (*rest != '\0' || !isKnown(value))
            return {};
        numbers.push_back(value);
        begin = list.find_first_not_of(SEPARATORS, end);
    }
    return numbers;
}

FeatureFields::FeatureFields(const OGRFeatureDefn &definition)
{
    for (int i = 0; i < definition.GetFieldCount(); ++i)
        all_.push_back({upperCase(definition.GetFieldDefn(i)->GetNameRef()), i});
    for (const char *acronym : keptAttributes())
        if (const int index = indexOf(acronym); index >= 0)
            kept_.push_back({acronym, index});
    longName_ = indexOf("LNAM");
    record_ = indexOf("RCID");
    name_ = indexOf("OBJNAM");
}

int FeatureFields::indexOf(const std::string &acronym) const
{
    const auto found =
        std::find_if(all_.begin(), all_.end(), [&](const Field &field) { return field.acronym == acronym; });
    return found == all_.end() ? -1 : found->index;
}

std::vector<HazardAttribute> FeatureFields::attributes(const OGRFeature &feature) const
{
    std::vector<HazardAttribute> known;
    for (const Field &field : kept_)
    {
        if (!feature.IsFieldSetAndNotNull(field.index))
            continue;
        std::vector<double> values = fieldNumbers(feature, field.index);
        if (!values.empty() && std::all_of(values.begin(), values.end(), isKnown))
            known.push_back({field.acronym, std::move(values)});
    }
    return known;
}

std::vector<double> FeatureFields::numbers(const OGRFeature &feature, const std::string &acronym) const
{
    const int index = indexOf(acronym);
    if (index < 0 || !feature.IsFieldSetAndNotNull(index))
        return {};
    return fieldNumbers(feature, index);
}

std::optional<int> FeatureFields::code(const OGRFeature &feature, const std::string &acronym) const
{
    const std::vector<double> values = numbers(feature, acronym);
    if (values.size() != 1 || !(std::abs(values.front()) < EMPTY_NUMBER))
        return std::nullopt;
    return static_cast<int>(values.front());
}

std::string FeatureFields::id(const OGRFeature &feature) const
{
    if (std::string longName = text(feature, longName_); !longName.empty())
        return longName;
    if (const std::string record = text(feature, record_); !record.empty())
        return "record " + record;
    return "fid " + std::to_string(feature.GetFID());
}

std::string FeatureFields::name(const OGRFeature &feature) const
{
    return text(feature, name_);
}

}  // namespace seahex
