#pragma once

#include <seahex/search/GoalCells.h>
#include <seahex/search/Guidance.h>
#include <seahex/search/JumpNorm.h>
#include <seahex/search/Jumps.h>
#include <seahex/search/LengthAlgebra.h>
#include <seahex/search/RelaxedGuide.h>

#include <cstdint>
#include <memory>
#include <utility>
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
/// detour is longer than that of the best path, ties aside. Guidance Relaxed raises it by what an occupancy says.
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
        rings_ = jumps.rings();
        for (std::size_t k = 0; k < jumps.size(); ++k)
            costs_.push_back(metric == LengthMetric::Lattice ? jumps.steps(k) : jumps.length(k));
    }

    /// What guidance Relaxed must know; without it, it is Distance. The goal cell is that of the guidance's line.
    /// @param occupancy  every jump of the search touches cells that are free there, and no others
    void setOccupancy(std::shared_ptr<const Occupancy> occupancy)
    {
        if (guidance_ != Guidance::Relaxed || !occupancy)
            return;
        const OffsetCoord start = occupancy->lattice().cellAt(start_);
        const OffsetCoord goal = occupancy->lattice().cellAt(goal_);
        guide_ = RelaxedGuide(std::move(occupancy), start, goal, relaxedRings());
    }

    double jumpCost(CellIndex, CellIndex, std::size_t jump, std::uint8_t) const { return costs_[jump]; }
    void useRings(int rings)
    {
        rings_ = rings;
        norm_.useRings(rings);
        guide_.useRings(relaxedRings());
    }
    bool sharpen(std::uint64_t expanded) { return guide_.sharpen(expanded); }

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
            case Guidance::Relaxed:
            case Guidance::Automatic:
                break;
        }
        const double norm =
            metric_ == LengthMetric::Lattice ? norm_.steps(cell, goal.cell) : norm_.length(cell, goal.cell);
        return guide_.raise(norm, cell) + goal.finish;
    }

    /// Without a line to keep to, the cell nearest to the goal: of equal estimates it is the deepest.
    double tie(OffsetCoord cell, double bound) const
    {
        return guidance_ == Guidance::TieBreak ? distanceFromLine(start_, goal_, norm_.centre(cell)) : bound;
    }

private:
    /// No ring shortens the number of steps.
    int relaxedRings() const { return metric_ == LengthMetric::Lattice ? 1 : rings_; }

    double flight(OffsetCoord cell, const GoalCell &goal) const
    {
        return (norm_.centre(goal.cell) - norm_.centre(cell)).norm() / norm_.pitch();
    }

    Norm norm_;
    LengthMetric metric_;
    Guidance guidance_;
    Point start_;
    Point goal_;
    int rings_ = 1;
    RelaxedGuide guide_;
    std::vector<double> costs_;
};

using LengthWeight = LatticeLengthWeight<HexJumpNorm>;
using SquareLengthWeight = LatticeLengthWeight<SquareJumpNorm>;

}  // namespace seahex
