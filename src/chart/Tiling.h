#pragma once

#include <seahex/geometry/Shape.h>

#include <vector>

namespace seahex
{

/// True if the boundaries of the parts add up exactly to the boundary of the whole, on the grid of whole coordinates.
///
/// Every part's boundary is run through once, outer rings one way and holes the other. Where two parts are neighbours
/// their steps cancel; what is left must be the whole's boundary. Then the parts' winding numbers add up to the
/// whole's, so every point of the whole lies in at least one part. Steps that share a line but not their ends are
/// compared along that line. The converse does not hold: parts that meet on slightly different lines tile within
/// rounding and yield false.
///
/// Time: that of sorting two entries a segment.
bool boundariesAddUp(const std::vector<Polygon> &whole, const std::vector<Polygon> &parts, double gridUnitsPerDegree);

}  // namespace seahex
