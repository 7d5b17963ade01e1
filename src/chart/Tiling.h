#pragma once

#include "GridCoordinates.h"
#include "OppositeSteps.h"

#include <seahex/geometry/Shape.h>

#include <cstddef>
#include <vector>

namespace seahex
{

/// Do parts tile a whole? Areas and boundaries are compared on the grid of whole coordinates, so that equal means
/// equal.
class Tiling
{
public:
    /// @param corners  about how many corners all areas have together
    Tiling(double gridUnitsPerDegree, std::size_t corners) : gridUnitsPerDegree_(gridUnitsPerDegree), steps_(corners) {}

    void addWhole(const Polygon &area) { add(area, 1); }
    void addPart(const Polygon &area) { add(area, -1); }

    /// Twice the area of the whole minus twice that of the parts, in squared grid units. Overlaps count as often as
    /// they occur.
    WideInteger twiceAreaDifference() const { return twiceAreaDifference_; }

    /// True if the boundaries of the parts add up exactly to the boundary of the whole.
    ///
    /// Every part's boundary is run through once, outer rings one way and holes the other. Where two parts are
    /// neighbours their steps cancel; what is left must be the whole's boundary. Then the parts' winding numbers add up
    /// to the whole's, so every point of the whole lies in at least one part. Steps that share a line but not their
    /// ends are compared along that line. The converse does not hold: parts that meet on slightly different lines tile
    /// within rounding and yield false.
    ///
    /// Time: linear in the segments, and that of sorting two entries for each that has no exact opposite.
    bool boundariesAddUp() const;

private:
    void add(const Polygon &area, int sign);
    void addRing(const Ring &ring, int sign);

    double gridUnitsPerDegree_;
    WideInteger twiceAreaDifference_ = 0;
    OppositeSteps steps_;
    std::vector<GridPoint> ring_;  // kept from ring to ring for its memory
};

}  // namespace seahex
