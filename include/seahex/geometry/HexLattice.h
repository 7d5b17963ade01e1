#pragma once

#include <seahex/geometry/Box.h>
#include <seahex/geometry/HexCoord.h>
#include <seahex/geometry/Point.h>

#include <array>
#include <cstdint>

namespace seahex
{

/// A rectangle of hexagonal cells in the plane (x east, y north).
///
/// The lattice is unbounded as far as geometry goes (`cellAt`, `centre`, `corners` work for every cell); `contains`
/// tells which cells belong to the rectangle of `columns` x `rows`. An immutable value.
class HexLattice
{
public:
    using Cell = HexCoord;
    /// The cell at a column and row.
    static HexCoord cell(OffsetCoord offset) { return toCube(offset); }

    /// @param northWest  north-west corner: the westernmost point of odd rows (x) and the northern tip of row 0 (y)
    /// @param pitch      centre to centre = cell width, in the plane's unit; > 0
    /// @param columns, rows  > 0
    /// @throws std::domain_error if the pitch is not positive and finite, the origin not finite, or a count not
    /// positive
    HexLattice(const Point &northWest, double pitch, std::int64_t columns, std::int64_t rows);

    /// A lattice whose closed cells cover every point of the box, with no column or row to spare but where the box ends
    /// on a cell's very edge.
    /// @throws std::domain_error as the constructor, or if it would need more than 2^40 cells
    static HexLattice covering(const Box &box, double pitch);

    const Point &northWest() const { return northWest_; }
    double pitch() const { return pitch_; }
    /// Edge length of a cell, pitch / sqrt(3).
    double side() const { return side_; }
    std::int64_t columns() const { return columns_; }
    std::int64_t rows() const { return rows_; }
    std::int64_t cellCount() const { return columns_ * rows_; }
    /// The box that all closed cells of the rectangle fill, its notched east and west edges included.
    Box bounds() const;

    bool contains(HexCoord cell) const
    {
        const OffsetCoord o = toOffset(cell);
        return o.row >= 0 && o.row < rows_ && o.column >= 0 && o.column < columns_;
    }

    /// The cell that holds the point. On an edge or corner it is one of the cells that meet there, always the same one.
    /// Exact but for rounding: the point lies within 1e-9 times the larger coordinate of the cell returned.
    /// A point that is not a number or lies more than 2^60 cells away gets a cell about as far away, in no rectangle.
    HexCoord cellAt(const Point &p) const;

    Point centre(HexCoord cell) const
    {
        return {northWest_.x() + pitch_ * (1.0 + static_cast<double>(cell.q) + 0.5 * static_cast<double>(cell.s)),
                northWest_.y() - side_ * (1.0 + 1.5 * static_cast<double>(cell.s))};
    }

    /// The six corners, counter-clockwise from the northern tip.
    std::array<Point, 6> corners(HexCoord cell) const;

    /// Distance from a point to the closed cell, 0 inside.
    double distance(const Point &p, HexCoord cell) const;

    /// The same cells at the same places.
    friend bool operator==(const HexLattice &a, const HexLattice &b)
    {
        return a.northWest_ == b.northWest_ && a.pitch_ == b.pitch_ && a.columns_ == b.columns_ && a.rows_ == b.rows_;
    }
    friend bool operator!=(const HexLattice &a, const HexLattice &b) { return !(a == b); }

private:
    Point northWest_;
    double pitch_;
    double side_;
    std::int64_t columns_;
    std::int64_t rows_;
};

}  // namespace seahex
