#pragma once

#include <seahex/chart/ChartArena.h>
#include <seahex/geometry/GeoPoint.h>
#include <seahex/world/HazardIndex.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace seahex
{

/// What a written leg does wrong.
struct LegFault
{
    std::size_t leg;   ///< 0-based: from waypoint `leg` to the next
    std::string what;  ///< one sentence
};

/// Measures and checks a route as it is written: straight longitude-latitude lines between rounded waypoints, against
/// the hazards' own geometry. Shares neither cells nor legs with the planning that made the route.
///
/// In an arena of degrees the hazards are projected a second time into metres for the distances.
class WrittenRouteCheck
{
public:
    /// @param chart  the chart the arena was made of
    /// The arena must outlive the check.
    WrittenRouteCheck(const Chart &chart, const ChartArena &arena);

    /// The first leg that comes nearer to a blocking hazard than the arena's keep-out radius for it, or touches the
    /// edge of the coverage or its margin; empty if all legs are clear.
    std::optional<LegFault> firstFault(const std::vector<GeoPoint> &waypoints) const;

    /// Least distance on the ground in metres from the line to a blocking hazard, understated by the plane's stretch
    /// (0.03 % at 165 km from the frame's meridian); infinite if there is none.
    double leastClearanceM(const std::vector<GeoPoint> &waypoints) const;

    /// What the line crosses that does not block but that the navigator should know: bridges, overhead cables and
    /// regulated areas, whose rules are not judged yet, and objects that are cautions by their rule. Each once.
    std::vector<const HazardObject *> crossedCautions(const std::vector<GeoPoint> &waypoints) const;

private:
    const ChartArena &arena_;
    Projection metric_;               // the arena's frame where it has metres
    std::vector<Hazard> ownHazards_;  // in metres, where the arena's are not
    std::vector<Hazard> coverageEdge_;
    HazardIndex edge_;            // of coverageEdge_, in the arena's frame
    HazardIndex blocking_;        // in the arena's frame: what must not be touched
    HazardIndex blockingMetric_;  // in metres
    HazardIndex cautions_;        // in metres
    double largestRadiusM_ = 0.0;
    double scale_ = 1.0;  // metres of the plane to one on the ground, at most
};

}  // namespace seahex
