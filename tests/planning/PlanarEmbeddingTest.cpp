#include <seahex/planning/HexAStar.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>
#include <seahex/planning/PlanarEmbedding.h>
#include <seahex/planning/RouteFromPath.h>
#include <seahex/planning/Setup.h>

#include "support/AsciiWorld.h"
#include "support/PlanningWorlds.h"

#include <ompl/base/objectives/MinimaxObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/DubinsStateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SE3StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>
#include <ompl/util/Exception.h>

#include <gtest/gtest.h>

#include <cmath>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

const Box box{Point(-3.0, 2.0), Point(5.0, 12.0)};

/// Spaces whose states have no place on a lattice, or that do not move along straight lines.
std::vector<ob::StateSpacePtr> otherSpaces()
{
    auto compound = std::make_shared<ob::CompoundStateSpace>();
    compound->addSubspace(std::make_shared<ob::RealVectorStateSpace>(2), 1.0);
    return {std::make_shared<ob::RealVectorStateSpace>(1),
            std::make_shared<ob::RealVectorStateSpace>(3),
            std::make_shared<ob::DubinsStateSpace>(),
            std::make_shared<ob::ReedsSheppStateSpace>(),
            std::make_shared<ob::SO2StateSpace>(),
            std::make_shared<ob::SE3StateSpace>(),
            compound};
}

TEST(PlanarEmbedding, ReadsAndWritesThePlane)
{
    const ob::StateSpacePtr space = spaceWithin(box, SpaceKind::Plane);
    const PlanarEmbedding embedding(space.get());
    ob::ScopedState<ob::RealVectorStateSpace> state(space);
    embedding.place(state.get(), Point(1.5, -2.5), 3.0);
    EXPECT_EQ(state[0], 1.5);
    EXPECT_EQ(state[1], -2.5);
    EXPECT_EQ(embedding.position(state.get()), Point(1.5, -2.5));
    EXPECT_FALSE(embedding.hasHeading());
    EXPECT_EQ(embedding.heading(state.get()), 0.0);
    EXPECT_EQ(embedding.bounds().min, box.min);
    EXPECT_EQ(embedding.bounds().max, box.max);
    EXPECT_EQ(embedding.lengthWeight(), 1.0);
}

TEST(PlanarEmbedding, ReadsAndWritesPoses)
{
    const ob::StateSpacePtr space = spaceWithin(box, SpaceKind::Pose);
    const PlanarEmbedding embedding(space.get());
    ob::ScopedState<ob::SE2StateSpace> state(space);
    embedding.place(state.get(), Point(1.5, -2.5), 0.75);
    EXPECT_EQ(state->getX(), 1.5);
    EXPECT_EQ(state->getY(), -2.5);
    EXPECT_EQ(state->getYaw(), 0.75);
    EXPECT_EQ(embedding.heading(state.get()), 0.75);
    EXPECT_EQ(embedding.position(state.get()), Point(1.5, -2.5));
    EXPECT_TRUE(embedding.hasHeading());
    EXPECT_EQ(embedding.bounds().min, box.min);
    EXPECT_EQ(embedding.bounds().max, box.max);
    EXPECT_EQ(embedding.lengthWeight(), space->as<ob::SE2StateSpace>()->getSubspaceWeight(0));
}

TEST(PlanarEmbedding, EveryHeadingIsWithinTheBoundsOfItsSpace)
{
    const ob::StateSpacePtr space = spaceWithin(box, SpaceKind::Pose);
    const PlanarEmbedding embedding(space.get());
    ob::ScopedState<ob::SE2StateSpace> state(space);
    // due west is pi for atan2, and SO2StateSpace leaves either pi or -pi out
    for (const double heading : {std::atan2(0.0, -1.0), std::atan2(-0.0, -1.0), 7.0, -100.0})
    {
        embedding.place(state.get(), Point(0.0, 3.0), heading);
        EXPECT_TRUE(space->satisfiesBounds(state.get())) << heading;
        EXPECT_NEAR(std::cos(state->getYaw()), std::cos(heading), 1e-12);
        EXPECT_NEAR(std::sin(state->getYaw()), std::sin(heading), 1e-12);
    }
}

TEST(PlanarEmbedding, RefusesOtherSpaces)
{
    EXPECT_THROW(PlanarEmbedding(nullptr), ompl::Exception);
    for (const ob::StateSpacePtr &space : otherSpaces())
        EXPECT_THROW(PlanarEmbedding(space.get()), ompl::Exception) << space->getName();
}

