#pragma once

#include "seahex/geometry/Lattice.h"
#include "seahex/search/Jumps.h"

#include <memory>

namespace seahex
{

/// Which jumps a planner makes on its lattice.
struct JumpChoice
{
    int rings = 1;          ///< on hexagons
    bool allJumps = false;  ///< on hexagons: those that repeat collinear ones too, whatever the objective
    int neighbours = 8;     ///< on squares
    JumpRule rule = JumpRule::Safe;
};

/// The table of these jumps.
/// @param addsUp  cost adds up along a line, so that jumps which repeat collinear ones may be left out
std::shared_ptr<const Jumps> makeJumps(const Lattice &lattice, const CellLayout &layout, const JumpChoice &choice,
                                       bool addsUp);

}  // namespace seahex
