#include "seahex/search/SquareJumps.h"

#include "seahex/geometry/SquareTraversal.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace seahex
{

SquareJumps::SquareJumps(const CellLayout &layout, int neighbours, JumpRule rule) : Jumps(layout)
{
    if (neighbours != 4 && neighbours != 8)
        throw std::domain_error("a square has 4 or 8 neighbours, not " + std::to_string(neighbours));
    static constexpr OffsetCoord steps[8] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}, {1, -1}, {-1, -1}, {-1, 1}, {1, 1}};
    for (int k = 0; k < neighbours; ++k)
    {
        const OffsetCoord step = steps[k];
        std::array<std::vector<OffsetCoord>, 2> cells;
        for (std::int64_t parity = 0; parity < 2; ++parity)
        {
            const OffsetCoord from{0, parity};
            const OffsetCoord to{step.column, parity + step.row};
            std::vector<OffsetCoord> &needed = cells[static_cast<std::size_t>(parity)];
            needed.push_back(to);
            const auto isNeeded = [&](OffsetCoord cell)
            {
                return rule == JumpRule::Hopping ? cell == to : cell != from;
            };
            forEachTouchedCell(from, to,
                               [&](OffsetCoord cell)
                               {
                                   if (isNeeded(cell))
                                       needed.push_back(cell);
                                   return true;
                               });
        }
        const Point vector(static_cast<double>(step.column), -static_cast<double>(step.row));
        add(vector, vector.norm(), 1, cells);
    }
    findOpposites();
}

}  // namespace seahex
