#pragma once

#include <seahex/geometry/HexNorm.h>
#include <seahex/geometry/Lattice.h>
#include <seahex/geometry/SquareNorm.h>

namespace seahex
{

/// Length in steps of a lattice: D of [Cheng2020] eq. 4 on hexagons, the octile distance on squares, extended to all
/// vectors of the plane as the norms that they are.
inline double latticeNorm(const Point &vector, const Lattice &lattice)
{
    if (const HexLattice *hexagons = lattice.hexagons())
        return hexNorm(vector, *hexagons);
    return octileNorm(vector, lattice.pitch());
}

/// The same between the centres of two cells; on hexagons a whole number.
inline double latticeDistance(OffsetCoord a, OffsetCoord b, const Lattice &lattice)
{
    if (lattice.hexagons() != nullptr)
        return static_cast<double>(hexDistance(toCube(a), toCube(b)));
    return squareNorm({b.column - a.column, b.row - a.row}, 8);
}

}  // namespace seahex
