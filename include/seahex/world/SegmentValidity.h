#pragma once

#include <seahex/world/Occupancy.h>

#include <optional>

namespace seahex
{

/// True if every closed cell that the segment from a to b touches is free: exact, no sampling resolution, and the same
/// for (b, a). With a = b: true if the point touches free cells only. Positions that are not numbers are not free.
/// Time: linear in the rows crossed plus the cells touched.
bool isFree(const Occupancy &occupancy, const Point &a, const Point &b);

/// How far one can go from a towards b: the largest t found for which isFree(a, a + t (b - a)) holds, at most a
/// tolerance (1e-9 of the largest coordinate, or a 2^-40th of the way) short of the first blocked cell. Empty if a
/// itself is not free; 1 if the whole segment is.
std::optional<double> lastFree(const Occupancy &occupancy, const Point &a, const Point &b);

}  // namespace seahex
