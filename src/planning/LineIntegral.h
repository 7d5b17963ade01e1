#pragma once

#include "seahex/geometry/Chords.h"

namespace seahex
{

/// The integral of a value per cell along a straight line; outside the lattice cells have values too.
///
/// A line with an end outside the lattice may be of any length, and is no valid motion: it is not walked, but taken to
/// lie in the cell of that end.
template <class ValueOf>
double integrateAlong(const Lattice &lattice, const Point &a, const Point &b, ValueOf &&valueOf)
{
    for (const OffsetCoord end : {lattice.cellAt(a), lattice.cellAt(b)})
        if (!lattice.contains(end))
            return (b - a).norm() * valueOf(end);
    double sum = 0.0;
    forEachChord(lattice, a, b, [&](OffsetCoord cell, double length) { sum += length * valueOf(cell); });
    return sum;
}

/// A bound below any integral along a line, in pieces or not, of a value of 1 or more. Pieces may add up to less than
/// the whole by rounding, and a heuristic above the cost breaks BIT*.
inline double straightLengthBound(const Point &a, const Point &b)
{
    constexpr double rounding = 1e-9;
    return (b - a).norm() * (1.0 - rounding);
}

}  // namespace seahex
