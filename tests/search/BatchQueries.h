#pragma once

// Questions for batches of searches, and their answers one by one.

#include <seahex/search/LengthSearch.h>
#include <seahex/search/ShortestPaths.h>

#include "search/LengthWorlds.h"

#include <limits>

namespace seahex::test
{

const double infinity = std::numeric_limits<double>::infinity();

inline BatchControl withThreads(unsigned int threads)
{
    BatchControl control;
    control.threads = threads;
    return control;
}

/// Ends anywhere, on land and outside too.
inline HexCoord anyCell(Random &random, const HexLattice &lattice)
{
    return random.chance(0.1) ? toCube({-5, random.integer(0, 3)}) : random.cellOf(lattice);
}

/// What a search made for this query alone says.
inline ShortestPath alone(const HexOccupancy &occupancy, int rings, const CellQuery &query)
{
    if (occupancy.isBlocked(query.start) || occupancy.isBlocked(query.goal))
        return {SearchStatus::Exhausted, infinity, {}};
    LengthSearch search(occupancy, rings);
    search.begin(query.start, query.goal);
    const SearchStatus status = search.run();
    return {status, search.cost(), search.path()};
}

}  // namespace seahex::test
