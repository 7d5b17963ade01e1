#include "seahex/route/RouteSmoother.h"

#include "seahex/world/SegmentValidity.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace seahex
{
namespace
{

using Points = std::vector<Point>;

constexpr int mostRounds = 12;
constexpr double mostPieces = 400.0;
constexpr double leastGain = 1e-5;
constexpr double rounding = 1e-12;

/// From each waypoint on to the farthest one that can be seen: doubling strides, then halving them. Sight is not
/// monotone, so this may stop short of the very farthest; the next round looks from other points.
Points pullOnce(const Points &points, const SegmentPredicate &isValid)
{
    Points kept = {points.front()};
    std::size_t from = 0;
    const std::size_t last = points.size() - 1;
    while (from < last)
    {
        std::size_t seen = from + 1;
        std::size_t stride = 1;
        while (seen < last)
        {
            const std::size_t next = std::min(seen + stride, last);
            if (!isValid(points[from], points[next]))
                break;
            seen = next;
            stride *= 2;
        }
        for (; stride >= 1; stride /= 2)
            if (seen + stride <= last && isValid(points[from], points[seen + stride]))
                seen += stride;
        kept.push_back(points[seen]);
        from = seen;
    }
    return kept;
}

Points pullBothWays(const Points &points, const SegmentPredicate &isValid)
{
    Points forward = pullOnce(points, isValid);
    Points backward = pullOnce(Points(points.rbegin(), points.rend()), isValid);
    std::reverse(backward.begin(), backward.end());
    return Route(backward).length() < Route(forward).length() ? backward : forward;
}

Points divided(const Points &points, double spacing)
{
    Points result = {points.front()};
    for (std::size_t i = 1; i < points.size(); ++i)
    {
        const Point step = points[i] - points[i - 1];
        const auto pieces = static_cast<int>(std::max(1.0, std::floor(step.norm() / spacing)));
        for (int k = 1; k < pieces; ++k)
            result.push_back(points[i - 1] + (static_cast<double>(k) / pieces) * step);
        result.push_back(points[i]);
    }
    return result;
}

}  // namespace

Route pullString(const Route &route, const SegmentPredicate &isValid, double spacing)
{
    if (route.legCount() < 2)
        return route;
    Points best = pullBothWays(route.waypoints(), isValid);
    double length = Route(best).length();
    for (int round = 0; round < mostRounds && best.size() > 2; ++round)
    {
        const Points pulled = pullBothWays(divided(best, std::max(spacing, length / mostPieces)), isValid);
        const double shorter = Route(pulled).length();
        const double gain = length - shorter;
        if (gain <= 0.0)
            break;
        best = pulled;
        length = shorter;
        if (gain < leastGain * length)
            break;
    }
    // a chord is never longer than what it replaces, but for the rounding of the sums
    return length <= route.length() * (1.0 + rounding) ? Route(std::move(best)) : route;
}

Route pullString(const Route &route, const Occupancy &occupancy)
{
    return pullString(
        route, [&occupancy](const Point &a, const Point &b) { return isFree(occupancy, a, b); },
        0.5 * occupancy.lattice().pitch());
}

}  // namespace seahex
