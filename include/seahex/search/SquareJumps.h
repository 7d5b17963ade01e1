#pragma once

#include <seahex/search/Jumps.h>

namespace seahex
{

/// The steps of a search on squares: to the 4 neighbours that share an edge, or to these and the 4 diagonal ones,
/// counter-clockwise from east, those that share an edge first.
class SquareJumps : public Jumps
{
public:
    /// @param neighbours  4 or 8
    /// @param rule  Safe: a diagonal step needs both cells beside it; Hopping: it may cut corners
    /// @throws std::domain_error for another number of neighbours
    SquareJumps(const CellLayout &layout, int neighbours, JumpRule rule = JumpRule::Safe);
};

}  // namespace seahex