TEST(PlanarEmbedding, NothingOfOursTakesOtherSpaces)
{
    const AsciiWorld world(". . .");
    for (const ob::StateSpacePtr &space : otherSpaces())
    {
        SCOPED_TRACE(space->getName());
        const auto si = std::make_shared<ob::SpaceInformation>(space);
        EXPECT_THROW(HexAStar planner(si), ompl::Exception);
        EXPECT_THROW(OccupancyValidityChecker(si, world.shared()), ompl::Exception);
        EXPECT_THROW(OccupancyMotionValidator(si, world.shared()), ompl::Exception);
        EXPECT_THROW(LatticeLengthObjective(si, world.lattice()), ompl::Exception);
        og::SimpleSetup setup(si);
        EXPECT_THROW(useOccupancy(setup, world.shared()), ompl::Exception);
        EXPECT_THROW(setStartAndGoal(setup, Point(0, 0), Point(1, 1)), ompl::Exception);
    }
}

TEST(Setup, SolvesAChartInAFewLines)
{
    const AsciiWorld world(R"(
         A . # .
        . . # .
         . . . B
    )");
    og::SimpleSetup setup(planarSpace(world.occupancy()));
    useOccupancy(setup, world.shared());
    setStartAndGoal(setup, world.centre('A'), world.centre('B'));
    setup.setPlanner(std::make_shared<HexAStar>(setup.getSpaceInformation()));
    ASSERT_EQ(setup.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(setup.getSolutionPath().check());
    ompl::geometric::PathGeometric path = setup.getSolutionPath();
    path.append(path.getState(0));
    path.append(path.getState(0));
    path.append(setup.getSolutionPath());
    const Route route = routeFromPath(path);
    EXPECT_EQ(route.waypoints().size(), path.getStateCount() - 2) << "one place is one waypoint";
    EXPECT_EQ(route.waypoints().front(), world.centre('A'));
    EXPECT_EQ(route.waypoints().back(), world.centre('B'));
}

TEST(Setup, KeepsAnObjectiveThatIsThere)
{
    const AsciiWorld world(". . .");
    og::SimpleSetup setup(planarSpace(world.occupancy()));
    const auto objective = std::make_shared<ob::MinimaxObjective>(setup.getSpaceInformation());
    setup.setOptimizationObjective(objective);
    useOccupancy(setup, world.shared());
    EXPECT_EQ(setup.getOptimizationObjective(), objective);

    og::SimpleSetup plain(planarSpace(world.occupancy()));
    useOccupancy(plain, world.shared());
    EXPECT_NE(dynamic_cast<ob::PathLengthOptimizationObjective *>(plain.getOptimizationObjective().get()), nullptr);
}

TEST(LatticeLengthObjective, CountsStepsAndItsHeuristicNeverExceedsAnyWay)
{
    Random random(11);
    SCOPED_TRACE(random.seedText());
    const HexLattice lattice(Point(-40.0, 25.0), 2.5, 12, 9);
    const auto si = chartSpace(occupancyWith(lattice, {}));
    const LatticeLengthObjective objective(si, lattice);
    for (int i = 0; i < 200; ++i)
    {
        const HexCoord a = random.cellOf(lattice);
        const HexCoord b = random.cellOf(lattice);
        const auto from = stateAt(si, lattice.centre(a));
        const auto to = stateAt(si, lattice.centre(b));
        const double steps = static_cast<double>(hexDistance(a, b));
        EXPECT_NEAR(objective.motionCost(from.get(), to.get()).value(), steps, 1e-9);
        const double bound = objective.motionCostHeuristic(from.get(), to.get()).value();
        EXPECT_NEAR(bound, steps, 1e-7);
        EXPECT_LE(bound, objective.motionCost(from.get(), to.get()).value());
        const auto between = stateAt(si, random.pointIn(lattice.bounds()));
        const double over = objective.motionCost(from.get(), between.get()).value() +
                            objective.motionCost(between.get(), to.get()).value();
        EXPECT_LE(bound, over);
        // half way on the line itself, where rounding decides
        ob::ScopedState<> middle(si);
        si->getStateSpace()->interpolate(from.get(), to.get(), random.unit(), middle.get());
        EXPECT_LE(bound, objective.motionCost(from.get(), middle.get()).value() +
                             objective.motionCost(middle.get(), to.get()).value());
    }
    EXPECT_EQ(objective.stateCost(stateAt(si, Point(0, 0)).get()).value(), 0.0);
}

}  // namespace
}  // namespace seahex::test
