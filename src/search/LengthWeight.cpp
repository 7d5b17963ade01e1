#include "seahex/search/LengthWeight.h"

#include "seahex/geometry/HexNorm.h"

namespace seahex
{

LengthWeight::LengthWeight(const HexLattice &lattice, const HexJumps &jumps, LengthMetric metric, Guidance guidance,
                           const Point &start, const Point &goal)
    : lattice_(lattice), rings_(jumps.rings()), metric_(metric), guidance_(guidance), start_(start), goal_(goal)
{
    for (std::size_t k = 0; k < jumps.size(); ++k)
        costs_.push_back(metric == LengthMetric::Lattice ? jumps.offset(k).ring : jumps.length(k));
}

double LengthWeight::bound(HexCoord cell, const GoalCell &goal) const
{
    const HexCoord difference = goal.cell - cell;
    switch (guidance_)
    {
        case Guidance::None:
            return 0.0;
        case Guidance::Cheng:
            return static_cast<double>(hexNorm(difference)) * pilotQuantity(start_, goal_, lattice_.centre(cell)) +
                   goal.finish;
        case Guidance::Distance:
        case Guidance::TieBreak:
            break;
    }
    const double norm =
        metric_ == LengthMetric::Lattice ? static_cast<double>(hexNorm(difference)) : ringNorm(difference, rings_);
    return norm + goal.finish;
}

double LengthWeight::tie(HexCoord cell, double bound) const
{
    // Without a line to keep to, the cell nearest to the goal: of equal estimates it is the deepest.
    return guidance_ == Guidance::TieBreak ? distanceFromLine(start_, goal_, lattice_.centre(cell)) : bound;
}

}  // namespace seahex
