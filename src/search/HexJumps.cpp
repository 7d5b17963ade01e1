#include "seahex/search/HexJumps.h"

#include "seahex/geometry/HexTraversal.h"

#include <algorithm>
#include <cmath>

namespace seahex
{

HexJumps::HexJumps(const CellLayout &layout, int rings, JumpSet set)
    : rings_(rings), stride_(static_cast<CellIndex>(layout.stride()))
{
    for (const RingOffset &offset : ringOffsets(rings))
        if (set == JumpSet::All || offset.primitive)
            offsets_.push_back(offset);

    for (const RingOffset &jump : offsets_)
    {
        const auto q = static_cast<double>(jump.offset.q);
        const auto s = static_cast<double>(jump.offset.s);
        lengths_.push_back(std::sqrt(q * q + q * s + s * s));
        const auto back = std::find_if(offsets_.begin(), offsets_.end(),
                                       [&jump](const RingOffset &other) { return other.offset == -1 * jump.offset; });
        opposites_.push_back(static_cast<std::size_t>(back - offsets_.begin()));
    }

    // Index differences depend on the parity of the row alone; any cell of that parity serves as the model.
    for (int parity = 0; parity < 2; ++parity)
    {
        const HexCoord from = toCube({0, parity});
        const auto delta = [&](HexCoord to)
        {
            const OffsetCoord d = toOffset(to);
            return static_cast<std::int32_t>((d.row - parity) * layout.stride() + d.column);
        };
        for (const RingOffset &jump : offsets_)
        {
            const HexCoord to = from + jump.offset;
            Jump entry{delta(to), static_cast<std::uint16_t>(touched_.size()), 0};
            forEachTouchedCell(from, to,
                               [&](HexCoord cell)
                               {
                                   if (cell != from)
                                       touched_.push_back(delta(cell));
                                   return true;
                               });
            entry.endTouch = static_cast<std::uint16_t>(touched_.size());
            jumps_[static_cast<std::size_t>(parity)].push_back(entry);
        }
    }
}

std::size_t HexJumps::countWithin(int rings) const
{
    const auto beyond = std::find_if(offsets_.begin(), offsets_.end(),
                                     [rings](const RingOffset &offset) { return offset.ring > rings; });
    return static_cast<std::size_t>(beyond - offsets_.begin());
}

}  // namespace seahex
