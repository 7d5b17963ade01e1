#pragma once

#include <seahex/geometry/Box.h>
#include <seahex/geometry/Point.h>

#include <cstdint>

namespace seahex
{

/// The nodes of a regular grid in the plane: columns from west to east, rows from south to north, and between them
/// rectangular cells, one fewer each way. An immutable value.
class NodeGrid
{
public:
    /// @param southWest  node (0, 0)
    /// @param spacing    from a column to the next and from a row to the next
    /// @throws std::domain_error for fewer than two columns or rows, a spacing that is not positive, numbers that are
    ///         not finite, or nodes so close together that doubles can't tell them apart
    NodeGrid(const Point &southWest, const Point &spacing, std::int64_t columns, std::int64_t rows);

    const Point &southWest() const { return southWest_; }
    const Point &spacing() const { return spacing_; }
    std::int64_t columns() const { return columns_; }
    std::int64_t rows() const { return rows_; }
    std::int64_t nodeCount() const { return columns_ * rows_; }

    /// From the first node to the last one.
    const Box &bounds() const { return bounds_; }

    Point node(std::int64_t column, std::int64_t row) const
    {
        return southWest_ + Point(static_cast<double>(column) * spacing_.x(), static_cast<double>(row) * spacing_.y());
    }

    /// A point of the bounds in steps from node (0, 0): x columns, y rows. Others are moved to the nearest on the
    /// bounds.
    Point steps(const Point &p) const
    {
        const Point steps = (p - southWest_).cwiseQuotient(spacing_);
        return steps.cwiseMax(Point::Zero()).cwiseMin(lastSteps_);
    }

private:
    Point southWest_;
    Point spacing_;
    std::int64_t columns_;
    std::int64_t rows_;
    Point lastSteps_;
    Box bounds_;
};

}  // namespace seahex
