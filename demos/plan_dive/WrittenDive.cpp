#include "WrittenDive.h"

#include <algorithm>
#include <cmath>

namespace plan_dive
{
namespace
{

using seahex::GeoPoint;
using seahex::GeoRoute;
using seahex::horizontal;
using seahex::Point;
using seahex::Point3;

double writtenDepth(double depthM)
{
    constexpr double perMetre = 1000.0;
    const double nearest = std::round(depthM * perMetre) / perMetre;
    return std::abs(nearest - depthM) < 1e-9 ? nearest : std::floor(depthM * perMetre) / perMetre;
}

/// Is a leg steeper than can come of rounding its ends (a centimetre over ground, a millimetre of depth each)?
bool isTooSteep(double lengthM, double descentM, double climb)
{
    constexpr double roundedM = 0.02;
    constexpr double roundedDepthM = 0.002;
    return climb > 0.0 && std::abs(descentM) > climb * (lengthM + roundedM) + roundedDepthM;
}

/// One leg's positions but the first.
void appendLeg(GeoRoute &written, const Point3 &a, const Point3 &b, const Seabed &seabed, const GeoPoint &to)
{
    const GeoPoint from = written.waypoints.back();
    const Point along = horizontal(b) - horizontal(a);
    const GeoRoute leg = toGeoRoute(seahex::Route({horizontal(a), horizontal(b)}), seabed.projection, from, to);
    for (std::size_t i = 1; i < leg.waypoints.size(); ++i)
    {
        const bool isLast = i + 1 == leg.waypoints.size();
        const Point so = seabed.projection.forward(leg.waypoints[i]) - horizontal(a);
        const double t = isLast ? 1.0 : std::clamp(so.dot(along) / along.squaredNorm(), 0.0, 1.0);
        written.waypoints.push_back(leg.waypoints[i]);
        written.depthsM.push_back(writtenDepth(a.z() + t * (b.z() - a.z())));
    }
}

}  // namespace

GeoRoute writtenDive(const std::vector<Point3> &dive, const Seabed &seabed, const DivePosition &from,
                     const DivePosition &to)
{
    GeoRoute written{{from.place}, {writtenDepth(from.depthM)}};
    for (std::size_t i = 1; i < dive.size(); ++i)
    {
        const bool isLast = i + 1 == dive.size();
        const GeoPoint next = isLast ? to.place : writtenPosition(seabed.projection.inverse(horizontal(dive[i])));
        appendLeg(written, dive[i - 1], dive[i], seabed, next);
    }
    return written;
}

WrittenMeasures measureWritten(const GeoRoute &written, const Seabed &seabed, const seahex::DiveArena &arena,
                               double climb)
{
    std::vector<Point3> points;
    for (std::size_t i = 0; i < written.waypoints.size(); ++i)
    {
        const Point p = seabed.projection.forward(writtenPosition(written.waypoints[i]));
        points.emplace_back(p.x(), p.y(), written.depthsM[i]);
    }
    WrittenMeasures measures;
    measures.leastWaterM = std::numeric_limits<double>::infinity();
    const auto [least, greatest] = std::minmax_element(written.depthsM.begin(), written.depthsM.end());
    measures.leastDepthM = *least;
    measures.greatestDepthM = *greatest;
    for (std::size_t i = 1; i < points.size(); ++i)
    {
        const double overGroundM = rhumbLeg(written.waypoints[i - 1], written.waypoints[i]).lengthM;
        const double descentM = points[i].z() - points[i - 1].z();
        measures.lengthM += std::hypot(overGroundM, descentM);
        if (descentM != 0.0)
            measures.steepest = std::max(measures.steepest, std::abs(descentM) / overGroundM);
        measures.leastWaterM = std::min(measures.leastWaterM, seabed.depths->leastWaterBelow(points[i - 1], points[i]));
        if (!measures.faultyLeg &&
            (!arena.isFree(points[i - 1], points[i]) || isTooSteep(overGroundM, descentM, climb)))
            measures.faultyLeg = i;
    }
    return measures;
}

}  // namespace plan_dive
