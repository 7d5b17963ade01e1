#include "seahex/world/Hazard.h"

#include <algorithm>
#include <cstdio>

namespace seahex
{
namespace
{

const HazardAttribute *findAttribute(const HazardObject &object, const std::string &acronym)
{
    const auto found = std::find_if(object.attributes.begin(), object.attributes.end(),
                                    [&](const HazardAttribute &attribute) { return attribute.acronym == acronym; });
    return found == object.attributes.end() ? nullptr : &*found;
}

/// "3.6": at most six digits, no trailing zeros.
std::string shortNumber(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

/// "RESTRN 7/8"
std::string toText(const HazardAttribute &attribute)
{
    std::string text = attribute.acronym;
    char separator = ' ';
    for (double value : attribute.values)
    {
        text += separator + shortNumber(value);
        separator = '/';
    }
    return text;
}

}  // namespace

std::optional<double> HazardObject::value(const std::string &acronym) const
{
    // Several values where one is meant say nothing certain, so they count as unknown.
    const HazardAttribute *attribute = findAttribute(*this, acronym);
    if (attribute == nullptr || attribute->values.size() != 1)
        return std::nullopt;
    return attribute->values.front();
}

bool HazardObject::has(const std::string &acronym, int code) const
{
    const HazardAttribute *attribute = findAttribute(*this, acronym);
    return attribute != nullptr &&
           std::find(attribute->values.begin(), attribute->values.end(), code) != attribute->values.end();
}

namespace
{

/// A name from a chart on one line, without what a terminal would obey.
std::string printable(std::string text)
{
    for (char &c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            c = ' ';
    return text;
}

}  // namespace

std::string describe(const HazardObject &object)
{
    std::string text = object.objectClass;
    if (!object.featureId.empty())
        text += " " + object.featureId;
    if (!object.name.empty())
        text += " \"" + printable(object.name) + "\"";
    if (!object.cell.empty())
        text += " of " + object.cell;
    if (object.attributes.empty())
        return text;

    text += " (";
    for (std::size_t i = 0; i < object.attributes.size(); ++i)
        text += (i == 0 ? "" : ", ") + toText(object.attributes[i]);
    return text + ")";
}

}  // namespace seahex
