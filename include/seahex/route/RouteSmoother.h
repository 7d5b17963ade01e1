#pragma once

#include <seahex/route/Route.h>
#include <seahex/route/SegmentPredicate.h>
#include <seahex/world/Occupancy.h>

namespace seahex
{

/// Pulls a route taut like a string.
///
/// Waypoints are dropped while the straight segment between their neighbours is valid; then the legs are divided and
/// the string is pulled again, so that corners move towards the obstacles that hold them, until a round gains less than
/// 1e-5 of the length.
///
/// Guarantees: first and last waypoint stay; every leg was found valid as a whole; the result is never longer than the
/// input, in this plane's Euclidean length. The result is short but need not be the shortest of all. An input leg that
/// is itself invalid is kept as it is.
/// @param spacing  legs are divided into pieces no shorter than this, in the plane's unit; > 0
Route pullString(const Route &route, const SegmentPredicate &isValid, double spacing);

/// The same on the exact validity of an occupancy: never enters a blocked cell, nor touches one. Pieces of half a
/// pitch.
Route pullString(const Route &route, const Occupancy &occupancy);

}  // namespace seahex
