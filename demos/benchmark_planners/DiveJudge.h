#pragma once

#include <seahex/geometry/Point3.h>
#include <seahex/world/Bathymetry.h>
#include <seahex/world/DiveArena.h>

#include <limits>
#include <vector>

namespace benchmark_planners
{

/// What a look at a dive saw.
struct DiveVerdict
{
    bool isSafe = true;
    double leastWaterM = std::numeric_limits<double>::infinity();  ///< between the dive and the seabed straight below
};

/// Looks at dives by sampling: every leg at a tenth of the seabed's cells, and its ends. Each sample must lie over the
/// nodes, with known seabed around it, below the ceiling, above the greatest depth, and with the clearance below it.
///
/// The surface is worked out here, from the nodes, and not by the code that planners ask (Bathymetry, DiveArena), which
/// looks at whole legs at once: a fault of either shows as a difference. Doubles' rounding is allowed for with a
/// micrometre, no more.
class DiveJudge
{
public:
    DiveJudge(const seahex::Bathymetry &seabed, const seahex::DiveLimits &limits) : seabed_(seabed), limits_(limits) {}

    DiveVerdict judge(const std::vector<seahex::Point3> &dive) const;

private:
    double seabedAt(double x, double y) const;
    void look(const seahex::Point3 &p, DiveVerdict &verdict) const;

    const seahex::Bathymetry &seabed_;
    seahex::DiveLimits limits_;
};

}  // namespace benchmark_planners
