#include <seahex/planning/HexAStar.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>

#include "planning/ClosedBay.h"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <set>
#include <thread>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

class HexAStarContract : public ClosedBay
{
};

TEST_F(HexAStarContract, SaysWhatItCanDo)
{
    const HexAStar planner(si);
    EXPECT_EQ(planner.getName(), "HexAStar");
    EXPECT_EQ(planner.getSpecs().recognizedGoal, ob::GOAL_SAMPLEABLE_REGION);
    EXPECT_TRUE(planner.getSpecs().optimizingPaths);
    EXPECT_FALSE(planner.getSpecs().approximateSolutions);
    EXPECT_FALSE(planner.getSpecs().directed);
    EXPECT_FALSE(planner.getSpecs().multithreaded);
    EXPECT_TRUE(planner.getSpecs().canReportIntermediateSolutions);
}

TEST_F(HexAStarContract, AProblemWithoutObjectiveStaysWithout)
{
    const auto problem = between('A', 'B');
    const auto planner = plannerFor(problem);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_FALSE(problem->hasOptimizationObjective());
    ob::PlannerSolution solution(nullptr);
    ASSERT_TRUE(problem->getSolution(solution));
    EXPECT_EQ(solution.cost_.value(), pathOf(problem)->length());
    EXPECT_FALSE(solution.optimized_);
}

