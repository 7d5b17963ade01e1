#pragma once

#include <seahex/world/HexOccupancy.h>

#include <array>
#include <cstdint>
#include <vector>

namespace seahex
{

/// The safety weight of every cell of an occupancy, [Wang2017] eq. 1 with the 6 neighbours of a hexagon in place of the
/// 8 of a square: 1 for a free cell with no blocked neighbour, else 1 + 2^(n - 2) with n of them blocked, that is 1.5,
/// 2, 3, 5, 9, 17. Cells outside the lattice are blocked, as everywhere.
///
/// A blocked cell is no part of the formula; it weighs as much as a free one among six blocked ones, so that motions
/// that are asked for before they are checked have a cost.
///
/// Computed once: one byte a cell. Const, no cache, thread-safe.
class SafetyWeights
{
public:
    explicit SafetyWeights(const HexOccupancy &occupancy);

    const HexLattice &lattice() const { return lattice_; }

    /// The weight of any cell, outside the lattice too; in [1, 17].
    double weight(HexCoord cell) const
    {
        return lattice_.contains(cell) ? weightAt(layout_.index(cell)) : ofBlocked(neighbours);
    }

    /// The same for a cell by its index in the occupancy's layout; the cell must lie in the rectangle or its frame.
    double weightAt(CellIndex index) const { return table_[blocked_[index]]; }

    /// The weight of a free cell with n blocked neighbours, 0 to 6.
    static double ofBlocked(int n);

private:
    static constexpr int neighbours = 6;

    HexLattice lattice_;
    CellLayout layout_;
    std::array<double, neighbours + 1> table_;
    std::vector<std::uint8_t> blocked_;  // how many neighbours are
};

}  // namespace seahex
