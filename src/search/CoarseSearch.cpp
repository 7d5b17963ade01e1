#include "seahex/search/CoarseSearch.h"

#include "seahex/geometry/HexRing.h"

#include <algorithm>

namespace seahex
{

CoarseSearch::CoarseSearch(const Occupancy &fine, const CoarseOccupancy &coarse)
    : fine_(fine), coarse_(coarse), search_(coarse.cells(), 3), near_(fine.layout().size())
{
}

std::vector<HexCoord> CoarseSearch::path(HexCoord start, HexCoord goal)
{
    std::vector<HexCoord> corners = join(start);
    std::vector<HexCoord> ending = join(goal);
    if (corners.empty() || ending.empty())
        return {};
    search_.begin(coarse_.holding(corners.back()), coarse_.holding(ending.back()));
    if (search_.run() != SearchStatus::Found)
        return {};
    for (const CellIndex cell : search_.path())
        corners.push_back(coarse_.middle(search_.layout().cell(cell)));
    corners.insert(corners.end(), ending.rbegin(), ending.rend());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

/// From an end to the first fine cell that lies in a free large one; empty if none is near.
std::vector<HexCoord> CoarseSearch::join(HexCoord end)
{
    const CellLayout &layout = fine_.layout();
    const std::int64_t most = 100 * coarse_.factor() * coarse_.factor();
    static const std::vector<RingOffset> steps = ringOffsets(1);
    near_.clear();
    queue_.assign(1, layout.index(end));
    near_.markReached(queue_.front());
    near_.setLabel(queue_.front(), LengthSearch::noJump);
    for (std::size_t next = 0; next < queue_.size() && static_cast<std::int64_t>(next) < most; ++next)
    {
        const HexCoord cell = layout.cell(queue_[next]);
        if (coarse_.cells().isFree(coarse_.holding(cell)))
        {
            std::vector<HexCoord> chain = {cell};
            for (std::uint32_t step; (step = near_.label(layout.index(chain.back()))) != LengthSearch::noJump;)
                chain.push_back(chain.back() - steps[step].offset);
            std::reverse(chain.begin(), chain.end());
            return chain;
        }
        for (std::uint32_t step = 0; step < steps.size(); ++step)
        {
            const CellIndex to = layout.index(cell + steps[step].offset);
            if (near_.isReached(to) || fine_.isBlockedAt(to))
                continue;
            near_.markReached(to);
            near_.setLabel(to, step);
            queue_.push_back(to);
        }
    }
    return {};
}

}  // namespace seahex
