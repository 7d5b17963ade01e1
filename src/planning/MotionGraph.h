#pragma once

#include "planning/Courses.h"
#include "planning/MotionCache.h"
#include "seahex/search/GoalCells.h"

#include <map>
#include <utility>
#include <vector>

namespace seahex
{

/// The lattice of a user's own checker and motion validator as AStar wants it (compare JumpGraph): a jump is valid if
/// SpaceInformation::checkMotion says so, asked lazily.
template <class Weight>
class MotionGraph : public GoalCells<Weight>
{
public:
    /// @param startHeadings  the yaw with which each start cell is reached, to be filled in before the search begins
    /// Cache, jumps and headings must outlive the graph.
    MotionGraph(MotionCache &cache, const CellLayout &layout, const Jumps &jumps,
                const std::map<CellIndex, double> &startHeadings, std::vector<GoalCell> goals, Weight weight)
        : GoalCells<Weight>(layout, std::move(goals), std::move(weight)), cache_(cache), jumps_(jumps),
          startHeadings_(startHeadings), courses_(coursesOf(jumps)), count_(jumps.size())
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
        const double heading = arrivedBy < jumps_.size() ? courses_[arrivedBy] : startHeadings_.at(cell);
        const std::vector<Jump> &jumps = jumps_.from(jumps_.parity(cell));
        MotionCache::Answers known = cache_.take(cell, arrivedBy);
        for (std::size_t k = 0; k < count_; ++k)
        {
            const auto successor = static_cast<CellIndex>(static_cast<std::int64_t>(cell) + jumps[k].delta);
            if (k == known.count)
            {
                const MotionCache::Answer answer = cache_.jump(cell, successor, k, heading);
                if (answer == MotionCache::Answer::Interrupted)
                {
                    cache_.keep(cell, known);
                    return false;
                }
                ++known.count;
                known.valid |= std::uint64_t{answer == MotionCache::Answer::Valid} << k;
            }
            if ((known.valid >> k) & 1)
                relax(successor, static_cast<std::uint8_t>(k), Weight::jumpCost(cell, successor, k, arrivedBy));
        }
        return true;
    }

    CellIndex predecessor(CellIndex cell, std::uint8_t jump) const { return jumps_.predecessor(cell, jump); }

private:
    MotionCache &cache_;
    const Jumps &jumps_;
    const std::map<CellIndex, double> &startHeadings_;
    std::vector<double> courses_;
    std::size_t count_;
};

}  // namespace seahex
