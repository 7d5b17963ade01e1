#pragma once

#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <vector>

namespace demos
{

/// The largest water of an occupancy: the most free cells that hang together edge to edge. Between any two of
/// them there is a valid path, for a motion from centre to centre of two that share an edge is valid.
class LargestWater
{
public:
    explicit LargestWater(const seahex::Occupancy &occupancy);

    bool contains(seahex::OffsetCoord cell) const;
    std::int64_t cellCount() const { return cellCount_; }

private:
    seahex::Lattice lattice_;
    seahex::CellLayout layout_;
    std::vector<std::uint32_t> water_;  // the number of each cell's water; 0 where blocked
    std::uint32_t largest_ = 0;
    std::int64_t cellCount_ = 0;
};

}  // namespace demos
