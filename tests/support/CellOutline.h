#pragma once

#include <seahex/geometry/Shape.h>

namespace seahex::test
{

/// A cell as the polygon of its corners.
template <class LatticeType>
Polygon outline(const LatticeType &lattice, typename LatticeType::Cell cell)
{
    Polygon polygon;
    for (const Point &corner : lattice.corners(cell))
        polygon.outer().push_back(corner);
    polygon.outer().push_back(polygon.outer().front());
    return polygon;
}

}  // namespace seahex::test
