#pragma once

#include <seahex/search/GoalCells.h>
#include <seahex/search/Guidance.h>
#include <seahex/search/JumpNorm.h>
#include <seahex/search/Jumps.h>
#include <seahex/search/LengthAlgebra.h>

#include <cstdint>
#include <vector>

namespace seahex
{

/// What a jump costs.
enum class LengthMetric
{
    Euclidean,  ///< its straight length
    Lattice     ///< the number of steps between neighbours, D of [Cheng2020] eq. 4; on squares the octile distance
};

/// Path length as the weight of a JumpGraph, in pitches, for both metrics and every guidance.
///
/// The bound of guidance Distance is exact: the norm that the jumps span (JumpNorm), so no cell is expanded whose
/// detour is longer than that of the best path, ties aside.
/// @tparam Norm  HexJumpNorm or SquareJumpNorm
template <class Norm>
class LatticeLengthWeight : public LengthAlgebra
{
public:
    /// @param start, goal  of the guidance's line
    LatticeLengthWeight(const typename Norm::KnownLattice &lattice, const Jumps &jumps, LengthMetric metric,
                        Guidance guidance, const Point &start, const Point &goal)
        : norm_(lattice, jumps), metric_(metric), guidance_(guidance), start_(start), goal_(goal)
    {
        for (std::size_t k = 0; k < jumps.size(); ++k)
            costs_.push_back(metric == LengthMetric::Lattice ? jumps.steps(k) : jumps.length(k));
    }

    double jumpCost(CellIndex, CellIndex, std::size_t jump, std::uint8_t) const { return costs_[jump]; }
    void useRings(int rings) { norm_.useRings(rings); }

    double bound(OffsetCoord cell, const GoalCell &goal) const
    {
        switch (guidance_)
        {
            case Guidance::None:
                return 0.0;
            case Guidance::Euclidean:
                return flight(cell, goal) + goal.finish;
            case Guidance::Cheng:
                return norm_.steps(cell, goal.cell) * pilotQuantity(start_, goal_, norm_.centre(cell)) + goal.finish;
            case Guidance::Wang:
                return flight(cell, goal) * pilotQuantity(start_, goal_, norm_.centre(cell)) + goal.finish;
            case Guidance::Distance:
            case Guidance::TieBreak:
                break;
        }
        return (metric_ == LengthMetric::Lattice ? norm_.steps(cell, goal.cell) : norm_.length(cell, goal.cell)) +
               goal.finish;
    }

    /// Without a line to keep to, the cell nearest to the goal: of equal estimates it is the deepest.
    double tie(OffsetCoord cell, double bound) const
    {
        return guidance_ == Guidance::TieBreak ? distanceFromLine(start_, goal_, norm_.centre(cell)) : bound;
    }

private:
    double flight(OffsetCoord cell, const GoalCell &goal) const
    {
        return (norm_.centre(goal.cell) - norm_.centre(cell)).norm() / norm_.pitch();
    }

    Norm norm_;
    LengthMetric metric_;
    Guidance guidance_;
    Point start_;
    Point goal_;
    std::vector<double> costs_;
};

using LengthWeight = LatticeLengthWeight<HexJumpNorm>;
using SquareLengthWeight = LatticeLengthWeight<SquareJumpNorm>;

}  // namespace seahex
