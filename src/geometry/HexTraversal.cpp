#include "seahex/geometry/HexTraversal.h"

#include "geometry/WideInteger.h"

namespace seahex
{

RowSpan touchedSpan(HexCoord a, HexCoord b, std::int64_t row)
{
    // An affine image of the plane in which all is integer: centres at (2 q + s, 3 s), corners at (0, +-2), (+-1, +-1).
    // Touching does not change under an affine map. The span is that of segment + hexagon, whose outline runs along the
    // six copies of the segment that are shifted by a corner.
    static constexpr int corner[6][2] = {{0, 2}, {0, -2}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
    if (a.s > b.s)
        std::swap(a, b);
    const Wide ax = 2 * Wide(a.q) + a.s;
    const Wide dx = 2 * Wide(b.q) + b.s - ax;
    const Wide dy = 3 * (Wide(b.s) - a.s);
    const Wide up = 3 * (Wide(row) - a.s);
    Wide west;
    Wide east;
    if (dy == 0)
    {
        west = std::min(ax, ax + dx);
        east = std::max(ax, ax + dx);
    }
    else
    {
        west = row == a.s ? ax : row == b.s ? ax + dx : ax + std::max<Wide>(dx, 0) + 2 + (dx < 0 ? -dx : 0);
        east = row == a.s ? ax : row == b.s ? ax + dx : ax + std::min<Wide>(dx, 0) - 2 - (dx > 0 ? dx : 0);
        for (const auto &c : corner)
        {
            const Wide t = up - c[1];
            if (t < 0 || t > dy)
                continue;
            west = std::min(west, ax + c[0] - floorDivide(-dx * t, dy));
            east = std::max(east, ax + c[0] + floorDivide(dx * t, dy));
        }
    }
    // a centre's x has the parity of its row
    const Wide firstQ = -floorDivide(row - west, 2);
    const Wide lastQ = floorDivide(east - row, 2);
    const std::int64_t shift = (row + (row & 1)) / 2;
    return {row, static_cast<std::int64_t>(firstQ) + shift, static_cast<std::int64_t>(lastQ) + shift};
}

}  // namespace seahex
