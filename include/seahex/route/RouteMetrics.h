#pragma once

#include <seahex/route/Route.h>
#include <seahex/world/Occupancy.h>

#include <cstdint>

namespace seahex
{

/// A change of heading up to this many radians is no turn.
constexpr double leastTurnRad = 1e-6;

/// The numbers by which routes are compared, each with its one definition.
struct RouteMetrics
{
    double lengthM = 0.0;        ///< rhumb-line metres on WGS-84; filled by whoever knows the positions on the earth
    double lengthCells = 0.0;    ///< Euclidean length over the cell width, whole route
    double lengthLattice = 0.0;  ///< sum of D ([Cheng2020] eq. 4; octile on squares; latticeNorm) over the counted legs
    int turns = 0;  ///< heading changes above leastTurnRad at waypoints between counted legs, collinear ones merged
    double turnAngleRad = 0.0;  ///< sum of those changes, each in (0, pi]
    /// Least distance in metres from the whole line to the geometry of a blocking hazard itself; infinite if there is
    /// none. Filled by whoever knows the hazards.
    double minClearanceM = 0.0;
    /// Distinct blocked cells of the lattice next to any cell that the line touches ([Wang2017], potential hazards).
    std::int64_t potentialHazards = 0;

    double lengthNm() const { return lengthM / 1852.0; }
    double turnAngleDeg() const;
};

/// Which legs count for turns and for the lattice length.
enum class CountedLegs
{
    All,
    /// Without the first and the last one, which join start and goal to their cells' centres: what remains runs from
    /// centre to centre, as the published numbers do.
    BetweenCentres
};

/// Everything but lengthM and minClearanceM.
RouteMetrics measureRoute(const Route &route, const Occupancy &occupancy, CountedLegs counted);

}  // namespace seahex
