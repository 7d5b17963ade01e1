#pragma once

#include <seahex/geometry/NodeGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace seahex
{

/// A cell of a grid, by its south-west node, and the part of a segment from a to b that lies in it: a + t (b - a) for
/// enter <= t <= leave; leave < enter where the segment passes it by, but no farther than gridTouchSteps.
struct GridPassage
{
    std::int64_t column;
    std::int64_t row;
    double enter;
    double leave;
};

/// How far beyond a cell's edge a segment still touches it, in steps of the grid: more than what rounding can do to a
/// position within 1e5 steps of the first node.
constexpr double gridTouchSteps = 1e-9;

namespace detail
{

/// The part of [0, 1] in which from + t * by lies in an interval; empty: leave < enter. Intervals that share an end
/// have parts that share it too, bit for bit, so that nothing is lost between them.
struct Part
{
    double enter = 0.0;
    double leave = 1.0;

    bool isEmpty() const { return leave < enter; }

    Part within(double from, double by, double low, double high) const
    {
        if (by == 0.0)
            return from >= low && from <= high ? *this : Part{1.0, 0.0};
        const double one = (low - from) / by;
        const double other = (high - from) / by;
        return {std::max(enter, std::min(one, other)), std::min(leave, std::max(one, other))};
    }

    /// The same for the interval from low to low + 1, widened by the tolerance.
    Part near(double from, double by, double low) const
    {
        return within(from, by, low - gridTouchSteps, low + 1.0 + gridTouchSteps);
    }
};

/// First and last of `cells` intervals [i, i + 1] that touch [low, high], give or take the tolerance.
struct CellRange
{
    CellRange(double low, double high, std::int64_t cells)
        : first(std::max<std::int64_t>(static_cast<std::int64_t>(std::ceil(low - gridTouchSteps)) - 1, 0)),
          last(std::min<std::int64_t>(static_cast<std::int64_t>(std::floor(high + gridTouchSteps)), cells - 1))
    {
    }

    std::int64_t first;
    std::int64_t last;
};

}  // namespace detail

/// Calls visit(GridPassage) for every closed cell that the segment from a to b touches, row by row from the south,
/// until visit returns false. A cell counts as touched up to gridTouchSteps beyond its edges, and together the passages
/// cover the segment. Both ends must lie within the grid's bounds.
///
/// Time: linear in the cells touched. No allocation.
/// @return false if visit returned false
template <class Visit>
bool forEachPassage(const NodeGrid &grid, const Point &a, const Point &b, Visit &&visit)
{
    const Point from = grid.steps(a);
    const Point by = grid.steps(b) - from;
    const Point to = from + by;
    const detail::CellRange rows(std::min(from.y(), to.y()), std::max(from.y(), to.y()), grid.rows() - 1);
    for (std::int64_t row = rows.first; row <= rows.last; ++row)
    {
        const auto south = static_cast<double>(row);
        const detail::Part nearRow = detail::Part().near(from.y(), by.y(), south);
        if (nearRow.isEmpty())
            continue;
        const detail::Part inRow = detail::Part().within(from.y(), by.y(), south, south + 1.0);
        const double one = from.x() + nearRow.enter * by.x();
        const double other = from.x() + nearRow.leave * by.x();
        const detail::CellRange columns(std::min(one, other), std::max(one, other), grid.columns() - 1);
        for (std::int64_t column = columns.first; column <= columns.last; ++column)
        {
            const auto west = static_cast<double>(column);
            if (nearRow.near(from.x(), by.x(), west).isEmpty())
                continue;
            const detail::Part in = inRow.within(from.x(), by.x(), west, west + 1.0);
            if (!visit(GridPassage{column, row, in.enter, in.leave}))
                return false;
        }
    }
    return true;
}

}  // namespace seahex
