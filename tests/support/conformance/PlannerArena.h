#pragma once

#include "support/PlanningWorlds.h"
#include "support/conformance/Census.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace seahex::test
{

/// Where a planner is tried: obstacles, the space that states belong to, and places of which it is known how they lie.
///
/// The obstacles are an occupancy's blocked cells, which a planner may read, or discs behind a checker of the user's
/// and OMPL's own motion validator.
struct PlannerArena
{
    std::string name;
    Box bounds;
    std::shared_ptr<const Occupancy> chart;  ///< nullptr where the obstacles are discs
    Discs discs;
    /// Between A, B, C and D there is a way. X is blocked, E free and cut off from the others: not every arena has
    /// them. O lies out of bounds.
    std::map<char, Point> places;
    std::function<ompl::base::StateSpacePtr(const PlannerArena &, const CensusPtr &)> makeSpace;

    bool has(char place) const { return places.count(place) > 0; }

    /// Judges a straight leg with no help of the library's: cell by cell by CellOracle, or disc by disc. Discs count
    /// with 0.97 of their radius, because OMPL's validator looks at points of a leg only.
    bool isClear(const Point &a, const Point &b) const;

    /// Is there a way? By flooding the chart's free cells. Discs can't be asked.
    bool areJoined(const Point &a, const Point &b) const;

    /// A free point.
    Point somewhere(Random &random) const;
};

/// A bay with a lagoon, a long strait one cell wide, open water, a random archipelago, a larger one, all of hexagons; a
/// "square" bay, strait and archipelago of squares; and discs: each in every planar space that it can be in. "columns
/// in R3": the discs, as high as R^3 is.
const std::vector<PlannerArena> &plannerArenas();

/// Told of every state that a user's checker is asked for.
using QuestionHook = std::function<void()>;

/// The arena's problem, set up: its space, validity checker and motion validator.
/// @param onQuestion  called where the obstacles are discs
ompl::base::SpaceInformationPtr spaceInformation(const PlannerArena &arena, const CensusPtr &census,
                                                 const QuestionHook &onQuestion);

}  // namespace seahex::test
