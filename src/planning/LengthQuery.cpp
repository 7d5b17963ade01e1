#include "planning/MakeGraphQuery.h"
#include "seahex/search/LengthWeight.h"

namespace seahex
{
namespace
{

template <class Norm>
std::unique_ptr<LatticeQuery> makeOn(const typename Norm::KnownLattice &lattice, std::unique_ptr<QueryParts> parts)
{
    return makeGraphQuery<LatticeLengthWeight<Norm>>(
        std::move(parts),
        [&](const QueryParts &p)
        {
            LatticeLengthWeight<Norm> weight(lattice, p.jumps, *p.metric, p.question.guidance, p.firstStart(),
                                             p.firstGoal());
            if (p.question.jumps.rule == JumpRule::Safe && p.question.goals.size() == 1)
                weight.setOccupancy(p.question.occupancy);
            return weight;
        });
}

}  // namespace

std::unique_ptr<LatticeQuery> makeLengthQuery(std::unique_ptr<QueryParts> parts)
{
    const Lattice lattice = parts->question.lattice;
    if (lattice.hexagons() != nullptr)
        return makeOn<HexJumpNorm>(*lattice.hexagons(), std::move(parts));
    return makeOn<SquareJumpNorm>(*lattice.squares(), std::move(parts));
}

}  // namespace seahex
