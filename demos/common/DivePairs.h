#pragma once

#include "Pairs.h"

#include <seahex/geometry/Point3.h>
#include <seahex/world/DiveArena.h>

#include <vector>

namespace demos
{

/// A start and a goal in the water.
struct DivePair
{
    unsigned number = 0;  ///< from 1
    seahex::Point3 start;
    seahex::Point3 goal;
    bool isSeabedInTheWay = false;  ///< of the straight line between the two

    /// Where the two lie on the chart.
    Pair onChart() const { return {number, seahex::horizontal(start), seahex::horizontal(goal)}; }
};

/// Draws start-goal pairs for planners of dives as drawPairs() does, each at any depth that is free there: between the
/// ceiling and the clearance above the seabed. Both lie over the largest water that is deep enough (DeepWater), so that
/// there is a dive between them. Where the rules need a detour, a pair with the seabed in the way is taken if one is
/// among the first hundred that would do otherwise, else the first of these.
/// @param arena  without columns to keep out of
/// @throws Failure (Exit::NotNavigable) if a sector has no such pair
std::vector<DivePair> drawDivePairs(const seahex::DiveArena &arena, const PairRules &rules);

}  // namespace demos
