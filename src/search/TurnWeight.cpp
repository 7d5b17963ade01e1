#include "seahex/search/TurnWeight.h"

namespace seahex
{

TurnWeight::TurnWeight(const HexLattice &lattice, const HexJumps &jumps, LengthMetric metric, const TurnCosts &turns,
                       Guidance guidance, const Point &start, const Point &goal)
    : LengthWeight(lattice, jumps, metric, guidance, start, goal), lattice_(lattice), jumps_(jumps),
      knowsTurns_(guidance == Guidance::Distance || guidance == Guidance::TieBreak), turns_(turns),
      bound_(boundWithin(jumps.rings()))
{
}

void TurnWeight::useRings(int rings)
{
    LengthWeight::useRings(rings);
    bound_ = boundWithin(rings);
}

TurnWeight::Approach TurnWeight::approach(HexCoord cell, const GoalCell &goal) const
{
    if (!knowsTurns_)
    {
        Approach result{{}, 0.0};
        result.norm = LengthWeight::bound(cell, goal);
        return result;
    }
    const Point difference = (lattice_.centre(goal.cell) - lattice_.centre(cell)) / lattice_.pitch();
    return {bound_.approach(difference, LengthWeight::bound(cell, {goal.cell, 0.0})), goal.finish};
}

TurnBound TurnWeight::boundWithin(int rings) const
{
    std::vector<Point> vectors;
    std::vector<double> costs;
    for (std::size_t k = 0; k < jumps_.countWithin(rings); ++k)
    {
        vectors.push_back((lattice_.centre(jumps_.offset(k).offset) - lattice_.centre({0, 0})) / lattice_.pitch());
        costs.push_back(advance(k));
    }
    return {std::move(vectors), std::move(costs), turns_};
}

}  // namespace seahex
