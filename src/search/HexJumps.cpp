#include "seahex/search/HexJumps.h"

#include "seahex/geometry/HexTraversal.h"

#include <cmath>

namespace seahex
{

HexJumps::HexJumps(const CellLayout &layout, int rings, JumpSet set, JumpRule rule) : Jumps(layout)
{
    static const double rowStep = 0.5 * std::sqrt(3.0);
    for (const RingOffset &jump : ringOffsets(rings))
    {
        if (set == JumpSet::Primitive && !jump.primitive)
            continue;
        std::array<std::vector<OffsetCoord>, 2> cells;
        for (std::int64_t parity = 0; parity < 2; ++parity)
        {
            const HexCoord from = toCube({0, parity});
            const HexCoord to = from + jump.offset;
            std::vector<OffsetCoord> &needed = cells[static_cast<std::size_t>(parity)];
            needed.push_back(toOffset(to));
            const auto isNeeded = [&](HexCoord cell)
            {
                return rule == JumpRule::Hopping ? cell == to : cell != from;
            };
            forEachTouchedCell(from, to,
                               [&](HexCoord cell)
                               {
                                   if (isNeeded(cell))
                                       needed.push_back(toOffset(cell));
                                   return true;
                               });
        }
        const auto q = static_cast<double>(jump.offset.q);
        const auto s = static_cast<double>(jump.offset.s);
        add(Point(q + 0.5 * s, -rowStep * s), jump.ring, jump.ring, cells);
        offsets_.push_back(jump);
    }
    findOpposites();
}

}  // namespace seahex
