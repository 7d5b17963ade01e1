#pragma once

#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace seahex
{

/// The clearance of every cell of an occupancy: the distance from its centre to the nearest blocked cell (the closed
/// cell; those around the lattice are blocked), in the plane's unit. 0 in a blocked cell, at least half a pitch in a
/// free one. What nearestBlocked() says at the centres, for all of them at once.
///
/// Exact but for storage: a value is rounded down to a float. Time: a pass over the rows, then for each cell two steps
/// for every row between it and the nearest blocked cell, or `limit`. Four bytes a cell. Const, no cache, thread-safe.
class ClearanceField
{
public:
    /// @param limit  clearances beyond it count as this much; > 0. A small one saves time in open water.
    explicit ClearanceField(const Occupancy &occupancy, double limit = std::numeric_limits<double>::infinity());

    const Lattice &lattice() const { return lattice_; }

    /// The clearance of any cell; 0 outside the lattice.
    double clearance(OffsetCoord cell) const
    {
        return lattice_.contains(cell) ? clearanceAt(layout_.index(cell)) : 0.0;
    }
    double clearance(HexCoord cell) const { return clearance(toOffset(cell)); }

    /// The same for a cell by its index in the occupancy's layout; the cell must lie in the rectangle or its frame.
    double clearanceAt(CellIndex index) const { return static_cast<double>(values_[index]); }

private:
    Lattice lattice_;
    CellLayout layout_;
    std::vector<float> values_;
};

}  // namespace seahex
