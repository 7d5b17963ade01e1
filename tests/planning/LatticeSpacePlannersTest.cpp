#include <seahex/planning/HexStateSpace.h>
#include <seahex/planning/PlanarEmbedding.h>
#include <seahex/planning/RouteFromPath.h>
#include <seahex/planning/Setup.h>

#include "support/AsciiWorld.h"
#include "support/PlanningWorlds.h"

#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

using MakePlanner = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr &)>;

template <class Planner>
ob::PlannerPtr make(const ob::SpaceInformationPtr &si)
{
    return std::make_shared<Planner>(si);
}

const std::vector<MakePlanner> planners = {make<og::RRTConnect>, make<og::RRTstar>,         make<og::PRM>,
                                           make<og::PRMstar>,    make<og::InformedRRTstar>, make<og::BITstar>};

/// The cells that can be reached from one by steps between free neighbours.
std::set<HexCoord> reachableFrom(const HexOccupancy &occupancy, HexCoord start)
{
    std::set<HexCoord> reached = {start};
    std::vector<HexCoord> open = {start};
    while (!open.empty())
    {
        const HexCoord cell = open.back();
        open.pop_back();
        for (const HexCoord step : {HexCoord{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}})
            if (occupancy.isFree(cell + step) && reached.insert(cell + step).second)
                open.push_back(cell + step);
    }
    return reached;
}

og::SimpleSetup setupFor(const std::shared_ptr<const HexOccupancy> &occupancy, const Point &start, const Point &goal)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    og::SimpleSetup setup(latticeSpace(*occupancy));
    useOccupancy(setup, occupancy);
    setStartAndGoal(setup, start, goal);
    return setup;
}

/// Lets a planner search until it has a path, which a busy machine may take a while for, and a little longer.
bool isSolved(og::SimpleSetup &setup)
{
    for (int i = 0; i < 60; ++i)
        if (setup.solve(0.05) == ob::PlannerStatus::EXACT_SOLUTION)
            return setup.solve(0.03) == ob::PlannerStatus::EXACT_SOLUTION;
    return false;
}

/// Solves with each planner and holds every path found against brute force.
/// @return how many planners found one
int solveWithAll(const std::shared_ptr<const HexOccupancy> &occupancy, HexCoord start, HexCoord goal)
{
    const HexLattice &lattice = occupancy->lattice();
    int solved = 0;
    for (const MakePlanner &makePlanner : planners)
    {
        og::SimpleSetup setup = setupFor(occupancy, lattice.centre(start), lattice.centre(goal));
        setup.setPlanner(makePlanner(setup.getSpaceInformation()));
        SCOPED_TRACE(setup.getPlanner()->getName());
        if (!isSolved(setup))
            continue;
        ++solved;
        const og::PathGeometric &path = setup.getSolutionPath();
        EXPECT_TRUE(path.check());
        EXPECT_EQ(path.getState(0)->as<HexStateSpace::StateType>()->cell(), start);
        EXPECT_EQ(
            path.getState(static_cast<unsigned int>(path.getStateCount()) - 1)->as<HexStateSpace::StateType>()->cell(),
            goal);
        const std::vector<Point> waypoints = routeFromPath(path).waypoints();
        double length = 0.0;
        for (std::size_t i = 1; i < waypoints.size(); ++i)
        {
            EXPECT_GT(distanceToBlocked(*occupancy, waypoints[i - 1], waypoints[i]), 0.0L);
            length += (waypoints[i] - waypoints[i - 1]).norm();
        }
        const double rounding = 2e-9 * length + 1e-15 * lattice.northWest().cwiseAbs().maxCoeff();
        EXPECT_NEAR(path.length(), length, rounding);
        EXPECT_GE(length, (lattice.centre(goal) - lattice.centre(start)).norm() - rounding);
    }
    return solved;
}

TEST(LatticeSpacePlanners, SolveSmallWorlds)
{
    const AsciiWorld gap(R"(
         A . . . . # . . . . B
        . . . . . # . . . . .
         . . . . . # . . . . .
        . . . . . . . . . . .
         . . . . . # . . . . .
    )");
    const AsciiWorld spiral(R"(
         . . . . . . . . .
        . # # # # # # # .
         . # . . . . . # .
        . # . # # # . # .
         . # . # B . . # .
        . # . # # # # # .
         . # . . . . . . .
        . # # # # # # # #
         . . . . . . . . A
    )",
                            250.0, Point(1e5, -2e5));
    // start, goal and the cells between them in one row, which no straight line goes along
    const AsciiWorld row(R"(
         # # # # # # # # . . . . .
        # # # # # # # # . . . . .
         A . . . . . . . . # . . B
    )",
                         2.7, Point(3e4, 7e4));
    for (const AsciiWorld &world : {gap, spiral, row})
        EXPECT_GE(solveWithAll(world.shared(), world.cell('A'), world.cell('B')), static_cast<int>(planners.size()) - 1)
            << "all but BIT*, rarely: its k nearest states may be copies of one cell" << toPicture(world.occupancy());
}

