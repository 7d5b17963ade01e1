#pragma once

#include <seahex/geometry/OffsetCoord.h>
#include <seahex/geometry/Point.h>
#include <seahex/geometry/SegmentSpans.h>

#include <algorithm>

namespace seahex
{

/// The columns of one row of squares that the segment between two centres touches, exactly, in integers; the row must
/// lie between the two. |coordinates| up to 2^60.
RowSpan touchedSpan(OffsetCoord a, OffsetCoord b, std::int64_t row);

/// Calls visit(cell) for every closed square that the segment between two centres touches, exactly, until it returns
/// false.
/// @return false if visit returned false
template <class Visit>
bool forEachTouchedCell(OffsetCoord a, OffsetCoord b, Visit &&visit)
{
    for (std::int64_t row = std::min(a.row, b.row); row <= std::max(a.row, b.row); ++row)
    {
        const RowSpan span = touchedSpan(a, b, row);
        for (std::int64_t column = span.firstColumn; column <= span.lastColumn; ++column)
            if (!visit(OffsetCoord{column, row}))
                return false;
    }
    return true;
}

}  // namespace seahex
