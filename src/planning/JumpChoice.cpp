#include "planning/JumpChoice.h"

#include "seahex/search/HexJumps.h"
#include "seahex/search/SquareJumps.h"

namespace seahex
{

std::shared_ptr<const Jumps> makeJumps(const Lattice &lattice, const CellLayout &layout, const JumpChoice &choice,
                                       bool addsUp)
{
    if (lattice.squares() != nullptr)
        return std::make_shared<const SquareJumps>(layout, choice.neighbours, choice.rule);
    // a hop over blocked cells has no chain of shorter ones in its place
    const bool canRepeat = addsUp && choice.rule == JumpRule::Safe;
    const JumpSet set = choice.allJumps || !canRepeat ? JumpSet::All : JumpSet::Primitive;
    return std::make_shared<const HexJumps>(layout, choice.rings, set, choice.rule);
}

}  // namespace seahex
