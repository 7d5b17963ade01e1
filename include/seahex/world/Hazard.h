#pragma once

#include <seahex/geometry/Shape.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace seahex
{

/// How a chart object is judged: the column "rule" of the hazard catalogue. The judging itself is BlockingRule.
enum class HazardRule
{
    Always,      ///< blocks whatever its attributes say (land, piles, shoreline construction)
    DepthArea,   ///< DEPARE, DRGARE: blocks if DRVAL1 is less than the required depth; unknown DRVAL1 is -1 m
    Sounding,    ///< SOUNDG: blocks if the depth is not more than the required depth; unknown blocks
    Danger,      ///< OBSTRN, UWTROC, WRECKS: by VALSOU, and by the order of defaults where VALSOU is missing
    MarineFarm,  ///< MARCUL: blocks unless always under water (WATLEV 3) at a known VALSOU beyond the required depth
    Mooring,     ///< MORFAC: dolphins, bollards, tie-up walls, piles and mooring buoys block (CATMOR 1 to 5, 7)
    Cable,       ///< CBLSUB: lies on the bottom; blocks in the water column's scope only
    Pipeline,    ///< PIPSOL: blocks if DRVAL1 is known and not more than the required depth
    ChartGap,    ///< water inside the coverage that no group 1 area describes: a chart fault, blocks
    Caution,     ///< worth a word to the navigator; blocks only if WATLEV says that it shows at the surface
    Overhead,    ///< BRIDGE, CBLOHD, ...: reported where a route crosses it, not judged yet
    Regulation,  ///< RESARE, TSSLPT, ...: reported where a route crosses it, not judged yet
    Quality,     ///< M_QUAL and relatives: reported, not judged yet
    Ignored      ///< says nothing about where a vessel may go (SWPARE; DEPCNT, whose depths are the areas' beside it)
};

/// One attribute of a chart object, by its S-57 acronym. S-57's enumerations, lists and measures are all numbers.
struct HazardAttribute
{
    std::string acronym;         ///< "VALSOU"
    std::vector<double> values;  ///< one value, or those of a list; never empty
};

/// What a chart object is, apart from where it is: enough to judge it and to name it to a person.
struct HazardObject
{
    std::string objectClass;                  ///< S-57 acronym: "WRECKS"
    HazardRule rule = HazardRule::Ignored;    ///< from the hazard catalogue
    double radiusM = 0.0;                     ///< the class's own keep-out radius, metres; >= 0
    std::string cell;                         ///< the chart cell it came from: "US5MA12M"
    std::string featureId;                    ///< the feature's long name (LNAM) or record number
    std::string name;                         ///< OBJNAM, may be empty
    std::vector<HazardAttribute> attributes;  ///< those that decide, as read; a missing one is unknown

    /// Least DRVAL1 (metres, an unknown one counted as -1) of the DEPARE and DRGARE that the object touches; empty
    /// where there is none, or where an unsurveyed area is touched too. Only filled for dangers.
    std::optional<double> surroundingDepthM;

    /// The value of a single-valued attribute, empty if it is unknown.
    std::optional<double> value(const std::string &acronym) const;

    /// True if the attribute is known and one of its values is `code`.
    bool has(const std::string &acronym, int code) const;
};

/// A chart object in the plane: what it is (shared, immutable) and where it is (x east, y north; frame of its maker).
struct Hazard
{
    std::shared_ptr<const HazardObject> object;
    Shape shape;
};

/// A chart object in degrees, as read.
struct GeoHazard
{
    std::shared_ptr<const HazardObject> object;
    GeoShape shape;
};

/// "WRECKS 022604B5D1B20DBE of US5MA12M (VALSOU 3.6, WATLEV 3)": the object as a person would look it up.
std::string describe(const HazardObject &object);

}  // namespace seahex
