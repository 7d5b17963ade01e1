#pragma once

#include <seahex/search/LengthWeight.h>
#include <seahex/world/SafetyWeights.h>

namespace seahex
{

/// The cost of sailing of [Wang2017] eq. 1 as the weight of a JumpGraph: a jump's Euclidean length, in pitches, times
/// the safety weight of the cell where it ends. No cell weighs less than 1, so the bounds of lengths hold.
/// @tparam Norm  HexJumpNorm or SquareJumpNorm
template <class Norm>
class SafetyLengthWeight : public LatticeLengthWeight<Norm>
{
public:
    /// @param weights  of the searched occupancy; must outlive the weight
    SafetyLengthWeight(const typename Norm::KnownLattice &lattice, const Jumps &jumps, const SafetyWeights &weights,
                       Guidance guidance, const Point &start, const Point &goal)
        : LatticeLengthWeight<Norm>(lattice, jumps, LengthMetric::Euclidean, guidance, start, goal), weights_(weights)
    {
    }

    double jumpCost(CellIndex from, CellIndex to, std::size_t jump, std::uint8_t arrivedBy) const
    {
        return LatticeLengthWeight<Norm>::jumpCost(from, to, jump, arrivedBy) * weights_.weightAt(to);
    }

private:
    const SafetyWeights &weights_;
};

}  // namespace seahex
