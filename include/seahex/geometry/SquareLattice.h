#pragma once

#include <seahex/geometry/Box.h>
#include <seahex/geometry/OffsetCoord.h>
#include <seahex/geometry/Point.h>

#include <array>
#include <cmath>
#include <cstdint>

namespace seahex
{

/// A rectangle of square cells in the plane (x east, y north): the baseline that hexagons are compared with.
///
/// The counterpart of HexLattice, with the same functions; a cell is its column and row. An immutable value.
class SquareLattice
{
public:
    using Cell = OffsetCoord;
    /// The cell at a column and row.
    static OffsetCoord cell(OffsetCoord offset) { return offset; }

    /// @param northWest  north-west corner of cell (0, 0), in the plane's unit
    /// @param pitch      centre to centre = edge of a cell; > 0
    /// @param columns, rows  > 0
    /// @throws std::domain_error if the pitch is not positive and finite, the origin not finite, or a count not
    /// positive
    SquareLattice(const Point &northWest, double pitch, std::int64_t columns, std::int64_t rows);

    /// A lattice whose closed cells cover every point of the box, with no column or row to spare but where the box ends
    /// on a cell's very edge.
    /// @throws std::domain_error as the constructor, or if it would need more than 2^40 cells
    static SquareLattice covering(const Box &box, double pitch);

    const Point &northWest() const { return northWest_; }
    double pitch() const { return pitch_; }
    std::int64_t columns() const { return columns_; }
    std::int64_t rows() const { return rows_; }
    std::int64_t cellCount() const { return columns_ * rows_; }
    /// The box that all closed cells of the rectangle fill.
    Box bounds() const;

    bool contains(OffsetCoord cell) const
    {
        return cell.row >= 0 && cell.row < rows_ && cell.column >= 0 && cell.column < columns_;
    }

    /// The cell that holds the point. On an edge or corner it is one of the cells that meet there, always the same one.
    /// Exact but for rounding: the point lies within 1e-9 times the larger coordinate of the cell returned.
    /// A point that is not a number or lies more than 2^60 cells away gets a cell about as far away, in no rectangle.
    OffsetCoord cellAt(const Point &p) const;

    Point centre(OffsetCoord cell) const
    {
        return {northWest_.x() + pitch_ * (0.5 + static_cast<double>(cell.column)),
                northWest_.y() - pitch_ * (0.5 + static_cast<double>(cell.row))};
    }

    /// The four corners, counter-clockwise from the north-west.
    std::array<Point, 4> corners(OffsetCoord cell) const;

    /// Distance from a point to the closed cell, 0 inside.
    double distance(const Point &p, OffsetCoord cell) const;

    /// The same cells at the same places.
    friend bool operator==(const SquareLattice &a, const SquareLattice &b)
    {
        return a.northWest_ == b.northWest_ && a.pitch_ == b.pitch_ && a.columns_ == b.columns_ && a.rows_ == b.rows_;
    }
    friend bool operator!=(const SquareLattice &a, const SquareLattice &b) { return !(a == b); }

private:
    Point northWest_;
    double pitch_;
    std::int64_t columns_;
    std::int64_t rows_;
};

}  // namespace seahex
