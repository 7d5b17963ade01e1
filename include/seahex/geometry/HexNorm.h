#pragma once

#include <seahex/geometry/HexCoord.h>
#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/Point.h>

namespace seahex
{

// How far it is when only the jumps of a ring expansion may be made. All these functions are norms (triangle
// inequality, scaling), exact for differences of cells and extended to all vectors: in a lattice without obstacles the
// cheapest chain of jumps from one centre to another costs exactly the norm of their difference, and no chain is
// cheaper in any lattice.

/// D of [Cheng2020] eq. 4 extended to vectors of the plane: the number of steps between neighbours, in cells.
double hexNorm(const Point &vector, const HexLattice &lattice);

/// Least Euclidean length, in pitches, of a chain of ring jumps that adds up to `difference`.
///
/// In the sextant of `difference` let m >= n >= 0 be its coordinates along the two nearest neighbours' directions. The
/// cheapest chain uses the two jump directions that enclose the difference: 1 (neighbour), root 3 (second ring, between
/// two neighbours) and root 7 (third ring).
/// @param rings  1, 2 or 3
double ringNorm(HexCoord difference, int rings);

/// The same extended to vectors of the plane: a vector in pitches, its norm in pitches.
double vectorRingNorm(const Point &vector, int rings);

}  // namespace seahex
