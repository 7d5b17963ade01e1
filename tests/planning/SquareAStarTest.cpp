#include <seahex/planning/SquareAStar.h>

#include "planning/SquareBay.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <set>
#include <thread>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

class SquareAStarContract : public SquareBay
{
};

TEST_F(SquareAStarContract, SaysWhatItCanDo)
{
    const SquareAStar planner(si);
    EXPECT_EQ(planner.getName(), "SquareAStar");
    EXPECT_EQ(planner.getSpecs().recognizedGoal, ob::GOAL_SAMPLEABLE_REGION);
    EXPECT_TRUE(planner.getSpecs().optimizingPaths);
    EXPECT_FALSE(planner.getSpecs().approximateSolutions);
    EXPECT_FALSE(planner.getSpecs().directed);
    EXPECT_FALSE(planner.getSpecs().multithreaded);
    EXPECT_TRUE(planner.getSpecs().canReportIntermediateSolutions);
    EXPECT_EQ(planner.getNeighbours(), 8);
    EXPECT_FALSE(planner.getCornerCutting());
}

TEST_F(SquareAStarContract, ParametersAreSetAndReadByName)
{
    SquareAStar planner(si);
    auto &params = planner.params();
    const std::set<std::string> names = {"neighbours", "guidance", "smoothing", "approximate",
                                         "direct",     "jumps",    "cell_size"};
    std::vector<std::string> declared;
    params.getParamNames(declared);
    EXPECT_EQ(std::set<std::string>(declared.begin(), declared.end()), names);
    for (const std::string &name : names)
        EXPECT_TRUE(params.setParam(name, params[name].getValue())) << name;

    for (const int neighbours : {4, 8})
    {
        EXPECT_TRUE(params.setParam("neighbours", std::to_string(neighbours)));
        EXPECT_EQ(planner.getNeighbours(), neighbours);
        EXPECT_EQ(params["neighbours"].getValue(), std::to_string(neighbours));
    }
    EXPECT_TRUE(params.setParam("jumps", "hopping"));
    EXPECT_TRUE(planner.getCornerCutting());
    EXPECT_TRUE(params.setParam("jumps", "safe"));
    EXPECT_FALSE(planner.getCornerCutting());
    planner.setCornerCutting(true);
    EXPECT_EQ(planner.getJumps(), "hopping");
    planner.setCornerCutting(false);
    EXPECT_EQ(planner.getJumps(), "safe");
}

TEST_F(SquareAStarContract, BadValuesAreRefusedAndChangeNothing)
{
    SquareAStar planner(si);
    for (const int neighbours : {-4, 0, 5, 6, 9})
        EXPECT_THROW(planner.setNeighbours(neighbours), ompl::Exception);
    EXPECT_THROW(planner.params().setParam("neighbours", "6"), ompl::Exception);
    EXPECT_THROW(planner.setJumps("hop"), ompl::Exception);
    EXPECT_THROW(planner.setJumps(""), ompl::Exception);
    EXPECT_THROW(planner.setGuidance("manhattan"), ompl::Exception);
    EXPECT_THROW(planner.setCellSize(-1.0), ompl::Exception);
    EXPECT_EQ(planner.getNeighbours(), 8);
    EXPECT_EQ(planner.getJumps(), "safe");
    EXPECT_EQ(planner.getGuidance(), "automatic");
    EXPECT_EQ(planner.getCellSize(), 0.0);
}

TEST_F(SquareAStarContract, RefusesSpacesThatAreNoPlane)
{
    const auto cells =
        std::make_shared<ob::SpaceInformation>(spaceWithin({Point(0, 0), Point(9, 9)}, SpaceKind::Cells));
    EXPECT_THROW(SquareAStar{cells}, ompl::Exception) << "its states lie in hexagons";
    const auto solid = std::make_shared<ob::RealVectorStateSpace>(3);
    EXPECT_THROW(SquareAStar{std::make_shared<ob::SpaceInformation>(solid)}, ompl::Exception);
    EXPECT_THROW(SquareAStar{nullptr}, ompl::Exception);
    EXPECT_NO_THROW(SquareAStar{chartSpace(world.shared(), SpaceKind::Pose)});
}

