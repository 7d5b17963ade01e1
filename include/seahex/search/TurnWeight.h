#pragma once

#include <seahex/search/LengthWeight.h>
#include <seahex/search/TurnBound.h>

#include <utility>
#include <vector>

namespace seahex
{

/// Path length and turns as the weight of a HeadingGraph: each jump costs its length, each change of course between two
/// jumps perTurn and perRadian for its angle. The turns are those of RouteMetrics on the legs between centres: the
/// path's first course is no turn.
///
/// Everything is looked up in tables, but for the bound (TurnBound), which takes a few multiplications. With guidance
/// Distance, TieBreak and Relaxed it is exact where nothing is in the way; the other guidances are LengthWeight's,
/// which know of no turns.
///
/// A search with the bound expands about as many states as one that is led by length alone where turns are cheap, and
/// down to a seventh of them where they are dear (a turn for 20 cells; TurnBound's cost is made up for from a turn for
/// 1 to 5 cells).
/// @tparam Norm  HexJumpNorm or SquareJumpNorm
template <class Norm>
class LatticeTurnWeight : public LatticeLengthWeight<Norm>
{
    using Length = LatticeLengthWeight<Norm>;

public:
    /// The jumps must outlive the weight.
    /// @param turns  their prices, in the unit of costs
    /// @param unit  what a pitch, or step, of length costs
    /// @param start, goal  of the guidance's line
    LatticeTurnWeight(const typename Norm::KnownLattice &lattice, const Jumps &jumps, LengthMetric metric,
                      const TurnCosts &turns, Guidance guidance, const Point &start, const Point &goal,
                      double unit = 1.0)
        : Length(lattice, jumps, metric, guidance, start, goal), norm_(lattice, jumps), jumps_(&jumps), turns_(turns),
          unit_(unit), knowsTurns_(guidance == Guidance::Distance || guidance == Guidance::TieBreak ||
                                   guidance == Guidance::Relaxed),
          bound_(boundWithin(jumps.rings()))
    {
    }

    void useRings(int rings)
    {
        Length::useRings(rings);
        norm_.useRings(rings);
        bound_ = boundWithin(rings);
    }

    /// From where a path begins to lying on the course of its first jump.
    double departure(CellIndex, std::size_t) const { return 0.0; }
    /// From the course of one jump to that of another, at a cell's centre.
    double turn(std::size_t from, std::size_t to) const { return bound_.turn(from, to); }
    /// Along a jump.
    double advance(std::size_t jump) const { return unit_ * Length::jumpCost(0, 0, jump, 0); }
    /// From lying on a course at a goal cell's centre to the goal itself.
    double arrival(CellIndex, std::size_t, const GoalCell &goal) const { return goal.finish; }

    struct Approach : TurnBound::Approach
    {
        double finish = 0.0;
    };

    /// A cell and a goal, for the bound.
    Approach approach(OffsetCoord cell, const GoalCell &goal) const
    {
        const double norm = unit_ * Length::bound(cell, {goal.cell, 0.0});
        Approach result;
        if (knowsTurns_)
            static_cast<TurnBound::Approach &>(result) =
                bound_.approach((norm_.centre(goal.cell) - norm_.centre(cell)) / norm_.pitch(), norm);
        result.norm = norm;
        result.finish = goal.finish;
        return result;
    }

    /// Lower bound to the goal, finish included, with a heading: a jump, or none yet.
    double boundFrom(const Approach &approach, std::size_t heading) const
    {
        return (knowsTurns_ ? bound_(approach, heading) : approach.norm) + approach.finish;
    }

private:
    TurnBound boundWithin(int rings) const
    {
        std::vector<Point> vectors;
        std::vector<double> costs;
        for (std::size_t k = 0; k < jumps_->countWithin(rings); ++k)
        {
            vectors.push_back(jumps_->vector(k));
            costs.push_back(advance(k));
        }
        return {std::move(vectors), std::move(costs), turns_};
    }

    Norm norm_;
    const Jumps *jumps_;
    TurnCosts turns_;
    double unit_;
    bool knowsTurns_;
    TurnBound bound_;
};

using TurnWeight = LatticeTurnWeight<HexJumpNorm>;
using SquareTurnWeight = LatticeTurnWeight<SquareJumpNorm>;

}  // namespace seahex
