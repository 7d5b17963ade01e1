#pragma once

#include <seahex/search/LabelStore.h>
#include <seahex/search/LengthSearch.h>
#include <seahex/world/CoarseOccupancy.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

/// A rough path, soon: through large cells, to which both ends are joined through fine ones.
///
/// An end that lies in no free large cell is joined to one by the fewest steps through fine cells, found breadth first
/// among the nearest some thousands. What it costs is a small share of a search of all cells, by the square of the
/// factor; that there is no such path says nothing.
///
/// Keeps its memory from one query to the next. One query at a time.
class CoarseSearch
{
public:
    /// @param fine  that of which `coarse` was made; both must outlive the search
    CoarseSearch(const Occupancy &fine, const CoarseOccupancy &coarse);

    /// The corners of a path between two free cells: every straight line from one centre to the next is free. Empty if
    /// there is no such path in large cells, or where the ends' cells are one.
    std::vector<HexCoord> path(HexCoord start, HexCoord goal);

private:
    std::vector<HexCoord> join(HexCoord end);

    const Occupancy &fine_;
    const CoarseOccupancy &coarse_;
    LengthSearch search_;
    LabelStore near_;
    std::vector<CellIndex> queue_;
};

}  // namespace seahex
