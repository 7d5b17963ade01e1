#pragma once

#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <vector>

namespace benchmark_planners
{

/// The largest water of an occupancy: the most free cells that hang together edge to edge. Between any two of
/// them there is a valid path, for a motion from centre to centre of free neighbours is valid.
class LargestWater
{
public:
    explicit LargestWater(const seahex::HexOccupancy &occupancy);

    bool contains(seahex::HexCoord cell) const;
    std::int64_t cellCount() const { return cellCount_; }

private:
    seahex::HexLattice lattice_;
    seahex::CellLayout layout_;
    std::vector<std::uint32_t> water_;  // the number of each cell's water; 0 where blocked
    std::uint32_t largest_ = 0;
    std::int64_t cellCount_ = 0;
};

}  // namespace benchmark_planners
