#include "seahex/geometry/SquareTraversal.h"

#include "geometry/WideInteger.h"

#include <utility>

namespace seahex
{

RowSpan touchedSpan(OffsetCoord a, OffsetCoord b, std::int64_t row)
{
    // As for hexagons, with centres at (2 column, 2 row) and corners at (+-1, +-1).
    static constexpr int corner[4][2] = {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
    if (a.row > b.row)
        std::swap(a, b);
    const Wide ax = 2 * Wide(a.column);
    const Wide dx = 2 * (Wide(b.column) - a.column);
    const Wide dy = 2 * (Wide(b.row) - a.row);
    const Wide up = 2 * (Wide(row) - a.row);
    // the centre of an end, or anything between the outlines in the rows between
    Wide west = dy == 0 ? std::min(ax, ax + dx) : row == b.row ? ax + dx : ax + std::max<Wide>(dx, 0) + 2;
    Wide east = dy == 0 ? std::max(ax, ax + dx) : row == b.row ? ax + dx : ax + std::min<Wide>(dx, 0) - 2;
    if (row == a.row && dy != 0)
        west = east = ax;
    for (const auto &c : corner)
    {
        const Wide t = up - c[1];
        if (dy == 0 || t < 0 || t > dy)
            continue;
        west = std::min(west, ax + c[0] - floorDivide(-dx * t, dy));
        east = std::max(east, ax + c[0] + floorDivide(dx * t, dy));
    }
    return {row, static_cast<std::int64_t>(-floorDivide(-west, 2)), static_cast<std::int64_t>(floorDivide(east, 2))};
}

}  // namespace seahex
