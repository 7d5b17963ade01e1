#pragma once

#include <seahex/geometry/HexCoord.h>
#include <seahex/search/BatchControl.h>
#include <seahex/search/SearchStatus.h>
#include <seahex/world/Occupancy.h>

#include <limits>
#include <vector>

namespace seahex
{

/// From one cell to another.
struct CellQuery
{
    HexCoord start;
    HexCoord goal;
};

/// What came of a query.
struct ShortestPath
{
    /// Exhausted: there is no path, or one of the ends is blocked or outside. Stopped: the batch was.
    SearchStatus status = SearchStatus::Stopped;
    double length = std::numeric_limits<double>::infinity();  ///< in pitches; infinite unless found
    std::vector<CellIndex> cells;                             ///< from start to goal; empty unless found
};

/// The shortest chains of ring jumps of many queries on one chart, over threads: a LengthSearch for each thread, its
/// memory kept from one query to the next, the queries dealt out one by one.
///
/// @param occupancy  of hexagons
/// @param rings  1, 2 or 3
/// @return in the order of the queries; the same for any number of threads, unless stopped
/// @throws std::length_error as LengthSearch, and what `control`'s functions throw, when all threads have ended
std::vector<ShortestPath> shortestPaths(const Occupancy &occupancy, int rings, const std::vector<CellQuery> &queries,
                                        const BatchControl &control = {});

}  // namespace seahex
