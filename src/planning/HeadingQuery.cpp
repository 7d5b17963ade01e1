#include "planning/HeadingQuery.h"

#include "planning/QueryKinds.h"

namespace seahex
{

std::unique_ptr<LatticeQuery> makeHeadingQuery(std::unique_ptr<QueryParts> parts)
{
    const Lattice lattice = parts->question.lattice;
    if (lattice.hexagons() != nullptr)
        return std::make_unique<HeadingQuery<HexJumpNorm>>(std::move(parts), *lattice.hexagons());
    return std::make_unique<HeadingQuery<SquareJumpNorm>>(std::move(parts), *lattice.squares());
}

}  // namespace seahex
