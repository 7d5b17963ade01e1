#include "Waters.h"

#include <seahex/geometry/HexRing.h>

namespace benchmark_planners
{

using seahex::CellIndex;
using seahex::HexCoord;

LargestWater::LargestWater(const seahex::HexOccupancy &occupancy)
    : lattice_(occupancy.lattice()), layout_(occupancy.layout()), water_(layout_.size(), 0)
{
    const std::vector<seahex::RingOffset> neighbours = seahex::ringOffsets(1);
    std::uint32_t waters = 0;
    std::vector<CellIndex> open;
    for (CellIndex first = 0; first < layout_.size(); ++first)
    {
        if (occupancy.isBlockedAt(first) || water_[first] != 0)
            continue;
        std::int64_t count = 0;
        water_[first] = ++waters;
        open.push_back(first);
        while (!open.empty())
        {
            const HexCoord cell = layout_.cell(open.back());
            open.pop_back();
            ++count;
            // The frame around the rectangle is blocked, so every neighbour of a free cell has an index.
            for (const seahex::RingOffset &neighbour : neighbours)
            {
                const CellIndex next = layout_.index(cell + neighbour.offset);
                if (occupancy.isBlockedAt(next) || water_[next] != 0)
                    continue;
                water_[next] = waters;
                open.push_back(next);
            }
        }
        if (count > cellCount_)
        {
            cellCount_ = count;
            largest_ = waters;
        }
    }
}

bool LargestWater::contains(HexCoord cell) const
{
    return largest_ != 0 && lattice_.contains(cell) && water_[layout_.index(cell)] == largest_;
}

}  // namespace benchmark_planners
