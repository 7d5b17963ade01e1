#pragma once

#include <seahex/geometry/Shape.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace seahex
{

/// Products of whole coordinates exceed 64 bits (3.6e9 squared). The keyword keeps -Wpedantic quiet.
__extension__ typedef __int128 WideInteger;

/// A position on a cell's own grid: degrees times COMF.
struct GridPoint
{
    std::int64_t x;
    std::int64_t y;
};

/// The nearest point of the grid. Coordinates of a chart are whole but for rounding, so how halves go does not matter.
inline GridPoint onGrid(const Point &degrees, double gridUnitsPerDegree)
{
    const auto nearest = [gridUnitsPerDegree](double value)
    {
        const double units = value * gridUnitsPerDegree;
        return static_cast<std::int64_t>(units + (units < 0.0 ? -0.5 : 0.5));
    };
    return {nearest(degrees.x()), nearest(degrees.y())};
}

/// Positive for a ring that runs counter-clockwise.
inline WideInteger twiceSignedArea(const std::vector<GridPoint> &ring)
{
    WideInteger sum = 0;
    for (std::size_t i = 1; i < ring.size(); ++i)
        sum += WideInteger(ring[i - 1].x) * ring[i].y - WideInteger(ring[i].x) * ring[i - 1].y;
    return sum;
}

}  // namespace seahex