TEST_F(HexAStarContract, TheThresholdOfTheObjectiveDecidesWhatIsOptimised)
{
    const double cost = costBetween('A', 'B');
    for (const double threshold : {0.0, 0.99 * cost, 1.01 * cost})
    {
        const auto problem = between('A', 'B');
        const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(si);
        objective->setCostThreshold(ob::Cost(threshold));
        problem->setOptimizationObjective(objective);
        ASSERT_EQ(plannerFor(problem)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        ob::PlannerSolution solution(nullptr);
        ASSERT_TRUE(problem->getSolution(solution));
        EXPECT_EQ(solution.optimized_, cost < threshold);
    }
}

TEST_F(HexAStarContract, SolvingAgainTellsTheSameSolution)
{
    const auto problem = between('A', 'B');
    const auto planner = plannerFor(problem);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    const double cost = pathOf(problem)->length();
    problem->clearSolutionPaths();
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(pathOf(problem)->length(), cost);
}

TEST_F(HexAStarContract, ClearStartsAfresh)
{
    HexAStar planner(si);
    planner.clear();
    planner.clear();
    EXPECT_EQ(planner.cellSize(), 0.0);
    planner.setup();
    EXPECT_FALSE(planner.isSetup()) << "there is no problem yet";
    EXPECT_EQ(planner.cellSize(), 1.0);
    planner.clear();
    planner.setRings(2);
    const auto problem = between('A', 'B');
    planner.setProblemDefinition(problem);
    ASSERT_EQ(planner.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    const double cost = pathOf(problem)->length();
    const std::uint64_t expanded = planner.counters().expanded;
    for (int i = 0; i < 3; ++i)
    {
        planner.clear();
        planner.clear();
        EXPECT_EQ(planner.outcome(), PlanningOutcome::None);
        EXPECT_EQ(planner.counters().expanded, 0u);
        EXPECT_EQ(planner.getRings(), 2) << "settings stay";
        problem->clearSolutionPaths();
        ASSERT_EQ(planner.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(pathOf(problem)->length(), cost);
        EXPECT_EQ(planner.counters().expanded, expanded);
    }
    planner.clearQuery();
    problem->clearSolutionPaths();
    EXPECT_EQ(planner.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
}

TEST_F(HexAStarContract, AnotherObjectiveOrChartIsNoticed)
{
    const auto problem = between('A', 'B');
    const auto planner = plannerFor(problem);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    problem->clearSolutionPaths();
    problem->setOptimizationObjective(std::make_shared<LatticeLengthObjective>(si, world.lattice()));
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerSolution solution(nullptr);
    ASSERT_TRUE(problem->getSolution(solution));
    EXPECT_DOUBLE_EQ(solution.cost_.value(), std::round(solution.cost_.value())) << "steps are whole";

    std::vector<HexCoord> rocks;
    for (const ob::State *state : pathOf(problem)->getStates())
        rocks.push_back(world.lattice().cellAt(positionOf(si, state)));
    rocks = {rocks[rocks.size() / 2]};
    const auto later = occupancyWith(world.lattice(), rocks);
    si->setStateValidityChecker(std::make_shared<OccupancyValidityChecker>(si, later));
    si->setMotionValidator(std::make_shared<OccupancyMotionValidator>(si, later));
    si->setup();
    problem->clearSolutionPaths();
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(pathOf(problem)->check());
}

TEST_F(HexAStarContract, ParametersAreSetAndReadByName)
{
    HexAStar planner(si);
    auto &params = planner.params();
    const std::set<std::string> names = {"rings",       "exact",     "guidance", "anytime",   "smoothing",
                                         "approximate", "all_jumps", "direct",   "cell_size", "jumps"};
    std::vector<std::string> declared;
    params.getParamNames(declared);
    EXPECT_EQ(std::set<std::string>(declared.begin(), declared.end()), names);
    for (const std::string &name : names)
        EXPECT_TRUE(params.setParam(name, params[name].getValue())) << name;

    EXPECT_TRUE(params.setParam("rings", "2"));
    EXPECT_EQ(planner.getRings(), 2);
    for (const char *guidance : {"automatic", "none", "distance", "euclidean", "cheng", "wang", "tie_break", "relaxed"})
    {
        EXPECT_TRUE(params.setParam("guidance", guidance));
        EXPECT_EQ(planner.getGuidance(), guidance);
        EXPECT_EQ(params["guidance"].getValue(), guidance);
    }
    for (const char *jumps : {"hopping", "safe"})
    {
        EXPECT_TRUE(params.setParam("jumps", jumps));
        EXPECT_EQ(planner.getJumps(), jumps);
    }
    EXPECT_TRUE(params.setParam("all_jumps", "1"));
    EXPECT_TRUE(planner.getAllJumps());
    EXPECT_TRUE(params.setParam("cell_size", "0.5"));
    EXPECT_EQ(planner.getCellSize(), 0.5);
    EXPECT_FALSE(params.setParam("no_such_thing", "1"));
    EXPECT_FALSE(params.setParam("rings", "two"));
}

TEST_F(HexAStarContract, BadValuesAreRefusedAndChangeNothing)
{
    HexAStar planner(si);
    for (const int rings : {-1, 0, 4})
        EXPECT_THROW(planner.setRings(rings), ompl::Exception);
    EXPECT_THROW(planner.setGuidance("hope"), ompl::Exception);
    EXPECT_THROW(planner.setGuidance(""), ompl::Exception);
    for (const double size : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_THROW(planner.setCellSize(size), ompl::Exception);
    EXPECT_THROW(planner.params().setParam("rings", "7"), ompl::Exception);
    EXPECT_EQ(planner.getRings(), 3);
    EXPECT_EQ(planner.getGuidance(), "automatic");
    EXPECT_EQ(planner.getCellSize(), 0.0);
}

TEST_F(HexAStarContract, TheCellSizeOfAChartIsItsOwn)
{
    const auto planner = plannerFor(between('A', 'B'));
    planner->setCellSize(0.3);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(planner->cellSize(), 1.0);
}

TEST_F(HexAStarContract, SettingsChangedBetweenCallsTakeEffect)
{
    const auto problem = between('A', 'B');
    const auto planner = plannerFor(problem);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    const double three = pathOf(problem)->length();
    problem->clearSolutionPaths();
    planner->setRings(1);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_GT(pathOf(problem)->length(), three);
}

TEST_F(HexAStarContract, ASolutionChangedInPlaceIsNotToldAgain)
{
    for (const char goal : {'A', 'B'})
    {
        const auto problem = between('A', goal);
        const auto planner = plannerFor(problem);
        ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        const std::size_t states = pathOf(problem)->getStateCount();
        pathOf(problem)->interpolate(200);
        problem->clearSolutionPaths();
        ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_EQ(pathOf(problem)->getStateCount(), states);
    }
}

TEST_F(HexAStarContract, TheTraceHoldsTheExpandedCells)
{
    const auto planner = plannerFor(between('A', 'B'));
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(planner->trace().empty());
    EXPECT_GT(planner->counters().generated, 0u);
    EXPECT_GE(planner->searchMs(), 0.0);
    planner->setTracing(true);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    ASSERT_FALSE(planner->trace().empty());
    EXPECT_EQ(planner->trace().size(), planner->counters().expanded);
    EXPECT_EQ(planner->trace().front(), toOffset(world.cell('A')));
    EXPECT_LE(planner->counters().expanded, planner->counters().generated + planner->counters().reopened);
    for (const OffsetCoord cell : planner->trace())
        EXPECT_TRUE(world.occupancy().isFree(toCube(cell)));
}

TEST_F(HexAStarContract, TwoPlannersOnOneSpaceInTwoThreads)
{
    const double there = costBetween('A', 'B');
    const double other = costBetween('C', 'A');
    std::atomic<int> right{0};
    const auto solve = [&](char start, char goal, double cost)
    {
        for (int i = 0; i < 100; ++i)
        {
            const auto problem = between(start, goal);
            if (plannerFor(problem)->solve(5.0) == ob::PlannerStatus::EXACT_SOLUTION &&
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

/// R^2 that counts the states that are alive.
class CountingSpace : public ob::RealVectorStateSpace
{
public:
    CountingSpace() : ob::RealVectorStateSpace(2) {}
    ob::State *allocState() const override
    {
        ++alive;
        return ob::RealVectorStateSpace::allocState();
    }
    void freeState(ob::State *state) const override
    {
        --alive;
        ob::RealVectorStateSpace::freeState(state);
    }
    mutable std::atomic<int> alive{0};
};

TEST_F(HexAStarContract, AllStatesAreFreed)
{
    const auto space = std::make_shared<CountingSpace>();
    const Box box = world.lattice().bounds();
    ob::RealVectorBounds bounds(2);
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
        bounds.setLow(axis, box.min[axis]);
        bounds.setHigh(axis, box.max[axis]);
    }
    space->setBounds(bounds);
    for (const bool chart : {true, false})
    {
        const auto counted = std::make_shared<ob::SpaceInformation>(space);
        if (chart)
        {
            counted->setStateValidityChecker(std::make_shared<OccupancyValidityChecker>(counted, world.shared()));
            counted->setMotionValidator(std::make_shared<OccupancyMotionValidator>(counted, world.shared()));
        }
        else
            counted->setStateValidityChecker([](const ob::State *) { return true; });
        counted->setup();
        const auto problem = problemBetween(counted, world.centre('A'), world.centre('B'));
        const int before = space->alive;
        {
            HexAStar planner(counted);
            planner.setProblemDefinition(problem);
            planner.solve(ob::plannerAlwaysTerminatingCondition());
            ASSERT_EQ(planner.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
            planner.solve(5.0);
            planner.clear();
            ASSERT_EQ(planner.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
            EXPECT_GT(space->alive, before);
        }
        problem->clearSolutionPaths();
        EXPECT_EQ(space->alive, before) << (chart ? "on the chart" : "with no chart");
    }
}

}  // namespace
}  // namespace seahex::test
