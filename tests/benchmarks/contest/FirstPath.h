#pragma once

#include "contest/Trial.h"

namespace seahex::contest
{

/// Wall time from HexAStar's solve() to its first path, milliseconds: of the planner as it comes, set up for the
/// problem, in R^2 with the occupancy's checkers; the median over the course's queries.
/// @throws std::runtime_error if one finds no path
double firstPathMs(const Course &course);

}  // namespace seahex::contest
