#pragma once

#include "SoundingSurface.h"

#include "seahex/geometry/Shape.h"

#include <vector>

namespace seahex
{

/// A depth contour in the plane.
struct PlaneContour
{
    double depthM;
    Shape shape;
};

/// Depths along contours, to be triangulated with soundings: along each line no farther apart than the grid's nodes,
/// and of all in a cell of the grid the shallowest only. What lies outside the grid is left out.
std::vector<PlaneSounding> contourMarks(const std::vector<PlaneContour> &contours, const NodeGrid &grid);

}  // namespace seahex