TEST_F(SquareAStarContract, TheLatticeIsTheChartsOrOneOverTheBounds)
{
    SquareAStar onChart(si);
    onChart.setCellSize(0.3);
    onChart.setup();
    ASSERT_TRUE(onChart.lattice().has_value());
    EXPECT_EQ(*onChart.lattice(), Lattice(world.lattice()));
    EXPECT_EQ(onChart.cellSize(), 1.0);

    const Box box{Point(-3, 2), Point(7, 5)};
    SquareAStar alone(userSpace(box, SpaceKind::Plane, [](const ob::State *) { return true; }));
    alone.setup();
    ASSERT_NE(alone.lattice()->squares(), nullptr);
    EXPECT_EQ(*alone.lattice(), Lattice(SquareLattice::covering(box, 10.0 / 200.0)));
    alone.setCellSize(0.3);
    alone.setup();
    EXPECT_EQ(*alone.lattice(), Lattice(SquareLattice::covering(box, 0.3)));
    alone.setCellSize(1e-4);
    EXPECT_THROW(alone.setup(), ompl::Exception) << "3 x 10^9 cells";

    // hexagons are not its own
    const auto hexagons = occupancyWith(HexLattice(Point(0, 0), 1.0, 8, 8), {});
    SquareAStar foreign(chartSpace(hexagons));
    foreign.setup();
    EXPECT_NE(foreign.lattice()->squares(), nullptr);
}

TEST_F(SquareAStarContract, NeighboursAndCornersTakeEffectBetweenCalls)
{
    const auto problem = between('A', 'B');
    const auto planner = plannerFor<SquareAStar>(problem);
    const auto solved = [&]
    {
        problem->clearSolutionPaths();
        EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        return pathOf(problem)->length();
    };
    const double eight = solved();
    planner->setNeighbours(4);
    const double four = solved();
    EXPECT_EQ(four, std::round(four));
    EXPECT_GT(four, eight);
    planner->setNeighbours(8);
    EXPECT_EQ(solved(), eight);
    planner->setCornerCutting(true);
    const double cut = solved();
    EXPECT_LT(cut, eight);
    EXPECT_FALSE(pathOf(problem)->check()) << "a path of the figures, not of the problem";
    planner->setCornerCutting(false);
    EXPECT_EQ(solved(), eight);
    EXPECT_TRUE(pathOf(problem)->check());
}

TEST_F(SquareAStarContract, ACornerIsNoGate)
{
    // D is joined to the rest over a corner between two rocks only
    const auto problem = between('A', 'D');
    const auto planner = plannerFor<SquareAStar>(problem);
    EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
    planner->setCornerCutting(true);
    EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    planner->setCornerCutting(false);
    problem->clearSolutionPaths();
    EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::TIMEOUT);
}

TEST_F(SquareAStarContract, SmoothingNeverMakesLessValidNorLonger)
{
    for (const char goal : {'B', 'C'})
    {
        const auto problem = between('A', goal);
        ASSERT_EQ(plannerFor<SquareAStar>(problem)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        const double lattice = pathOf(problem)->length();
        problem->clearSolutionPaths();
        SquareAStar asItComes(si);
        asItComes.setProblemDefinition(problem);
        ASSERT_EQ(asItComes.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_LT(pathOf(problem)->length(), lattice);
        EXPECT_TRUE(pathOf(problem)->check());
        for (unsigned int i = 1; i < pathOf(problem)->getStateCount(); ++i)
            EXPECT_GT(distanceToBlocked(world.occupancy(), positionOf(si, pathOf(problem)->getState(i - 1)),
                                        positionOf(si, pathOf(problem)->getState(i))),
                      0.0L);
    }
}

TEST_F(SquareAStarContract, TheTraceHoldsTheExpandedCells)
{
    const auto planner = plannerFor<SquareAStar>(between('A', 'B'));
    planner->setTracing(true);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(planner->trace().size(), planner->counters().expanded);
    ASSERT_FALSE(planner->trace().empty());
    EXPECT_EQ(planner->trace().front(), world.cell('A'));
    for (const OffsetCoord cell : planner->trace())
        EXPECT_TRUE(world.occupancy().isFree(cell));
}

TEST_F(SquareAStarContract, TwoPlannersOnOneSpaceInTwoThreads)
{
    const auto costBetween = [this](char start, char goal)
    {
        const auto problem = between(start, goal);
        EXPECT_EQ(plannerFor<SquareAStar>(problem)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        return pathOf(problem)->length();
    };
    const double there = costBetween('A', 'B');
    const double other = costBetween('C', 'A');
    std::atomic<int> right{0};
    const auto solve = [&](char start, char goal, double cost)
    {
        for (int i = 0; i < 100; ++i)
        {
            const auto problem = between(start, goal);
            if (plannerFor<SquareAStar>(problem)->solve(5.0) == ob::PlannerStatus::EXACT_SOLUTION &&
                pathOf(problem)->length() == cost)
                ++right;
        }
    };
    std::thread one([&] { solve('A', 'B', there); });
    std::thread two([&] { solve('C', 'A', other); });
    one.join();
    two.join();
    EXPECT_EQ(right, 200);
}

}  // namespace
}  // namespace seahex::test
