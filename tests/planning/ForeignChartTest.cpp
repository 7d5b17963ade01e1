#include <seahex/planning/HexAStar.h>
#include <seahex/planning/SquareAStar.h>

#include "support/JumpKinds.h"
#include "support/PlanningWorlds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

/// What any planner would be asked: a chart of the other kind of cells. The planner's own cells are small enough for
/// every gap of the chart, so it finds a way exactly where there is one.
TEST(ForeignChart, IsAsked)
{
    int found = 0;
    int unreachable = 0;
    const auto solve =
        [&](auto &planner, const Occupancy &chart, const ob::ProblemDefinitionPtr &problem, bool isReachable)
    {
        planner.setCellSize(0.2 * chart.lattice().pitch());
        const ob::PlannerStatus status = planner.solve(ob::plannerNonTerminatingCondition());
        ASSERT_EQ(status == ob::PlannerStatus::EXACT_SOLUTION, isReachable);
        (isReachable ? found : unreachable) += 1;
        if (!isReachable)
            return;
        const auto path = pathOf(problem);
        ASSERT_TRUE(path->check());
        for (unsigned int i = 1; i < path->getStateCount(); ++i)
            ASSERT_GT(distanceToBlocked(chart, positionOf(path->getSpaceInformation(), path->getState(i - 1)),
                                        positionOf(path->getSpaceInformation(), path->getState(i))),
                      0.0L);
    };
    forEachSeed(60,
                [&](Random &random)
                {
                    const SpaceKind kind = random.chance(0.7) ? SpaceKind::Plane : SpaceKind::Pose;
                    const bool isSmoothed = random.chance(0.5);
                    const RandomWorld<SquareKind> squares(random);
                    const auto onSquares = problemBetween(chartSpace(squares.occupancy, kind),
                                                          squares.centre(squares.start), squares.centre(squares.goal));
                    const auto hexAStar = plannerFor<HexAStar>(onSquares);
                    hexAStar->setSmoothing(isSmoothed);
                    solve(*hexAStar, *squares.occupancy, onSquares,
                          std::isfinite(stepGraph(*squares.occupancy, 4)
                                            .cheapest({{vertexOf(squares.lattice, squares.start), 0.0}},
                                                      {{vertexOf(squares.lattice, squares.goal), 0.0}})));

                    const RandomWorld<HexKind> hexagons(random);
                    const auto onHexagons =
                        problemBetween(chartSpace(hexagons.occupancy, kind), hexagons.centre(hexagons.start),
                                       hexagons.centre(hexagons.goal));
                    const auto squareAStar = plannerFor<SquareAStar>(onHexagons);
                    squareAStar->setSmoothing(isSmoothed);
                    solve(*squareAStar, *hexagons.occupancy, onHexagons,
                          std::isfinite(jumpGraph(*hexagons.occupancy, 1, LengthMetric::Lattice)
                                            .cheapest({{vertexOf(hexagons.lattice, hexagons.start), 0.0}},
                                                      {{vertexOf(hexagons.lattice, hexagons.goal), 0.0}})));
                });
    EXPECT_GT(found, 40);
    EXPECT_GT(unreachable, 10);
}

}  // namespace
}  // namespace seahex::test
