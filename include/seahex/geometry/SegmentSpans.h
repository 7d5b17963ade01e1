#pragma once

#include <seahex/geometry/Lattice.h>
#include <seahex/geometry/Point.h>

#include <cstdint>

namespace seahex
{

// Which closed cells a straight segment touches. A cell belongs to the set as soon as the segment meets its edge or a
// corner. The cells whose distance to a segment is at most r have their centres in one convex set: segment + cell +
// disc of radius r. A row of centres cuts that set in one interval, so the answer is a span of columns for each row,
// and no cell needs to be tested by itself.

/// How exact questions about a segment of arbitrary doubles are: 1e-9 times the largest of the coordinates of a, b and
/// the lattice's origin, and of the pitch.
double traversalTolerance(const Lattice &lattice, const Point &a, const Point &b);

/// The cells of one row that lie within `radius` of the segment, as an interval of columns.
struct RowSpan
{
    std::int64_t row;
    std::int64_t firstColumn;
    std::int64_t lastColumn;
};

/// Enumerates the row spans of all cells of the (unbounded) lattice within a distance of a segment.
///
/// Guarantee: every closed cell whose exact distance to the segment is <= radius is in a span, and no cell farther than
/// radius + tolerance() is. The spans are the same, and come in the same order, for (a, b) and (b, a).
class SegmentSpans
{
public:
    /// @param radius  >= 0, in the plane's unit
    /// A position or radius that is not finite has no rows.
    SegmentSpans(const Lattice &lattice, const Point &a, const Point &b, double radius = 0.0);

    /// traversalTolerance() of the segment.
    double tolerance() const { return tolerance_; }

    std::int64_t firstRow() const { return firstRow_; }
    std::int64_t lastRow() const { return lastRow_; }

    /// The span of a row; empty (lastColumn < firstColumn) where the row has no such cell.
    RowSpan span(std::int64_t row) const;

private:
    /// Half the width of cell + disc at a distance of `offset` above or below its centre; negative beyond its ends.
    double halfWidth(double offset) const;

    bool isHex_;
    double pitch_;
    double halfHeight_;  // of a cell
    double firstY_;      // of the centres of row 0, southward from the lattice's origin
    double rowStep_;
    double tolerance_;
    double reach_;  // radius + half the tolerance
    Point low_;     // the segment's ends relative to the lattice's origin, x east and y south, the northern one first
    Point high_;
    Point support_;  // the point of cell + disc that goes farthest across the segment
    std::int64_t firstRow_ = 0;
    std::int64_t lastRow_ = -1;
};

/// Calls visit(cell) for every cell that the closed segment from a to b touches, a superset by at most the tolerance of
/// SegmentSpans, until visit returns false. The same cells in the same order for (a, b) and (b, a).
/// @return false if visit returned false
template <class Visit>
bool forEachTouchedCell(const Lattice &lattice, const Point &a, const Point &b, Visit &&visit)
{
    const SegmentSpans spans(lattice, a, b);
    for (std::int64_t row = spans.firstRow(); row <= spans.lastRow(); ++row)
    {
        const RowSpan span = spans.span(row);
        for (std::int64_t column = span.firstColumn; column <= span.lastColumn; ++column)
            if (!visit(OffsetCoord{column, row}))
                return false;
    }
    return true;
}

}  // namespace seahex
