#pragma once

#include <seahex/geometry/Shape.h>

#include <cmath>
#include <cstdint>

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

inline GridPoint onGrid(const Point &degrees, double gridUnitsPerDegree)
{
    return {std::llround(degrees.x() * gridUnitsPerDegree), std::llround(degrees.y() * gridUnitsPerDegree)};
}

/// Positive for a ring that runs counter-clockwise.
inline WideInteger twiceSignedArea(const Ring &ring, double gridUnitsPerDegree)
{
    WideInteger sum = 0;
    for (std::size_t i = 1; i < ring.size(); ++i)
    {
        const GridPoint a = onGrid(ring[i - 1], gridUnitsPerDegree);
        const GridPoint b = onGrid(ring[i], gridUnitsPerDegree);
        sum += WideInteger(a.x) * b.y - WideInteger(b.x) * a.y;
    }
    return sum;
}

}  // namespace seahex
