#include "seahex/world/SafetyWeights.h"

#include <cmath>

namespace seahex
{

SafetyWeights::SafetyWeights(const Occupancy &occupancy)
    : lattice_(occupancy.lattice()), layout_(occupancy.layout()),
      neighbours_(static_cast<int>(lattice_.neighbours({0, 0}).size())),
      blocked_(layout_.size(), static_cast<std::uint8_t>(neighbours_))
{
    for (std::size_t n = 0; n < table_.size(); ++n)
        table_[n] = ofBlocked(static_cast<int>(n));
    for (std::int64_t row = 0; row < layout_.rows(); ++row)
    {
        // within a row a neighbour is always as many indices away
        const auto rowBegin = static_cast<std::int64_t>(layout_.index(OffsetCoord{0, row}));
        std::vector<std::int64_t> away;
        for (const OffsetCoord neighbour : lattice_.neighbours({0, row}))
            away.push_back(static_cast<std::int64_t>(layout_.index(neighbour)) - rowBegin);
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
