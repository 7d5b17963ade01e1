#include "planning/MakeGraphQuery.h"
#include "seahex/search/SafetyLengthWeight.h"

namespace seahex
{
namespace
{

template <class Norm>
std::unique_ptr<LatticeQuery> makeOn(const typename Norm::KnownLattice &lattice, std::unique_ptr<QueryParts> parts)
{
    return makeGraphQuery<SafetyLengthWeight<Norm>>(std::move(parts),
                                                    [&](const QueryParts &p) {
                                                        return SafetyLengthWeight<Norm>(lattice, p.jumps, *p.safety,
                                                                                        p.question.guidance,
                                                                                        p.firstStart(), p.firstGoal());
                                                    });
}

}  // namespace

std::unique_ptr<LatticeQuery> makeSafetyQuery(std::unique_ptr<QueryParts> parts)
{
    const Lattice lattice = parts->question.lattice;
    if (lattice.hexagons() != nullptr)
        return makeOn<HexJumpNorm>(*lattice.hexagons(), std::move(parts));
    return makeOn<SquareJumpNorm>(*lattice.squares(), std::move(parts));
}

}  // namespace seahex
