#pragma once

#include <seahex/world/Hazard.h>

#include <ogr_feature.h>

#include <optional>
#include <string>
#include <vector>

namespace seahex
{

/// Numbers of a text in any of the ways in which OGR's formats write S-57's lists: "7,8", "(2:7,8)", "[ \"7\", \"8\"
/// ]".
/// @return empty if any part of it is no finite number: half a list would say less than the chart does
std::vector<double> parseNumbers(const std::string &text);

/// Which fields of a layer hold the attributes that are asked for, found once a layer. Names match in any case.
class FeatureFields
{
public:
    explicit FeatureFields(const OGRFeatureDefn &definition);

    /// The kept attributes that the feature knows. Values that are not finite count as unknown.
    std::vector<HazardAttribute> attributes(const OGRFeature &feature) const;

    /// The values of one attribute, empty if it is unknown.
    std::vector<double> numbers(const OGRFeature &feature, const std::string &acronym) const;

    /// A single whole number, as of CATCOV or PRIM.
    std::optional<int> code(const OGRFeature &feature, const std::string &acronym) const;

    /// Its long name, or else "record 12" (S-57), or else "fid 12".
    std::string id(const OGRFeature &feature) const;

    /// OBJNAM, empty if it has none.
    std::string name(const OGRFeature &feature) const;

private:
    struct Field
    {
        std::string acronym;
        int index;
    };

    int indexOf(const std::string &acronym) const;

    std::vector<Field> kept_;  ///< in the order of keptAttributes()
    std::vector<Field> all_;
    int longName_;
    int record_;
    int name_;
};

}  // namespace seahex
