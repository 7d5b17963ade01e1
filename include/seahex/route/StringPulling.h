#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace seahex
{

// Pulling a string of points taut, in the plane or in space; see pullString() of RouteSmoother for what comes of it.

/// Sum of the distances from each point to the next.
template <class Vector>
double lengthOf(const std::vector<Vector> &points)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        sum += (points[i] - points[i - 1]).norm();
    return sum;
}

/// From each point on to the farthest one that can be seen: doubling strides, then halving them. Sight is not monotone,
/// so this may stop short of the very farthest; another round looks from other points. Asks isValid(from, to), in the
/// direction of the points, but not for the legs between neighbours, which are taken to be valid.
template <class Vector, class IsValid>
std::vector<Vector> pullOnce(const std::vector<Vector> &points, IsValid &&isValid)
{
    std::vector<Vector> kept = {points.front()};
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

/// The shorter of what is pulled from the first point and from the last.
template <class Vector, class IsValid>
std::vector<Vector> pullBothWays(const std::vector<Vector> &points, IsValid &&isValid)
{
    const auto isValidBackwards = [&](const Vector &from, const Vector &to)
    {
        return isValid(to, from);
    };
    std::vector<Vector> forward = pullOnce(points, isValid);
    std::vector<Vector> backward = pullOnce(std::vector<Vector>(points.rbegin(), points.rend()), isValidBackwards);
    std::reverse(backward.begin(), backward.end());
    return lengthOf(backward) < lengthOf(forward) ? backward : forward;
}

/// Legs divided into equal pieces no shorter than `spacing`.
template <class Vector>
std::vector<Vector> divided(const std::vector<Vector> &points, double spacing)
{
    std::vector<Vector> result = {points.front()};
    for (std::size_t i = 1; i < points.size(); ++i)
    {
        const Vector step = points[i] - points[i - 1];
        const auto pieces = static_cast<int>(std::max(1.0, std::floor(step.norm() / spacing)));
        for (int k = 1; k < pieces; ++k)
            result.push_back(points[i - 1] + (static_cast<double>(k) / pieces) * step);
        result.push_back(points[i]);
    }
    return result;
}

/// Pulls the points, divides the legs and pulls again, until a round gains less than 1e-5 of the length. First and last
/// point stay; the result is never longer. Legs are parts of given ones or were found valid.
/// @param spacing  legs are divided into pieces no shorter than this; > 0
template <class Vector, class IsValid>
std::vector<Vector> pulledTaut(const std::vector<Vector> &points, IsValid &&isValid, double spacing)
{
    constexpr int mostRounds = 12;
    constexpr double mostPieces = 400.0;
    constexpr double leastGain = 1e-5;
    constexpr double rounding = 1e-12;
    if (points.size() < 3)
        return points;
    std::vector<Vector> best = pullBothWays(points, isValid);
    double length = lengthOf(best);
    for (int round = 0; round < mostRounds && best.size() > 2; ++round)
    {
        std::vector<Vector> pulled = pullBothWays(divided(best, std::max(spacing, length / mostPieces)), isValid);
        const double shorter = lengthOf(pulled);
        const double gain = length - shorter;
        if (gain <= 0.0)
            break;
        best = std::move(pulled);
        length = shorter;
        if (gain < leastGain * length)
            break;
    }
    // a chord is never longer than what it replaces, but for the rounding of the sums
    return length <= lengthOf(points) * (1.0 + rounding) ? best : points;
}

}  // namespace seahex
