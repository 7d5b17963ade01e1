#pragma once

#include <seahex/geometry/OffsetCoord.h>
#include <seahex/geometry/Point.h>

namespace seahex
{

// How far it is on squares when only steps to neighbours may be made: norms, exact where nothing is in the way, and in
// no lattice is a chain of steps cheaper.

/// Least length, in pitches, of a chain of steps that adds up to `difference`: with 4 neighbours the sum of columns and
/// rows (Manhattan); with 8, diagonal steps costing the root of 2, the octile distance.
/// @param neighbours  4 or 8
double squareNorm(OffsetCoord difference, int neighbours);

/// The octile distance extended to vectors of the plane, in units of `pitch`.
double octileNorm(const Point &vector, double pitch);

}  // namespace seahex
