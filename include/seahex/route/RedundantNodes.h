#pragma once

#include <seahex/route/Route.h>
#include <seahex/route/SegmentPredicate.h>

namespace seahex
{

/// The path smoothing of [Wang2017] section 3.2, for comparison with pullString: a node is redundant if the nodes
/// before and after it see each other.
///
/// From node i on, node i + 1 is dropped while no obstacle lies between i and i + 2, as they are counted then. When one
/// does, node i + 1 stays, and its own successors are looked at. One pass, from start to goal.
///
/// The text leaves open at which node it goes on once the line from i to j meets an obstacle: it names i, and then j -
/// 1, j and j + 1 as the next three. Read here as: j - 1 stays and becomes i. So does the program that the authors
/// published. That program differs in two points from the text, which rules here: it makes a second pass, and it takes
/// for an obstacle any blocked cell within 1.5 cells of the line, in the second pass 2. A margin is the predicate's to
/// say.
///
/// Guarantees: nodes of the input in their order, the first and the last among them; every leg that is not one of the
/// input was found valid; never longer than the input but for rounding. Neither the fewest nodes nor the shortest
/// route: it stops looking at the first obstacle, and moves no node. It may differ for the reversed route. Time: asks
/// the predicate once for each node but the first and the last.
Route dropRedundantNodes(const Route &route, const SegmentPredicate &isValid);

}  // namespace seahex
