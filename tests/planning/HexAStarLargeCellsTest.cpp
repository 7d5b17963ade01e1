// On lattices large enough for it HexAStar begins with paths through large cells.

#include <seahex/planning/HexAStar.h>
#include <seahex/world/SegmentValidity.h>

#include "support/AsciiWorld.h"
#include "support/CellOracle.h"
#include "support/PlanningWorlds.h"
#include "support/Random.h"

#include <gtest/gtest.h>

#include <vector>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

/// A wide water with round islands.
std::shared_ptr<const HexOccupancy> archipelago(Random &random)
{
    const HexLattice lattice(Point(10.0, 20.0), 2.0, 320, 330);
    std::vector<HexCoord> land;
    for (int i = 0; i < 40; ++i)
    {
        const Point middle = lattice.centre(random.cellOf(lattice));
        const double radius = random.real(4.0, 70.0);
        forEachCell(lattice, 0,
                    [&](HexCoord cell)
                    {
                        if ((lattice.centre(cell) - middle).norm() < radius)
                            land.push_back(cell);
                    });
    }
    return occupancyWith(lattice, land);
}

std::vector<Point> pointsOf(const ob::SpaceInformationPtr &si, const std::vector<const ob::State *> &states)
{
    std::vector<Point> points;
    for (const ob::State *state : states)
        points.push_back(positionOf(si, state));
    return points;
}

void expectFree(const Occupancy &occupancy, const std::vector<Point> &points)
{
    for (std::size_t i = 1; i < points.size(); ++i)
        EXPECT_TRUE(isFree(occupancy, points[i - 1], points[i]));
}

std::vector<Point> pathPoints(const ob::ProblemDefinitionPtr &problem)
{
    const auto path = pathOf(problem);
    std::vector<const ob::State *> states(path->getStates().begin(), path->getStates().end());
    return pointsOf(problem->getSpaceInformation(), states);
}

}  // namespace

TEST(HexAStarLargeCells, RoughPathsComeFirstAndAreNotWorseInTheEnd)
{
    int early = 0;
    forEachSeed(8,
                [&](Random &random)
                {
                    const auto world = archipelago(random);
                    const auto si = chartSpace(world);
                    const auto problem = problemBetween(si, freePoint(random, *world), freePoint(random, *world));
                    auto plain = std::make_shared<HexAStar>(si);
                    plain->setAnytime(false);
                    plain->setProblemDefinition(problem);
                    const ob::PlannerStatus status = plain->solve(20.0);
                    const double cost = status ? pathOf(problem)->length() : 0.0;
                    problem->clearSolutionPaths();

                    auto planner = std::make_shared<HexAStar>(si);
                    planner->setProblemDefinition(problem);
                    std::vector<double> costs;
                    problem->setIntermediateSolutionCallback(
                        [&](const ob::Planner *, const std::vector<const ob::State *> &states, ob::Cost now)
                        {
                            EXPECT_TRUE(costs.empty() || now.value() < costs.back());
                            costs.push_back(now.value());
                            expectFree(*world, pointsOf(si, states));
                        });
                    const ob::PlannerStatus again = planner->solve(20.0);
                    problem->setIntermediateSolutionCallback({});
                    EXPECT_EQ(ob::PlannerStatus::StatusType(again), ob::PlannerStatus::StatusType(status));
                    if (!status)
                        return;
                    EXPECT_LE(pathOf(problem)->length(), cost * (1.0 + 1e-12));
                    EXPECT_EQ(planner->outcome(), PlanningOutcome::Found);
                    expectFree(*world, pathPoints(problem));

                    // stopped before a cell of the chart was expanded
                    problem->clearSolutionPaths();
                    auto hasty = std::make_shared<HexAStar>(si);
                    hasty->setProblemDefinition(problem);
                    hasty->setup();
                    const ob::PlannerTerminationCondition whenFound([&] { return !hasty->improvements().empty(); });
                    if (hasty->solve(whenFound) && hasty->counters().expanded == 0)
                        ++early;
                    expectFree(*world, pathPoints(problem));
                    const double before = pathOf(problem)->length();
                    problem->clearSolutionPaths();
                    EXPECT_TRUE(hasty->solve(20.0));
                    EXPECT_LE(pathOf(problem)->length(), before);
                    EXPECT_NEAR(pathOf(problem)->length(), planner->improvements().back().cost, 1e-9 * cost);
                });
    EXPECT_GE(early, 5);
}

TEST(HexAStarLargeCells, TheSecondProblemIsAnsweredAsByAFreshPlanner)
{
    Random random(3);
    const auto world = archipelago(random);
    const auto si = chartSpace(world);
    auto kept = std::make_shared<HexAStar>(si);
    for (int i = 0; i < 6; ++i)
    {
        const auto problem = problemBetween(si, freePoint(random, *world), freePoint(random, *world));
        auto fresh = std::make_shared<HexAStar>(si);
        fresh->setProblemDefinition(problem);
        const ob::PlannerStatus status = fresh->solve(20.0);
        const std::vector<Point> expected = status ? pathPoints(problem) : std::vector<Point>();
        problem->clearSolutionPaths();
        kept->clear();
        kept->setProblemDefinition(problem);
        kept->setRings(1 + i % 3);
        kept->setRings(3);
        EXPECT_EQ(ob::PlannerStatus::StatusType(kept->solve(20.0)), ob::PlannerStatus::StatusType(status));
        EXPECT_EQ(status ? pathPoints(problem) : std::vector<Point>(), expected);
        EXPECT_EQ(kept->counters().expanded, fresh->counters().expanded);
    }
}

}  // namespace seahex::test
