#include "seahex/world/BlockingRule.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace seahex
{
namespace
{

// Depths that stand for a missing VALSOU, metres: the values of S-52's OBSTRN04 and WRECKS02.
constexpr double NON_DANGEROUS_WRECK_M = 20.0;
constexpr double DANGEROUS_WRECK_M = 0.0;
constexpr double UNDER_WATER_M = 0.01;
constexpr double AWASH_M = 0.0;
constexpr double DRIES_M = -15.0;

/// DRVAL1 of a depth area that does not give it: S-52's DEPARE03 takes it as drying.
constexpr double UNKNOWN_DEPTH_AREA_M = -1.0;

/// S-57's codes, as far as a rule asks for them.
enum Watlev
{
    PARTLY_SUBMERGED = 1,
    ALWAYS_DRY = 2,
    ALWAYS_UNDER_WATER = 3,
    COVERS_AND_UNCOVERS = 4,
    AWASH = 5,
    SUBJECT_TO_FLOODING = 6,
    FLOATING = 7
};

/// Written so that any comparison with a value that is not a number says no: unknown is dangerous.
bool isDeeper(double depthM, double requiredM)
{
    return std::isfinite(depthM) && std::isfinite(requiredM) && depthM > requiredM;
}

bool isDeepEnough(double depthM, double requiredM)
{
    return std::isfinite(depthM) && std::isfinite(requiredM) && depthM >= requiredM;
}

struct DefaultDepth
{
    double depthM;
    const char *because;
};

/// Steps 3 to 5: WATLEV decides.
DefaultDepth depthByWaterLevel(const HazardObject &object)
{
    const double watlev = object.value("WATLEV").value_or(0.0);
    if (watlev == AWASH)
        return {AWASH_M, "least depth unknown, awash at chart datum"};
    if (watlev == ALWAYS_UNDER_WATER)
        return {UNDER_WATER_M, "least depth unknown, always under water"};
    return {DRIES_M, "least depth unknown, taken as drying"};
}

/// Step 1: the depth of the surroundings stands for that of the danger, but only where the chart says that the danger
/// is no shoaler than they are (EXPSOU 1 or 3) and is always under water.
bool surroundingsDecide(const HazardObject &object)
{
    return object.value("WATLEV") == ALWAYS_UNDER_WATER && (object.has("EXPSOU", 1) || object.has("EXPSOU", 3)) &&
           object.surroundingDepthM.has_value();
}

/// The depth of a danger with no VALSOU.
DefaultDepth defaultDepth(const HazardObject &object, double requiredM)
{
    if (surroundingsDecide(object))
        return {*object.surroundingDepthM, "least depth unknown, that of the surroundings is taken"};
    if (object.has("CATOBS", 6))
        return {UNDER_WATER_M, "foul area, least depth unknown"};
    if (object.objectClass == "WRECKS")
    {
        const bool surroundingsClear = object.surroundingDepthM && isDeepEnough(*object.surroundingDepthM, requiredM);
        if (object.has("CATWRK", 1) && surroundingsClear)
            return {NON_DANGEROUS_WRECK_M, "non-dangerous wreck in deep surroundings"};
        if (object.has("CATWRK", 2))
            return {DANGEROUS_WRECK_M, "dangerous wreck, least depth unknown"};
        if (object.has("CATWRK", 4) || object.has("CATWRK", 5))
            return {DRIES_M, "wreck that shows above water"};
    }
    return depthByWaterLevel(object);
}

Verdict blocked(const char *because)
{
    return {Outcome::Blocked, std::nullopt, because};
}

Verdict cost(const char *because)
{
    return {Outcome::Cost, std::nullopt, because};
}

Verdict byDepth(bool clear, double depthM, Outcome ifClear, const char *because)
{
    return {clear ? ifClear : Outcome::Blocked, depthM, because};
}

Verdict judgeDepthArea(const HazardObject &object, double requiredM)
{
    const std::optional<double> drval1 = object.value("DRVAL1");
    const double depthM = drval1.value_or(UNKNOWN_DEPTH_AREA_M);
    // Not regularly maintained: the charted depth may be gone.
    const Outcome ifClear = object.has("QUASOU", 11) ? Outcome::Cost : Outcome::Ignored;
    return byDepth(isDeepEnough(depthM, requiredM), depthM, ifClear,
                   drval1 ? "least depth of the area" : "least depth of the area unknown");
}

Verdict judgeSounding(const HazardObject &object, double requiredM)
{
    const std::optional<double> depthM = object.value("DEPTH");
    if (!depthM)
        return blocked("sounding of unknown depth");
    return byDepth(isDeeper(*depthM, requiredM), *depthM, Outcome::Ignored, "sounding");
}

/// True if WATLEV says that the object is at the surface at least at times.
bool shows(const HazardObject &object)
{
    const double watlev = object.value("WATLEV").value_or(0.0);
    return watlev == PARTLY_SUBMERGED || watlev == ALWAYS_DRY || watlev == COVERS_AND_UNCOVERS || watlev == AWASH ||
           watlev == SUBJECT_TO_FLOODING || watlev == FLOATING;
}

bool isFoulGroundOnly(const HazardObject &object)
{
    return object.has("CATOBS", 7) && !shows(object);
}

/// NEWOBJ and its like: nobody knows what it is, but where it says that it shows above water, it is in the way.
Verdict judgeCaution(const HazardObject &object)
{
    return shows(object) ? blocked("shows at the surface") : cost("caution");
}

Verdict judgeDanger(const HazardObject &object, double requiredM)
{
    if (object.has("WATLEV", FLOATING))
        return blocked("floats on the surface");
    if (object.has("CATOBS", 8) || object.has("CATOBS", 10))
        return blocked("boom on the surface");

    if (const std::optional<double> valsou = object.value("VALSOU"))
        return byDepth(isDeeper(*valsou, requiredM), *valsou, Outcome::Cost, "least depth of the danger");
    if (isFoulGroundOnly(object))
        return cost("foul ground: no anchoring");

    const DefaultDepth taken = defaultDepth(object, requiredM);
    return byDepth(isDeeper(taken.depthM, requiredM), taken.depthM, Outcome::Cost, taken.because);
}

Verdict judgeMarineFarm(const HazardObject &object, double requiredM)
{
    const std::optional<double> valsou = object.value("VALSOU");
    if (!valsou || object.value("WATLEV") != ALWAYS_UNDER_WATER)
        return blocked("marine farm");
    return byDepth(isDeeper(*valsou, requiredM), *valsou, Outcome::Cost, "least depth of the marine farm");
}

Verdict judgeMooring(const HazardObject &object)
{
    // CATMOR 6 is a chain, wire or cable to a mooring: it lies on the bottom for most of its length. All others stand
    // in the water or float on it, and so may one of unknown category.
    if (object.value("CATMOR") == 6.0)
        return cost("chain or cable of a mooring");
    return blocked(object.value("CATMOR") ? "mooring facility" : "mooring facility of unknown category");
}

Verdict judgePipeline(const HazardObject &object, double requiredM)
{
    const std::optional<double> depthM = object.value("DRVAL1");
    if (!depthM)
        return {Outcome::Ignored, std::nullopt, "pipeline on the bottom"};
    return byDepth(isDeeper(*depthM, requiredM), *depthM, Outcome::Ignored, "least depth over the pipeline");
}

/// Empty for what is judged as at the surface: neither seabed nor in the water at a depth of its own.
std::optional<Verdict> judgeInWaterColumn(const HazardObject &object, HazardScope scope)
{
    switch (object.rule)
    {
        case HazardRule::DepthArea:
        case HazardRule::Sounding:
            return Verdict{};
        case HazardRule::Danger:
            return blocked("danger under water");
        case HazardRule::MarineFarm:
            return blocked("marine farm");
        case HazardRule::Mooring:
            return blocked("mooring facility");
        case HazardRule::Pipeline:
            return blocked("pipeline");
        case HazardRule::Cable:
            return scope == HazardScope::WaterColumn ? blocked("submarine cable")
                                                     : cost("submarine cable, to be crossed above");
        default:
            return std::nullopt;
    }
}

const char *reasonOfAlways(const std::string &objectClass)
{
    if (objectClass == "LNDARE")
        return "land";
    if (objectClass == "UNSARE")
        return "unsurveyed";
    if (objectClass == "COALNE")
        return "coastline";
    if (objectClass == "ICEARE")
        return "ice";
    return "solid or floating object";
}

std::string metres(double value)
{
    char text[48];
    std::snprintf(text, sizeof text, "%.6g m", value);
    return text;
}

}  // namespace

Verdict judge(const HazardObject &object, const Vessel &vessel, HazardScope scope)
{
    if (scope == HazardScope::WaterColumn || scope == HazardScope::WaterColumnAboveCables)
        if (const std::optional<Verdict> verdict = judgeInWaterColumn(object, scope))
            return *verdict;
    if (scope == HazardScope::LandOnly)
        return object.objectClass == "LNDARE" ? blocked("land") : Verdict{};

    const double requiredM = vessel.requiredDepthM();
    switch (object.rule)
    {
        case HazardRule::Always:
            return blocked(reasonOfAlways(object.objectClass));
        case HazardRule::DepthArea:
            return judgeDepthArea(object, requiredM);
        case HazardRule::Sounding:
            return judgeSounding(object, requiredM);
        case HazardRule::Danger:
            return judgeDanger(object, requiredM);
        case HazardRule::MarineFarm:
            return judgeMarineFarm(object, requiredM);
        case HazardRule::Mooring:
            return judgeMooring(object);
        case HazardRule::Pipeline:
            return judgePipeline(object, requiredM);
        case HazardRule::ChartGap:
            return blocked("no area of the chart describes this water");
        case HazardRule::Caution:
            return judgeCaution(object);
        case HazardRule::Overhead:
            return cost("overhead: clearance not judged");
        case HazardRule::Regulation:
            return cost("regulated area: rules not judged");
        case HazardRule::Quality:
            return cost("quality of the data: not judged");
        case HazardRule::Cable:
        case HazardRule::Ignored:
            break;
    }
    return {Outcome::Ignored, std::nullopt, "no matter for routing"};
}

double keepOutRadiusM(const HazardObject &object, const Vessel &vessel)
{
    return std::max(object.radiusM, vessel.marginM);
}

std::string explain(const HazardObject &object, const Vessel &vessel, const Verdict &verdict)
{
    std::string text = describe(object) + ": ";
    if (!verdict.depthM)
        return text + verdict.because;
    text += "depth " + metres(*verdict.depthM) + ", " + metres(vessel.requiredDepthM()) + " needed";
    if (*verdict.because != '\0')
        text += std::string(" (") + verdict.because + ")";
    return text;
}

}  // namespace seahex