TEST(LatticeSpacePlanners, SolveRandomWorlds)
{
    int solved = 0;
    constexpr int worlds = 5;
    for (std::uint64_t seed = 1; seed <= worlds; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice(Point(random.real(-1e4, 1e4), random.real(-1e4, 1e4)), random.real(0.5, 50.0), 22, 25);
        const auto occupancy = randomOccupancy(random, lattice, 0.2);
        std::set<HexCoord> water;
        while (water.size() < 300)
            water = reachableFrom(*occupancy, lattice.cellAt(freePoint(random, *occupancy)));
        solved += solveWithAll(occupancy, *water.begin(), *water.rbegin());
    }
    EXPECT_GE(solved, worlds * (static_cast<int>(planners.size()) - 1));
}

TEST(LatticeSpacePlanners, FindNoPathWhereThereIsNone)
{
    const AsciiWorld world(R"(
         A . . # . . B
        . . . # . . .
         . . . # . . .
    )");
    for (const MakePlanner &makePlanner : planners)
    {
        og::SimpleSetup setup = setupFor(world.shared(), world.centre('A'), world.centre('B'));
        setup.setPlanner(makePlanner(setup.getSpaceInformation()));
        EXPECT_NE(setup.solve(0.02), ob::PlannerStatus::EXACT_SOLUTION) << setup.getPlanner()->getName();
    }
}

TEST(LatticeSpacePlanners, ThoseThatNeedAProjectionFindTheDefaultOne)
{
    const AsciiWorld world(R"(
         A . . # . . .
        . . . # . . B
         . . . . . . .
    )");
    for (const MakePlanner &makePlanner :
         {MakePlanner(make<og::KPIECE1>), MakePlanner(make<og::ProjEST>), MakePlanner()})
    {
        og::SimpleSetup setup = setupFor(world.shared(), world.centre('A'), world.centre('B'));
        if (makePlanner)
            setup.setPlanner(makePlanner(setup.getSpaceInformation()));
        ASSERT_EQ(setup.solve(2.0), ob::PlannerStatus::EXACT_SOLUTION) << (makePlanner ? "" : "OMPL's default planner");
        EXPECT_TRUE(setup.getSolutionPath().check());
    }
}

TEST(LatticeSpaceSetup, PointsSnapToTheirCells)
{
    const AsciiWorld world(R"(
         A . .
        . . B
    )",
                           10.0, Point(300, 200));
    og::SimpleSetup setup = setupFor(world.shared(), world.centre('A') + Point(3, -2), world.centre('B') + Point(1, 4));
    const auto *space = dynamic_cast<const HexStateSpace *>(setup.getStateSpace().get());
    ASSERT_NE(space, nullptr);
    EXPECT_EQ(space->lattice().centre(world.cell('B')), world.centre('B'));
    setup.setPlanner(make<og::RRTConnect>(setup.getSpaceInformation()));
    ASSERT_EQ(setup.solve(1.0), ob::PlannerStatus::EXACT_SOLUTION);
    const std::vector<Point> waypoints = routeFromPath(setup.getSolutionPath()).waypoints();
    EXPECT_EQ(waypoints.front(), world.centre('A'));
    EXPECT_EQ(waypoints.back(), world.centre('B'));
}

TEST(LatticeSpaceSetup, PointsOutsideAreNotTaken)
{
    const AsciiWorld world("A . .");
    for (const Point &outside : {Point(-0.1, 0.0), Point(1e300, 0.0), Point(std::nan(""), 0.0)})
    {
        og::SimpleSetup setup = setupFor(world.shared(), world.centre('A') + outside * 9.0, world.centre('A'));
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
        setup.setPlanner(make<og::RRTConnect>(setup.getSpaceInformation()));
        EXPECT_EQ(setup.solve(0.05), ob::PlannerStatus::INVALID_START);
    }
}

TEST(LatticeSpaceEmbedding, PositionsAreCentres)
{
    const HexLattice lattice(Point(5, 9), 2.0, 4, 3);
    const auto space = std::make_shared<HexStateSpace>(lattice);
    const PlanarEmbedding embedding(space.get());
    ASSERT_EQ(embedding.lattice(), &space->lattice());
    EXPECT_FALSE(embedding.hasHeading());
    EXPECT_EQ(embedding.lengthWeight(), 1.0);
    EXPECT_EQ(embedding.bounds().min, lattice.bounds().min);
    EXPECT_EQ(embedding.bounds().max, lattice.bounds().max);
    ob::ScopedState<HexStateSpace> state(space);
    state->setCell(toCube({2, 1}));
    EXPECT_EQ(embedding.position(state.get()), lattice.centre(toCube({2, 1})));
    EXPECT_EQ(embedding.heading(state.get()), 0.0);

    Random random(2);
    for (int i = 0; i < 100; ++i)
    {
        const Point p = random.pointIn({Point(0, 0), Point(20, 15)});
        embedding.place(state.get(), p, 1.0);
        EXPECT_EQ(state->cell(), lattice.cellAt(p));
        EXPECT_LE((embedding.position(state.get()) - p).norm(), 2.0 / std::sqrt(3.0) * (1.0 + 1e-9));
        EXPECT_EQ(space->satisfiesBounds(state.get()), lattice.contains(lattice.cellAt(p)));
    }

    const auto plane = spaceWithin(lattice.bounds(), SpaceKind::Plane);
    EXPECT_EQ(PlanarEmbedding(plane.get()).lattice(), nullptr);
    const auto poses = spaceWithin(lattice.bounds(), SpaceKind::Pose);
    EXPECT_EQ(PlanarEmbedding(poses.get()).lattice(), nullptr);
}

}  // namespace
}  // namespace seahex::test
