#pragma once

#include <seahex/geometry/Box.h>
#include <seahex/geometry/Shape.h>

#include <cstdint>
#include <vector>

namespace seahex::contest
{

/// Islands with coasts that stay ragged down to `finest`, from rocks of that size to an eighth of the box's width: as
/// many of each size as coasts have (the number of islands larger than an area a goes with a to the power -0.65), until
/// their sum is 0.3 of the box. Coasts are closed rings whose edges are broken at the middle again and again, each time
/// aside by up to a fifth of their length. Islands may overlap. The same for the same box, finest and seed, up to what
/// standard libraries round differently in sines.
std::vector<Polygon> archipelago(const Box &box, double finest, std::uint64_t seed);

}  // namespace seahex::contest
