#pragma once

#include <seahex/geometry/CellLayout.h>
#include <seahex/geometry/HexCoord.h>

#include <utility>
#include <vector>

namespace seahex
{

/// A cell in which a path may end, and what it costs to go from its centre to the goal itself.
struct GoalCell
{
    GoalCell(OffsetCoord where, double finishCost) : cell(where), finish(finishCost) {}
    GoalCell(HexCoord where, double finishCost) : cell(toOffset(where)), finish(finishCost) {}

    OffsetCoord cell;
    double finish;
};

/// The goal's side of a lattice graph: the bound, tie-break and finish that AStar asks for, for any number of goal
/// cells. What a cell is away from one of them is said by `Weight`, from which this class derives:
///
///     double bound(OffsetCoord cell, const GoalCell &) const
///         lower bound of the cost from a cell to a goal, finish included
///     double tie(OffsetCoord cell, double bound) const
///     bool sharpen(std::uint64_t expanded)
///         as AStar asks for it
///
/// and the algebra of costs: combine, better, improves, worst, key.
template <class Weight>
class GoalCells : public Weight
{
public:
    GoalCells(const CellLayout &layout, std::vector<GoalCell> goals, Weight weight)
        : Weight(std::move(weight)), layout_(layout)
    {
        setGoals(std::move(goals));
    }

    /// Replaces the goal cells; a search that has begun must be reset.
    void setGoals(std::vector<GoalCell> goals)
    {
        goals_ = std::move(goals);
        indices_.clear();
        for (const GoalCell &goal : goals_)
            indices_.push_back(layout_.index(goal.cell));
    }

    const std::vector<GoalCell> &goals() const { return goals_; }
    /// The index of a goal's cell.
    CellIndex goalIndex(std::size_t goal) const { return indices_[goal]; }
    const CellLayout &layout() const { return layout_; }

    std::size_t size() const { return layout_.size(); }

    double bound(CellIndex index) const
    {
        const OffsetCoord cell = layout_.offset(index);
        double best = Weight::worst();
        for (const GoalCell &goal : goals_)
        {
            const double bound = Weight::bound(cell, goal);
            if (Weight::better(bound, best))
                best = bound;
        }
        return best;
    }

    double tie(CellIndex index, double bound) const { return Weight::tie(layout_.offset(index), bound); }

    double finish(CellIndex index) const
    {
        double best = Weight::worst();
        for (std::size_t i = 0; i < goals_.size(); ++i)
            if (indices_[i] == index && Weight::better(goals_[i].finish, best))
                best = goals_[i].finish;
        return best;
    }

private:
    CellLayout layout_;
    std::vector<GoalCell> goals_;
    std::vector<CellIndex> indices_;
};

}  // namespace seahex
