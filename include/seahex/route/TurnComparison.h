#pragma once

#include <seahex/geometry/OffsetCoord.h>
#include <seahex/search/Jumps.h>
#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace seahex
{

/// A path from centre to centre, by what turns are traded for, and what its search took.
struct MeasuredPath
{
    double lengthCells = 0.0;  ///< as in RouteMetrics
    int turns = 0;
    double turnAngleRad = 0.0;
    double perTurn = 0.0;        ///< the price, in cells, at which it is the cheapest; 0: a plain search
    std::uint64_t expanded = 0;  ///< cells, or cells with headings
    double seconds = 0.0;        ///< wall time, memory of the search included
};

/// One query: ring expansion alone, which hopes for few turns, against searches that know them.
struct TurnComparison
{
    MeasuredPath plain;  ///< the shortest path, as the plain search finds it
    /// For each allowance the path with the fewest turns among the lattice's paths that are no longer than the shortest
    /// by more than that, and that some price per turn makes the cheapest.
    std::vector<MeasuredPath> fewest;
};

/// Compares on one query.
///
/// The paths that a price makes the cheapest are the corners of the lower hull of all paths in the plane of turns and
/// length. They are found by halving: between two corners, the price at which both cost the same finds a third below
/// their line, or shows that there is none. A path above the hull may have fewer turns within an allowance; what is
/// said here is what a search with the right price finds. An allowance of 0 has a tolerance of a millionth.
///
/// @param jumps  of the occupancy's lattice and layout
/// @param allowances  parts of the shortest length, ascending, such as 0, 0.01 and 0.02
/// @return empty if there is no path
std::optional<TurnComparison> compareTurns(const Occupancy &occupancy, const Jumps &jumps, OffsetCoord start,
                                           OffsetCoord goal, const std::vector<double> &allowances);

}  // namespace seahex
