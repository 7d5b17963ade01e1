#pragma once

#include <seahex/world/Hazard.h>
#include <seahex/world/Vessel.h>

#include <optional>
#include <string>

namespace seahex
{

/// What an object means for a vessel.
enum class Outcome
{
    Blocked,      ///< must not be touched
    Cost,         ///< may be crossed; the navigator should know
    Directional,  ///< may be crossed in some directions only (none of today's rules yields it)
    Ignored       ///< no matter
};

/// Which chart objects count.
enum class HazardScope
{
    All,       ///< the whole catalogue
    LandOnly,  ///< LNDARE alone, as the published scenario of [Cheng2020] has it
    /// What a vehicle under water keeps out of at every depth, from the surface to the seabed: all that stands, lies or
    /// floats, at whatever charted depth (wrecks, rocks, obstructions, piles, buoys, pipelines, cables, fish farms),
    /// and land. Depth areas and soundings don't count: they are the seabed (Bathymetry).
    WaterColumn,
    /// The same, but for submarine cables: a vehicle that crosses above them takes them for a part of the seabed
    /// (raiseCables).
    WaterColumnAboveCables
};

/// The outcome for one object, with what decided it.
struct Verdict
{
    Outcome outcome = Outcome::Ignored;
    std::optional<double> depthM;  ///< the depth that was tested, metres below datum; empty where none was
    const char *because = "";      ///< static text: the rule in a few words

    bool blocks() const { return outcome == Outcome::Blocked; }
};

/// Judges one chart object for one vessel. Pure: the same arguments give the same verdict.
///
/// The tide is taken as 0 (lowest level). With d = vessel.requiredDepthM(): areas block if DRVAL1 < d; soundings and
/// dangers block if their depth <= d, the comparisons of the S-101 portrayal rules. Where VALSOU of a danger is
/// missing, the order of S-52's OBSTRN04 and WRECKS02 decides: depth of the surroundings where it may be used (WATLEV 3
/// and EXPSOU 1 or 3), foul area 0.01 m, wrecks by CATWRK, then WATLEV.
Verdict judge(const HazardObject &object, const Vessel &vessel, HazardScope scope = HazardScope::All);

/// How far the vessel must stay from the object, metres: the larger of its margin and the class's own radius.
double keepOutRadiusM(const HazardObject &object, const Vessel &vessel);

/// "WRECKS ... of CELL (VALSOU 0.4): depth 0.4 m, 1.7 m needed": the object and why it has that outcome.
std::string explain(const HazardObject &object, const Vessel &vessel, const Verdict &verdict);

}  // namespace seahex
