#pragma once

#include <seahex/search/LengthWeight.h>
#include <seahex/search/TurnBound.h>

namespace seahex
{

/// Path length and turns as the weight of a HeadingGraph: each jump costs its length, each change of course between two
/// jumps perTurn and perRadian for its angle. The turns are those of RouteMetrics on the legs between centres: the
/// path's first course is no turn.
///
/// Everything is looked up in tables, but for the bound (TurnBound), which takes a few multiplications. Guidance: None
/// has no bound; Distance and TieBreak the exact one; Cheng the published heuristic, which knows of no turns.
class TurnWeight : public LengthWeight
{
public:
    /// @param turns  in the unit of the length: pitches, or steps
    /// @param start, goal  of the guidance's line
    TurnWeight(const HexLattice &lattice, const HexJumps &jumps, LengthMetric metric, const TurnCosts &turns,
               Guidance guidance, const Point &start, const Point &goal);

    void useRings(int rings);

    /// From where a path begins to lying on the course of its first jump.
    double departure(CellIndex, std::size_t) const { return 0.0; }
    /// From the course of one jump to that of another, at a cell's centre.
    double turn(std::size_t from, std::size_t to) const { return bound_.turn(from, to); }
    /// Along a jump.
    double advance(std::size_t jump) const { return LengthWeight::jumpCost(0, 0, jump, 0); }
    /// From lying on a course at a goal cell's centre to the goal itself.
    double arrival(CellIndex, std::size_t, const GoalCell &goal) const { return goal.finish; }

    struct Approach : TurnBound::Approach
    {
        double finish;
    };

    /// A cell and a goal, for the bound.
    Approach approach(HexCoord cell, const GoalCell &goal) const;
    /// Lower bound to the goal, finish included, with a heading: a jump, or none yet (TurnBound).
    double boundFrom(const Approach &approach, std::size_t heading) const
    {
        return (knowsTurns_ ? bound_(approach, heading) : approach.norm) + approach.finish;
    }

private:
    TurnBound boundWithin(int rings) const;

    HexLattice lattice_;
    HexJumps jumps_;
    bool knowsTurns_;
    TurnCosts turns_;
    TurnBound bound_;
};

}  // namespace seahex
