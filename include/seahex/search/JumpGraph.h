#pragma once

#include <seahex/search/GoalCells.h>
#include <seahex/search/Jumps.h>
#include <seahex/world/Occupancy.h>

#include <cstdint>
#include <utility>
#include <vector>

namespace seahex
{

/// The lattice of an occupancy as AStar wants it: a jump is valid if every cell that it needs is free. What a jump
/// costs is said by `Weight`, along with what GoalCells asks of it:
///
///     double jumpCost(CellIndex from, CellIndex to, std::size_t jump, std::uint8_t arrivedBy)
///         arrivedBy: the jump that led to `from`; 255 where the path begins
///     void useRings(int rings)      only the jumps of the first rings are used from now on
///
/// Nothing is virtual, and nothing is allocated during a search but for the growth of the open list.
template <class Weight>
class JumpGraph : public GoalCells<Weight>
{
public:
    /// Occupancy and jumps must outlive the graph.
    JumpGraph(const Occupancy &occupancy, const Jumps &jumps, std::vector<GoalCell> goals, Weight weight)
        : GoalCells<Weight>(occupancy.layout(), std::move(goals), std::move(weight)), jumps_(jumps),
          bits_(occupancy.words().data()), count_(jumps.size())
    {
    }

    /// Uses the jumps of the first rings only; a search that has begun must be reset.
    void useRings(int rings)
    {
        count_ = jumps_.countWithin(rings);
        Weight::useRings(rings);
    }

    template <class Relax>
    bool expand(CellIndex cell, std::uint8_t arrivedBy, Relax &&relax)
    {
        const std::vector<Jump> &jumps = jumps_.from(jumps_.parity(cell));
        const std::int32_t *touched = jumps_.touched();
        for (std::size_t k = 0; k < count_; ++k)
            if (isValid(cell, jumps[k], touched))
            {
                const auto successor = static_cast<CellIndex>(static_cast<std::int64_t>(cell) + jumps[k].delta);
                relax(successor, static_cast<std::uint8_t>(k), Weight::jumpCost(cell, successor, k, arrivedBy));
            }
        return true;
    }

    CellIndex predecessor(CellIndex cell, std::uint8_t jump) const { return jumps_.predecessor(cell, jump); }

    /// How many jumps are used.
    std::size_t jumpCount() const { return count_; }
    /// One jump by itself, of those that are used.
    bool isValid(CellIndex cell, std::size_t jump) const
    {
        return isValid(cell, jumps_.from(jumps_.parity(cell))[jump], jumps_.touched());
    }
    CellIndex successor(CellIndex cell, std::size_t jump) const { return jumps_.successor(cell, jump); }

private:
    bool isValid(CellIndex cell, const Jump &jump, const std::int32_t *touched) const
    {
        for (std::uint16_t t = jump.firstTouch; t < jump.endTouch; ++t)
        {
            const auto index = static_cast<CellIndex>(static_cast<std::int64_t>(cell) + touched[t]);
            if ((bits_[index >> 6] >> (index & 63)) & 1)
                return false;
        }
        return true;
    }

    const Jumps &jumps_;
    const std::uint64_t *bits_;
    std::size_t count_;
};

}  // namespace seahex
