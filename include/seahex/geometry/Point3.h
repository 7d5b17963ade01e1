#pragma once

#include <seahex/geometry/Point.h>

namespace seahex
{

/// A position in the water: x to the east, y to the north, z down from the datum of depths; metres.
using Point3 = Eigen::Vector3d;

/// Where it lies on the chart.
inline Point horizontal(const Point3 &p)
{
    return p.head<2>();
}

}  // namespace seahex
