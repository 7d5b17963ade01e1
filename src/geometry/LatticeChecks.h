#pragma once

#include "seahex/geometry/Box.h"

#include <cstdint>

namespace seahex
{

/// A whole number as a coordinate of a cell; numbers beyond 2^60, and what is none, become +-2^60, so that sums of
/// coordinates hold.
std::int64_t toCoordinate(double number);

/// @throws std::domain_error if no lattice has these: a pitch that is not positive and finite, an origin that is not
/// finite, a count that is not positive
void requireLattice(const Point &northWest, double pitch, std::int64_t columns, std::int64_t rows);

/// The extent of a box that a lattice of this pitch is to cover.
/// @throws std::domain_error if the pitch is not positive and finite, or the box is empty or not finite
Point extentToCover(const Box &box, double pitch);

/// @throws std::domain_error if these are more than 2^40 cells
void requireCellCount(double pitch, double columns, double rows);

}  // namespace seahex
