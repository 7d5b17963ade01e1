#pragma once

#include "contest/Trial.h"

namespace seahex::contest
{

/// Wall time of TautSearch from a query to the shortest path of the plane, with its proof, milliseconds: the median
/// over the course's queries.
/// @throws std::runtime_error if one finds no path, or does not prove it
double exactMs(const Course &course);

/// By how much the path of three rings, pulled taut, is longer than the shortest of the plane: percent.
struct Gap
{
    double median;
    double worst;
};

/// Over the course's queries.
Gap gapOfPulled(const Course &course);

}  // namespace seahex::contest
