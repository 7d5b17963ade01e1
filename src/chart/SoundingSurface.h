#pragma once

#include "seahex/geometry/NodeGrid.h"

#include <vector>

namespace seahex
{

/// A sounding in the plane.
struct PlaneSounding
{
    Point position;
    double depthM;
};

/// The soundings' triangulated surface (Delaunay, linear in each triangle) at the nodes of a grid, row by row from the
/// south-west; not a number outside the triangles, and everywhere if there are fewer than three or all lie on a line.
std::vector<float> soundingSurface(const std::vector<PlaneSounding> &soundings, const NodeGrid &grid);

}  // namespace seahex
