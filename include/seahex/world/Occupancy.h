#pragma once

#include <seahex/geometry/CellLayout.h>
#include <seahex/geometry/Lattice.h>
#include <seahex/world/CellWords.h>

#include <cstdint>
#include <utility>

namespace seahex
{

/// Which cells of a lattice are blocked: one bit a cell, immutable, freely shared between threads.
///
/// Every cell outside the lattice is blocked. The bits are stored with a frame of blocked cells around the rectangle
/// (CellLayout), so that a search never tests bounds. Whoever needs to know the kind of cells takes a HexOccupancy or a
/// SquareOccupancy; everybody else takes this.
class Occupancy
{
public:
    /// @param words  one bit a cell in the order of `layout`, 1 = blocked; the frame's bits must be set
    /// @throws std::length_error if the three do not fit each other
    Occupancy(const Lattice &lattice, const CellLayout &layout, CellWords words);
    virtual ~Occupancy() = default;

    const Lattice &lattice() const { return lattice_; }
    const CellLayout &layout() const { return layout_; }

    bool isBlocked(OffsetCoord cell) const { return !lattice_.contains(cell) || isBlockedAt(layout_.index(cell)); }
    bool isFree(OffsetCoord cell) const { return !isBlocked(cell); }

    /// The same for a cell by its index in the layout; the cell must lie in the rectangle or its frame.
    bool isBlockedAt(CellIndex index) const { return (words_[index >> 6] >> (index & 63)) & 1; }

    /// The bits, in the order of layout().
    const CellWords &words() const { return words_; }

    /// Number of blocked cells of the rectangle.
    std::int64_t blockedCount() const { return blockedCount_; }

private:
    Lattice lattice_;
    CellLayout layout_;
    CellWords words_;
    std::int64_t blockedCount_;
};

/// An occupancy whose kind of cells is known.
template <class KnownLattice>
class LatticeOccupancy : public Occupancy
{
public:
    using Cell = typename KnownLattice::Cell;

    LatticeOccupancy(const KnownLattice &lattice, const CellLayout &layout, CellWords words)
        : Occupancy(lattice, layout, std::move(words)), lattice_(lattice)
    {
    }

    /// The lattice as what it is.
    const KnownLattice &lattice() const { return lattice_; }

    bool isBlocked(Cell cell) const { return !lattice_.contains(cell) || isBlockedAt(layout().index(cell)); }
    bool isFree(Cell cell) const { return !isBlocked(cell); }

private:
    KnownLattice lattice_;
};

using HexOccupancy = LatticeOccupancy<HexLattice>;
using SquareOccupancy = LatticeOccupancy<SquareLattice>;

}  // namespace seahex
