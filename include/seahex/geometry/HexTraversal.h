#pragma once

#include <seahex/geometry/HexCoord.h>
#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/Point.h>
#include <seahex/geometry/SegmentSpans.h>

#include <algorithm>

namespace seahex
{

/// Calls visit(cell) for every cell that the closed segment from a to b touches, until visit returns false; see
/// SegmentSpans.
/// @return false if visit returned false
template <class Visit>
bool forEachTouchedCell(const HexLattice &lattice, const Point &a, const Point &b, Visit &&visit)
{
    return forEachTouchedCell(Lattice(lattice), a, b, [&visit](OffsetCoord cell) { return visit(toCube(cell)); });
}

/// The columns of one row that the segment between two cell centres touches, exactly, in integers; the row must lie
/// between the two. |coordinates| up to 2^60.
RowSpan touchedSpan(HexCoord a, HexCoord b, std::int64_t row);

/// Calls visit(cell) for every closed cell that the segment between two centres touches, exactly, until it returns
/// false.
/// @return false if visit returned false
template <class Visit>
bool forEachTouchedCell(HexCoord a, HexCoord b, Visit &&visit)
{
    for (std::int64_t row = std::min(a.s, b.s); row <= std::max(a.s, b.s); ++row)
    {
        const RowSpan span = touchedSpan(a, b, row);
        for (std::int64_t column = span.firstColumn; column <= span.lastColumn; ++column)
            if (!visit(toCube({column, row})))
                return false;
    }
    return true;
}

}  // namespace seahex
