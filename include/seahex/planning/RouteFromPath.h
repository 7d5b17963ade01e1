#pragma once

#include <seahex/route/Route.h>

#include <ompl/geometric/PathGeometric.h>

namespace seahex
{

/// The route of a path's positions. Consecutive states at one place become one waypoint.
/// @throws ompl::Exception if the path's space is not planar (PlanarEmbedding)
Route routeFromPath(const ompl::geometric::PathGeometric &path);

}  // namespace seahex
