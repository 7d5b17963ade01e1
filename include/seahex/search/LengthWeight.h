#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/search/GoalCells.h>
#include <seahex/search/Guidance.h>
#include <seahex/search/HexJumps.h>
#include <seahex/search/LengthAlgebra.h>

#include <cstdint>
#include <vector>

namespace seahex
{

/// What a jump costs.
enum class LengthMetric
{
    Euclidean,  ///< its straight length
    Lattice     ///< D of [Cheng2020] eq. 4: the number of steps between neighbours
};

/// Path length as the weight of a HexGraph, in pitches, for both metrics and every guidance.
///
/// The bound is exact: the norm that the jumps span (HexNorm), so with guidance Distance no cell is expanded whose
/// detour is longer than that of the best path, ties aside.
class LengthWeight : public LengthAlgebra
{
public:
    /// @param start, goal  of the guidance's line
    LengthWeight(const HexLattice &lattice, const HexJumps &jumps, LengthMetric metric, Guidance guidance,
                 const Point &start, const Point &goal);

    double jumpCost(CellIndex, CellIndex, std::size_t jump, std::uint8_t) const { return costs_[jump]; }
    void useRings(int rings) { rings_ = rings; }
    double bound(HexCoord cell, const GoalCell &goal) const;
    double tie(HexCoord cell, double bound) const;

private:
    HexLattice lattice_;
    int rings_;
    LengthMetric metric_;
    Guidance guidance_;
    Point start_;
    Point goal_;
    std::vector<double> costs_;
};

}  // namespace seahex
