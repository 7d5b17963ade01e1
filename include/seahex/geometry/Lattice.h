#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/SquareLattice.h>

#include <variant>
#include <vector>

namespace seahex
{

/// A rectangle of cells in rows, hexagonal or square: a HexLattice or a SquareLattice behind one face, its cells
/// addressed by column and row.
///
/// For all that works on any lattice and is not a search's inner loop: each call looks at which of the two it is. Both
/// convert to it implicitly. An immutable value.
class Lattice
{
public:
    Lattice(const HexLattice &lattice) : lattice_(lattice) {}
    Lattice(const SquareLattice &lattice) : lattice_(lattice) {}

    /// The lattice as what it is; nullptr if it is the other kind.
    const HexLattice *hexagons() const { return std::get_if<HexLattice>(&lattice_); }
    const SquareLattice *squares() const { return std::get_if<SquareLattice>(&lattice_); }

    const Point &northWest() const
    {
        return std::visit([](const auto &lattice) -> const Point & { return lattice.northWest(); }, lattice_);
    }
    /// Centre to centre of neighbours in a row = width of a cell.
    double pitch() const
    {
        return std::visit([](const auto &lattice) { return lattice.pitch(); }, lattice_);
    }
    std::int64_t columns() const
    {
        return std::visit([](const auto &lattice) { return lattice.columns(); }, lattice_);
    }
    std::int64_t rows() const
    {
        return std::visit([](const auto &lattice) { return lattice.rows(); }, lattice_);
    }
    std::int64_t cellCount() const { return columns() * rows(); }
    Box bounds() const
    {
        return std::visit([](const auto &lattice) { return lattice.bounds(); }, lattice_);
    }
    /// Area of a cell.
    double cellArea() const { return pitch() * rowStep(); }

    bool contains(OffsetCoord cell) const
    {
        return cell.row >= 0 && cell.row < rows() && cell.column >= 0 && cell.column < columns();
    }
    /// The cell that holds a point; see HexLattice::cellAt.
    OffsetCoord cellAt(const Point &p) const
    {
        return std::visit([&p](const auto &lattice) { return toOffset(lattice.cellAt(p)); }, lattice_);
    }
    Point centre(OffsetCoord cell) const
    {
        return std::visit([cell](const auto &lattice) { return lattice.centre(lattice.cell(cell)); }, lattice_);
    }
    /// Distance from a point to the closed cell, 0 inside.
    double distance(const Point &p, OffsetCoord cell) const
    {
        return std::visit([&](const auto &lattice) { return lattice.distance(p, lattice.cell(cell)); }, lattice_);
    }
    /// Six or four, counter-clockwise.
    std::vector<Point> corners(OffsetCoord cell) const;
    /// The cells that touch a cell, six or eight, counter-clockwise from the eastern one; some may lie outside.
    std::vector<OffsetCoord> neighbours(OffsetCoord cell) const;

    // The rows: centres in a row are a pitch apart.

    /// From the centres of a row to those of the next.
    double rowStep() const { return hexagons() != nullptr ? 1.5 * hexagons()->side() : pitch(); }
    /// From a cell's centre to its northern tip or edge.
    double halfHeight() const { return hexagons() != nullptr ? hexagons()->side() : 0.5 * pitch(); }
    /// The centre of column 0 of a row, in pitches east of the north-west corner.
    double firstColumn(std::int64_t row) const { return hexagons() != nullptr && (row & 1) == 0 ? 1.0 : 0.5; }

    /// The same cells at the same places.
    friend bool operator==(const Lattice &a, const Lattice &b) { return a.lattice_ == b.lattice_; }
    friend bool operator!=(const Lattice &a, const Lattice &b) { return !(a == b); }

private:
    std::variant<HexLattice, SquareLattice> lattice_;
};

}  // namespace seahex
