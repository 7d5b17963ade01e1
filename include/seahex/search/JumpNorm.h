#pragma once

#include <seahex/geometry/HexNorm.h>
#include <seahex/geometry/Lattice.h>
#include <seahex/geometry/SquareNorm.h>
#include <seahex/search/HexJumps.h>
#include <seahex/search/SquareJumps.h>

#include <cmath>

namespace seahex
{

// What the bounds of a search on one kind of lattice are made of: how far two cells are apart, in pitches, for those
// who may only make its jumps (exact where nothing is in the way) and for those who fly.

/// On hexagons.
class HexJumpNorm
{
public:
    using KnownLattice = HexLattice;

    HexJumpNorm(const HexLattice &lattice, const Jumps &jumps) : lattice_(lattice), rings_(jumps.rings()) {}

    void useRings(int rings) { rings_ = rings; }
    Point centre(OffsetCoord cell) const { return lattice_.centre(toCube(cell)); }
    double pitch() const { return lattice_.pitch(); }

    /// Least Euclidean length of a chain of jumps.
    double length(OffsetCoord from, OffsetCoord to) const { return ringNorm(toCube(to) - toCube(from), rings_); }
    /// D, [Cheng2020] eq. 4.
    double steps(OffsetCoord from, OffsetCoord to) const
    {
        return static_cast<double>(hexDistance(toCube(from), toCube(to)));
    }

private:
    HexLattice lattice_;
    int rings_;
};

/// On squares.
class SquareJumpNorm
{
public:
    using KnownLattice = SquareLattice;

    SquareJumpNorm(const SquareLattice &lattice, const Jumps &jumps)
        : lattice_(lattice), neighbours_(static_cast<int>(jumps.size()))
    {
    }

    void useRings(int) {}
    Point centre(OffsetCoord cell) const { return lattice_.centre(cell); }
    double pitch() const { return lattice_.pitch(); }

    double length(OffsetCoord from, OffsetCoord to) const
    {
        return squareNorm({to.column - from.column, to.row - from.row}, neighbours_);
    }
    /// The same: steps are as long as they count.
    double steps(OffsetCoord from, OffsetCoord to) const { return length(from, to); }

private:
    SquareLattice lattice_;
    int neighbours_;
};

}  // namespace seahex
