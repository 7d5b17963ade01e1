#include "SpaceTrack.h"

#include <Eigen/Geometry>

#include <cmath>
#include <optional>

namespace demos
{

TrackMeasures measureTrack(const std::vector<seahex::Point3> &points)
{
    constexpr double leastTurnRad = 1e-6;
    TrackMeasures measures;
    std::optional<seahex::Point3> before;
    for (std::size_t i = 1; i < points.size(); ++i)
    {
        const seahex::Point3 leg = points[i] - points[i - 1];
        if (leg.isZero(0.0))
            continue;
        measures.length += leg.norm();
        if (before)
        {
            const double turn = std::atan2(before->cross(leg).norm(), before->dot(leg));
            measures.courseChanges += turn > leastTurnRad ? 1 : 0;
            measures.courseAngleDeg += turn > leastTurnRad ? turn * 180.0 / M_PI : 0.0;
        }
        before = leg;
    }
    return measures;
}

}  // namespace demos
