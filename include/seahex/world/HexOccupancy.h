#pragma once

#include <seahex/geometry/CellLayout.h>
#include <seahex/geometry/HexLattice.h>

#include <cstdint>
#include <vector>

namespace seahex
{

/// Which cells of a lattice are blocked: one bit a cell, immutable, freely shared between threads.
///
/// Every cell outside the lattice is blocked. The bits are stored with a frame of blocked cells around the rectangle
/// (CellLayout), so that a search never tests bounds.
class HexOccupancy
{
public:
    /// @param words  one bit a cell in the order of `layout`, 1 = blocked; the frame's bits must be set
    HexOccupancy(const HexLattice &lattice, const CellLayout &layout, std::vector<std::uint64_t> words);

    const HexLattice &lattice() const { return lattice_; }
    const CellLayout &layout() const { return layout_; }

    bool isBlocked(HexCoord cell) const { return !lattice_.contains(cell) || isBlockedAt(layout_.index(cell)); }
    bool isFree(HexCoord cell) const { return !isBlocked(cell); }

    /// The same for a cell by its index in the layout; the cell must lie in the rectangle or its frame.
    bool isBlockedAt(CellIndex index) const { return (words_[index >> 6] >> (index & 63)) & 1; }

    /// The bits, in the order of layout().
    const std::vector<std::uint64_t> &words() const { return words_; }

    /// Number of blocked cells of the rectangle.
    std::int64_t blockedCount() const { return blockedCount_; }

private:
    HexLattice lattice_;
    CellLayout layout_;
    std::vector<std::uint64_t> words_;
    std::int64_t blockedCount_;
};

}  // namespace seahex
