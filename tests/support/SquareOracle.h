#pragma once

#include "support/CellOracle.h"

#include <seahex/geometry/SquareLattice.h>

namespace seahex::test
{

using SquareOracle = CellOracle<SquareLattice>;

/// True if the segment between two centres touches the closed cell: exact, in integers of type Int, which must hold 20
/// times the square of the largest coordinate.
///
/// With lengths doubled corners are integers. Segment and cell are apart exactly if columns or rows tell them apart, or
/// all corners lie strictly on one side of the segment.
template <class Int>
bool touchesExactly(OffsetCoord a, OffsetCoord b, OffsetCoord cell)
{
    const Int ax = 2 * (Int(a.column) - Int(cell.column));
    const Int ay = 2 * (Int(a.row) - Int(cell.row));
    const Int bx = 2 * (Int(b.column) - Int(cell.column));
    const Int by = 2 * (Int(b.row) - Int(cell.row));
    const auto apart = [](const Int &atA, const Int &atB)
    {
        return (atA > 1 && atB > 1) || (atA < -1 && atB < -1);
    };
    if (apart(ax, bx) || apart(ay, by))
        return false;
    static constexpr int corners[4][2] = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
    bool left = false;
    bool right = false;
    for (const auto &corner : corners)
    {
        const Int side = (bx - ax) * (corner[1] - ay) - (by - ay) * (corner[0] - ax);
        left = left || side >= 0;
        right = right || side <= 0;
    }
    return left && right;
}

}  // namespace seahex::test
