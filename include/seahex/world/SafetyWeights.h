#pragma once

#include <seahex/world/Occupancy.h>

#include <array>
#include <cstdint>
#include <vector>

namespace seahex
{

/// The safety weight of every cell of an occupancy, [Wang2017] eq. 1: 1 for a free cell with no blocked neighbour, else
/// 1 + 2^(n - 2) with n of them blocked. As published on squares, n of 8 neighbours: 1.5, 2, 3, 5, 9, 17, 33, 65; its
/// counterpart on hexagons counts the 6 neighbours: 1.5 to 17. Cells outside the lattice are blocked, as everywhere.
///
/// A blocked cell is no part of the formula; it weighs as much as a free one among blocked ones only, so that motions
/// that are asked for before they are checked have a cost.
///
/// Computed once: one byte a cell. Const, no cache, thread-safe.
class SafetyWeights
{
public:
    explicit SafetyWeights(const Occupancy &occupancy);

    const Lattice &lattice() const { return lattice_; }

    /// The weight of any cell, outside the lattice too; in [1, 65], of hexagons in [1, 17].
    double weight(OffsetCoord cell) const
    {
        return lattice_.contains(cell) ? weightAt(layout_.index(cell)) : ofBlocked(neighbours_);
    }
    double weight(HexCoord cell) const { return weight(toOffset(cell)); }

    /// The same for a cell by its index in the occupancy's layout; the cell must lie in the rectangle or its frame.
    double weightAt(CellIndex index) const { return table_[blocked_[index]]; }

    /// The weight of a free cell with n blocked neighbours, 0 to 8.
    static double ofBlocked(int n);

private:
    static constexpr std::size_t mostNeighbours = 8;

    Lattice lattice_;
    CellLayout layout_;
    int neighbours_;
    std::array<double, mostNeighbours + 1> table_;
    std::vector<std::uint8_t> blocked_;  // how many neighbours are
};

}  // namespace seahex
