#pragma once

#include "contest/Contender.h"

#include <cstdint>
#include <vector>

namespace seahex::contest
{

/// Long queries that have an answer: both cells lie in the same water, which holds at least a quarter of the free
/// cells, and at least 0.4 of the rectangle's diagonal apart. The same on every machine for the same occupancy and
/// seed.
/// @throws std::runtime_error if the occupancy has no such water or no such pairs
std::vector<Query> drawQueries(const HexOccupancy &occupancy, std::size_t count, std::uint64_t seed);

}  // namespace seahex::contest
