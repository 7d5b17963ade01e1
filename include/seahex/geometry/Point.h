#pragma once

#include <Eigen/Core>

namespace seahex
{

/// A point or a vector of the plane: x to the east, y to the north.
///
/// The unit is the metre in a local metric frame and the degree in the plate carree frame; which of the two it is, is
/// said by the Projection that made the point.
using Point = Eigen::Vector2d;

}  // namespace seahex
