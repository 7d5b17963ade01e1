#pragma once

#include <seahex/geometry/HexRing.h>
#include <seahex/search/Jumps.h>

#include <vector>

namespace seahex
{

/// Which successors a ring expansion tries.
enum class JumpSet
{
    /// Those that pass no other centre: 6, 12, 24. The others repeat collinear steps, so nothing is lost where jumps
    /// are safe and cost adds up along the line.
    Primitive,
    /// All 6, 18, 36, as published. Needed where a weight is charged on arrival; turn counts can differ.
    All
};

/// The jumps of a ring expansion on hexagons, [Cheng2020] eq. 11.
class HexJumps : public Jumps
{
public:
    /// @param rings  1, 2 or 3
    HexJumps(const CellLayout &layout, int rings, JumpSet set, JumpRule rule = JumpRule::Safe);

    const RingOffset &offset(std::size_t jump) const { return offsets_[jump]; }

private:
    std::vector<RingOffset> offsets_;
};

}  // namespace seahex
