#include "Waters.h"

namespace demos
{

using seahex::CellIndex;
using seahex::OffsetCoord;

LargestWater::LargestWater(const seahex::Occupancy &occupancy)
    : lattice_(occupancy.lattice()), layout_(occupancy.layout()), water_(layout_.size(), 0)
{
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
            const OffsetCoord cell = layout_.offset(open.back());
            open.pop_back();
            ++count;
            // The frame around the rectangle is blocked, so every neighbour of a free cell has an index.
            for (const OffsetCoord neighbour : lattice_.neighbours(cell))
            {
                // squares that share but a corner do not hang together
                const bool isDiagonal =
                    lattice_.squares() != nullptr && neighbour.row != cell.row && neighbour.column != cell.column;
                const CellIndex next = layout_.index(neighbour);
                if (isDiagonal || occupancy.isBlockedAt(next) || water_[next] != 0)
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

bool LargestWater::contains(OffsetCoord cell) const
{
    return largest_ != 0 && lattice_.contains(cell) && water_[layout_.index(cell)] == largest_;
}

}  // namespace demos
