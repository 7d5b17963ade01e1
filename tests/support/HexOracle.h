#pragma once

#include "support/CellOracle.h"

#include <seahex/geometry/HexLattice.h>

namespace seahex::test
{

using HexOracle = CellOracle<HexLattice>;

/// True if the segment between two centres touches the closed cell: exact, in integers of type Int, which must hold 20
/// times the square of the largest coordinate.
///
/// In cube coordinates times 3 corners are integers: a corner lies midway between three centres. A cell is where the
/// three differences q - r, r - s, s - q are at most 3 in size. Segment and cell are apart exactly if one of these
/// differences tells them apart, or all corners lie strictly on one side of the segment.
template <class Int>
bool touchesExactly(HexCoord a, HexCoord b, HexCoord cell)
{
    const Int aq = 3 * (Int(a.q) - Int(cell.q));
    const Int as = 3 * (Int(a.s) - Int(cell.s));
    const Int bq = 3 * (Int(b.q) - Int(cell.q));
    const Int bs = 3 * (Int(b.s) - Int(cell.s));
    const auto apart = [](const Int &atA, const Int &atB)
    {
        return (atA > 3 && atB > 3) || (atA < -3 && atB < -3);
    };
    if (apart(2 * aq + as, 2 * bq + bs) || apart(-aq - 2 * as, -bq - 2 * bs) || apart(as - aq, bs - bq))
        return false;
    static constexpr int corners[6][2] = {{2, -1}, {1, -2}, {-1, -1}, {-2, 1}, {-1, 2}, {1, 1}};
    bool left = false;
    bool right = false;
    for (const auto &corner : corners)
    {
        const Int side = (bq - aq) * (corner[1] - as) - (bs - as) * (corner[0] - aq);
        left = left || side >= 0;
        right = right || side <= 0;
    }
    return left && right;
}

}  // namespace seahex::test
