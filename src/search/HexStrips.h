#pragma once

#include "seahex/geometry/HexLattice.h"
#include "seahex/world/Occupancy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace seahex
{

/// A point in the frame of strips: x in half pitches east, y in half sides south of the lattice's north-west corner.
/// Corners of cells have integer coordinates.
struct StripPoint
{
    double x = 0.0;
    double y = 0.0;
};

/// Length of a vector of the frame of strips, in half pitches.
inline double stripNorm(double x, double y)
{
    return std::sqrt(x * x + y * y * (1.0 / 3.0));
}

/// The convex pieces that a hexagonal lattice has by itself, found by looking at its bits.
///
/// The level lines through the corners of the hexagons cut the plane into strips. Between y = 3 r + 1 and 3 r + 3 lie
/// the upright middle parts of row r: a run of free cells is a rectangle. Between y = 3 r and 3 r + 1 the lower tips of
/// row r - 1 and the upper tips of row r stand side by side, one triangle for every whole x, its centre:
///
///     y = 3 r       ___o_______o_______o___       o: tips of row r
///                     / \     / \     / \           .
///     y = 3 r + 1  __/___\_o_/___\_o_/___\__      o: tips of row r - 1
///
/// A run of free triangles is a trapezoid, a parallelogram or a triangle. Neighbouring pieces meet in an interval of
/// the line between their strips.
///
/// Cells are named by their row and the x of their centre, a whole number whose parity is that of the row.
class HexStrips
{
public:
    using Whole = std::int64_t;

    /// Does not own the occupancy.
    explicit HexStrips(const HexOccupancy &occupancy)
        : lattice_(occupancy.lattice()), words_(occupancy.words().data()), stride_(occupancy.layout().stride()),
          columns_(lattice_.columns())
    {
    }

    StripPoint fromPlane(const Point &p) const
    {
        return {2.0 * (p.x() - lattice_.northWest().x()) / lattice_.pitch(),
                2.0 * (lattice_.northWest().y() - p.y()) / lattice_.side()};
    }
    Point toPlane(StripPoint p) const
    {
        return {lattice_.northWest().x() + 0.5 * lattice_.pitch() * p.x,
                lattice_.northWest().y() - 0.5 * lattice_.side() * p.y};
    }
    /// Lengths of the plane for one of the frame.
    double unit() const { return 0.5 * lattice_.pitch(); }

    static Whole centre(OffsetCoord cell) { return 2 * cell.column + firstCentre(cell.row); }

    // The lines of a row's middle part as a ray meets them that goes south (way = 1) or north (-1).

    static double entryLine(Whole row, int way) { return static_cast<double>(3 * row + (way > 0 ? 1 : 3)); }
    static double exitLine(Whole row, int way) { return static_cast<double>(3 * row + (way > 0 ? 3 : 1)); }

    /// The cell of a row that lies west of a place, the place on its east edge or within.
    static Whole cellWestOf(Whole row, double x)
    {
        const double first = static_cast<double>(firstCentre(row) - 1);
        return 2 * (ceiling(0.5 * (x - first)) - 1) + firstCentre(row);
    }
    /// The cell of a row that lies east of a place, the place on its west edge or within.
    static Whole cellEastOf(Whole row, double x)
    {
        const double first = static_cast<double>(firstCentre(row) - 1);
        return 2 * floor(0.5 * (x - first)) + firstCentre(row);
    }
    /// The first centre of a row at or east of a place, and the last at or west of it.
    static Whole firstCentreFrom(Whole row, double x)
    {
        const Whole first = firstCentre(row);
        return 2 * ceiling(0.5 * (x - static_cast<double>(first))) + first;
    }
    static Whole lastCentreTo(Whole row, double x)
    {
        const Whole first = firstCentre(row);
        return 2 * floor(0.5 * (x - static_cast<double>(first))) + first;
    }

    bool isBlocked(Whole row, Whole centre) const
    {
        const Whole i = bit(row, centre);
        return (words_[i >> 6] >> (i & 63)) & 1;
    }

    /// No cell's centre.
    static constexpr Whole none = INT64_MIN;

    /// The first blocked cell from `from` westward whose centre is at `least` or east of it; none if there is none.
    Whole blockedWest(Whole row, Whole from, double least) const
    {
        if (static_cast<double>(from) < least)
            return none;
        const Whole start = bit(row, from);
        const Whole end =
            start - (from - std::max(firstCentreFrom(row, std::max(least, -4.0)), firstCentre(row) - 2)) / 2;
        Whole word = start >> 6;
        std::uint64_t bits = words_[word] & (~std::uint64_t{0} >> (63 - (start & 63)));
        while (bits == 0)
        {
            if (word * 64 <= end)
                return none;
            bits = words_[--word];
        }
        const Whole found = word * 64 + 63 - __builtin_clzll(bits);
        return found < end ? none : from - 2 * (start - found);
    }

    /// The first blocked cell from `from` eastward whose centre is at `most` or west of it; none if there is none.
    Whole blockedEast(Whole row, Whole from, double most) const { return firstEast(row, from, most, 0); }
    /// The first free cell, likewise.
    Whole freeEast(Whole row, Whole from, double most) const { return firstEast(row, from, most, ~std::uint64_t{0}); }

    static Whole floor(double x)
    {
        const auto whole = static_cast<Whole>(x);
        return whole - (static_cast<double>(whole) > x ? 1 : 0);
    }
    static Whole ceiling(double x)
    {
        const auto whole = static_cast<Whole>(x);
        return whole + (static_cast<double>(whole) < x ? 1 : 0);
    }

private:
    /// The centre of column 0.
    static Whole firstCentre(Whole row) { return 2 - (row & 1); }

    Whole bit(Whole row, Whole centre) const
    {
        return (row + CellLayout::frame) * stride_ + ((centre - firstCentre(row)) >> 1) + CellLayout::frame;
    }

    /// @param flip  all bits to look for free cells
    Whole firstEast(Whole row, Whole from, double most, std::uint64_t flip) const
    {
        if (static_cast<double>(from) > most)
            return none;
        const Whole start = bit(row, from);
        const Whole farthest = firstCentre(row) + 2 * columns_;  // a blocked cell of the frame
        const Whole last = std::min(lastCentreTo(row, std::min(most, static_cast<double>(farthest))), farthest);
        const Whole end = start + (last - from) / 2;
        Whole word = start >> 6;
        std::uint64_t bits = (words_[word] ^ flip) & (~std::uint64_t{0} << (start & 63));
        while (bits == 0)
        {
            if (word * 64 + 63 >= end)
                return none;
            bits = words_[++word] ^ flip;
        }
        const Whole found = word * 64 + __builtin_ctzll(bits);
        return found > end ? none : from + 2 * (found - start);
    }

    HexLattice lattice_;
    const std::uint64_t *words_;
    Whole stride_;
    Whole columns_;
};

}  // namespace seahex
