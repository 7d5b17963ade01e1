#pragma once

#include <seahex/route/Route.h>
#include <seahex/world/Occupancy.h>

#include <optional>

namespace seahex
{

/// How far offsetFromCorners() moves a corner: a millionth of the pitch, or more where the exactness of a position so
/// far from the origin asks for it, 4 times traversalTolerance().
double cornerOffset(const HexOccupancy &occupancy, const Route &taut);

/// A valid route beside one that touches blocked cells: every corner of a blocked cell in which the route turns, and
/// any other that would still be touched, becomes a waypoint moved outward by cornerOffset(), along the bisector of
/// what is free there.
///
/// A taut path turns around a blocked corner of 120 degrees by at most 60, so each turn makes it longer by no more than
/// the offset. Every leg returned was found free by isFree(); first and last waypoint stay.
/// @param taut  inner waypoints are corners of blocked cells; legs lie in closed free space, as TautSearch::path()
/// @return nothing if a leg is not free even so: where the route enters blocked cells or begins or ends at one
std::optional<Route> offsetFromCorners(const Route &taut, const HexOccupancy &occupancy);

}  // namespace seahex
