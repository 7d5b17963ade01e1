#include "seahex/world/SafetyWeights.h"

#include "seahex/geometry/HexRing.h"

#include <cmath>

namespace seahex
{

SafetyWeights::SafetyWeights(const HexOccupancy &occupancy)
    : lattice_(occupancy.lattice()), layout_(occupancy.layout()), blocked_(layout_.size(), neighbours)
{
    for (int n = 0; n <= neighbours; ++n)
        table_[static_cast<std::size_t>(n)] = ofBlocked(n);
    const std::vector<RingOffset> around = ringOffsets(1);
    for (std::int64_t row = 0; row < layout_.rows(); ++row)
    {
        // within a row a neighbour is always as many indices away
        const HexCoord first = toCube({0, row});
        const auto rowBegin = static_cast<std::int64_t>(layout_.index(first));
        std::array<std::int64_t, neighbours> away;
        for (std::size_t k = 0; k < away.size(); ++k)
            away[k] = static_cast<std::int64_t>(layout_.index(first + around[k].offset)) - rowBegin;
        for (std::int64_t index = rowBegin; index < rowBegin + layout_.columns(); ++index)
        {
            if (occupancy.isBlockedAt(static_cast<CellIndex>(index)))
                continue;
            std::uint8_t count = 0;
            for (const std::int64_t delta : away)
                count = static_cast<std::uint8_t>(count + occupancy.isBlockedAt(static_cast<CellIndex>(index + delta)));
            blocked_[static_cast<std::size_t>(index)] = count;
        }
    }
}

double SafetyWeights::ofBlocked(int n)
{
    return n == 0 ? 1.0 : 1.0 + std::ldexp(1.0, n - 2);
}

}  // namespace seahex
