#pragma once

#include <cstdint>

namespace seahex
{

/// What a search did.
struct SearchCounters
{
    std::uint64_t expanded = 0;   ///< cells taken from the open list and expanded; a reopened cell counts again
    std::uint64_t generated = 0;  ///< cells that got a cost for the first time
    std::uint64_t improved = 0;   ///< cells whose cost was lowered later
    std::uint64_t reopened = 0;   ///< those of them that had been expanded already
};

}  // namespace seahex
