#include "seahex/route/CornerOffset.h"

#include "seahex/geometry/HexTraversal.h"
#include "seahex/geometry/SegmentDistance.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace seahex
{
namespace
{

/// A waypoint to be: a corner, and where it goes; for first and last waypoint both are the same.
struct Bend
{
    Point corner;
    Point moved;
};

/// The corner, moved away from the blocked cells that meet there.
Bend bendAt(const HexOccupancy &occupancy, const Point &corner, double offset)
{
    const HexLattice &lattice = occupancy.lattice();
    Point outward = Point::Zero();
    const HexCoord cell = lattice.cellAt(corner);
    for (const HexCoord step : {HexCoord{0, 0}, HexCoord{1, 0}, HexCoord{-1, 0}, HexCoord{0, 1}, HexCoord{0, -1},
                                HexCoord{1, -1}, HexCoord{-1, 1}})
    {
        const Point away = corner - lattice.centre(cell + step);
        if (away.norm() < 1.1 * lattice.side() && occupancy.isBlocked(cell + step))
            outward += away;
    }
    return {corner, outward.isZero() ? corner : Point(corner + offset * outward.normalized())};
}

/// The corners by which blocked cells touch the leg: of each cell the nearest.
std::vector<Point> touchedCorners(const HexOccupancy &occupancy, const Point &from, const Point &to)
{
    std::vector<Point> touched;
    forEachTouchedCell(occupancy.lattice(), from, to,
                       [&](HexCoord cell)
                       {
                           if (occupancy.isFree(cell))
                               return true;
                           const std::array<Point, 6> corners = occupancy.lattice().corners(cell);
                           touched.push_back(*std::min_element(corners.begin(), corners.end(),
                                                               [&](const Point &a, const Point &b) {
                                                                   return distanceToSegment(a, from, to) <
                                                                          distanceToSegment(b, from, to);
                                                               }));
                           return true;
                       });
    const Point along = to - from;
    std::sort(touched.begin(), touched.end(),
              [&along](const Point &a, const Point &b) { return along.dot(a) < along.dot(b); });
    return touched;
}

}  // namespace

double cornerOffset(const HexOccupancy &occupancy, const Route &taut)
{
    constexpr double ofPitch = 1e-6;
    double tolerance = 0.0;
    for (const Point &p : taut.waypoints())
        tolerance = std::max(tolerance, traversalTolerance(occupancy.lattice(), p, p));
    return std::max(ofPitch * occupancy.lattice().pitch(), 4.0 * tolerance);
}

std::optional<Route> offsetFromCorners(const Route &taut, const HexOccupancy &occupancy)
{
    const std::vector<Point> &waypoints = taut.waypoints();
    const double offset = cornerOffset(occupancy, taut);
    const double same = 0.1 * occupancy.lattice().pitch();
    std::vector<Bend> bends;
    for (std::size_t i = 0; i < waypoints.size(); ++i)
        bends.push_back(i == 0 || i + 1 == waypoints.size() ? Bend{waypoints[i], waypoints[i]}
                                                            : bendAt(occupancy, waypoints[i], offset));
    // A leg that touches more corners is bent there too, until none does. Each corner comes once, so this ends.
    for (std::size_t i = 1; i < bends.size();)
    {
        const std::vector<Point> touched = touchedCorners(occupancy, bends[i - 1].moved, bends[i].moved);
        std::vector<Bend> more;
        for (const Point &corner : touched)
        {
            const bool isKnown =
                std::any_of(bends.begin(), bends.end(),
                            [&](const Bend &bend)
                            { return bend.corner != bend.moved && (bend.corner - corner).norm() < same; }) ||
                std::any_of(more.begin(), more.end(),
                            [&](const Bend &bend) { return (bend.corner - corner).norm() < same; });
            if (!isKnown)
                more.push_back(bendAt(occupancy, corner, offset));
        }
        if (!touched.empty() && more.empty())
            return std::nullopt;
        bends.insert(bends.begin() + static_cast<std::ptrdiff_t>(i), more.begin(), more.end());
        if (more.empty())
            ++i;
    }
    std::vector<Point> points;
    for (const Bend &bend : bends)
        points.push_back(bend.moved);
    return Route(std::move(points));
}

}  // namespace seahex
