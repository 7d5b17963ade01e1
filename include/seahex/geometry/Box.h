#pragma once

#include <seahex/geometry/Point.h>

namespace seahex
{

/// Axis-parallel box in the plane.
struct Box
{
    Point min = Point::Zero();
    Point max = Point::Zero();

    bool contains(const Point &p) const
    {
        return p.x() >= min.x() && p.x() <= max.x() && p.y() >= min.y() && p.y() <= max.y();
    }
};

}  // namespace seahex
