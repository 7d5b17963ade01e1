#pragma once

#include <seahex/world/Bathymetry.h>

#include <cstdint>
#include <vector>

namespace demos
{

/// The largest water that is deep enough: of the seabed's cells with so much water at all four nodes, and so
/// everywhere, the most that hang together edge to edge. Between any two positions above it there is a dive: up to the
/// least depth, across from cell to cell, and down again.
class DeepWater
{
public:
    /// @param leastDepthM  of the seabed
    DeepWater(const seahex::Bathymetry &seabed, double leastDepthM);

    bool contains(const seahex::Point &p) const;
    std::int64_t cellCount() const { return cellCount_; }

private:
    seahex::NodeGrid grid_;
    std::vector<std::uint32_t> water_;  // the number of each cell's water, row by row; 0 where it is not deep enough
    std::uint32_t largest_ = 0;
    std::int64_t cellCount_ = 0;
};

}  // namespace demos
