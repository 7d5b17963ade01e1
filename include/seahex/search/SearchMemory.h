#pragma once

#include <cstddef>

namespace seahex
{

/// What a search holds in memory, in bytes; the lattice, its occupancy and its bounds not included.
struct SearchMemory
{
    std::size_t everywhere = 0;  ///< for every cell, whether it was touched or not
    std::size_t touched = 0;     ///< because cells were touched; the open list included
};

}  // namespace seahex
