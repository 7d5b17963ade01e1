#pragma once

#include <seahex/geometry/Point.h>

#include <algorithm>

namespace seahex
{

/// Distance from a point to the closed segment from a to b, which may have no length.
inline double distanceToSegment(const Point &p, const Point &a, const Point &b)
{
    const Point d = b - a;
    const double squared = d.squaredNorm();
    const double t = squared > 0.0 ? std::clamp((p - a).dot(d) / squared, 0.0, 1.0) : 0.0;
    return (p - a - t * d).norm();
}

}  // namespace seahex
