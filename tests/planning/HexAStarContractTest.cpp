#include <seahex/planning/HexAStar.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>

#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"
#include "support/PlanningWorlds.h"

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalSpace.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/terminationconditions/IterationTerminationCondition.h>

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <set>
#include <thread>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

class HexAStarContract : public ::testing::Test
{
protected:
    HexAStarContract()
        : world(R"(
             A . . # . . . . .
            . . . # . . . # C
             . # . . . # . # #
            . # . . . # . . .
             . # # # . # D . .
            . . . . . # . . B
        )"),
          si(chartSpace(world.shared()))
    {
    }

    ob::ProblemDefinitionPtr between(char start, char goal) const
    {
        return problemBetween(si, world.centre(start), world.centre(goal));
    }

    double costBetween(char start, char goal) const
    {
        const auto problem = between(start, goal);
        EXPECT_EQ(plannerFor(problem)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        return pathOf(problem)->length();
    }

    AsciiWorld world;
    ob::SpaceInformationPtr si;
};

double secondsOf(const std::function<void()> &action)
{
    const auto begin = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// A sea of free cells, 60 x 60, in which a search without guidance expands all.
std::shared_ptr<const HexOccupancy> openSea()
{
    return occupancyWith(HexLattice(Point(0, 0), 1.0, 60, 60), {});
}

TEST_F(HexAStarContract, SaysWhatItCanDo)
{
    const HexAStar planner(si);
    EXPECT_EQ(planner.getName(), "HexAStar");
    EXPECT_EQ(planner.getSpecs().recognizedGoal, ob::GOAL_SAMPLEABLE_REGION);
    EXPECT_TRUE(planner.getSpecs().optimizingPaths);
    EXPECT_FALSE(planner.getSpecs().approximateSolutions);
    EXPECT_FALSE(planner.getSpecs().directed);
    EXPECT_FALSE(planner.getSpecs().multithreaded);
    EXPECT_FALSE(planner.getSpecs().canReportIntermediateSolutions);
}

TEST_F(HexAStarContract, StartAndGoalInOnePlaceOrOneCellAreJoinedDirectly)
{
    const auto same = between('A', 'A');
    EXPECT_EQ(plannerFor(same)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(pathOf(same)->length(), 0.0);
    EXPECT_TRUE(pathOf(same)->check());

    const Point a = world.centre('A') + Point(-0.3, 0.1);
    const Point b = world.centre('A') + Point(0.2, -0.3);
    const auto near = problemBetween(si, a, b);
    const auto planner = plannerFor(near);
    EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::Found);
    EXPECT_DOUBLE_EQ(pathOf(near)->length(), (b - a).norm());
    EXPECT_EQ(pathOf(near)->getStateCount(), 2u);
}

TEST_F(HexAStarContract, AnInvalidStartOrGoalIsToldAtOnce)
{
    const Point rock = world.lattice().centre(toCube({3, 0}));
    const Point outside = world.lattice().bounds().max + Point(5, 5);
    for (const Point &bad : {rock, outside})
    {
        const auto start = plannerFor(problemBetween(si, bad, world.centre('B')));
        EXPECT_LT(secondsOf([&] { EXPECT_EQ(start->solve(20.0), ob::PlannerStatus::INVALID_START); }), 1.0);
        EXPECT_EQ(start->outcome(), PlanningOutcome::InvalidStart);

        const auto goal = plannerFor(problemBetween(si, world.centre('A'), bad));
        EXPECT_LT(secondsOf([&] { EXPECT_EQ(goal->solve(20.0), ob::PlannerStatus::INVALID_GOAL); }), 1.0);
        EXPECT_EQ(goal->outcome(), PlanningOutcome::InvalidGoal);
        EXPECT_EQ(goal->solve(20.0), ob::PlannerStatus::INVALID_GOAL) << "and told again";

        const auto both = plannerFor(problemBetween(si, bad, bad));
        EXPECT_LT(secondsOf([&] { EXPECT_EQ(both->solve(20.0), ob::PlannerStatus::INVALID_START); }), 1.0);
    }
}

TEST_F(HexAStarContract, OneValidStateOfSeveralIsEnough)
{
    const Point rock = world.lattice().centre(toCube({3, 0}));
    const auto problem = std::make_shared<ob::ProblemDefinition>(si);
    problem->addStartState(stateAt(si, rock));
    problem->addStartState(stateAt(si, world.centre('A')));
    const auto goals = std::make_shared<ob::GoalStates>(si);
    // the first valid goal, then an invalid one, then the better one
    for (const Point &goal : {rock, world.centre('B'), rock, world.centre('D')})
        goals->addState(stateAt(si, goal));
    problem->setGoal(goals);
    ASSERT_EQ(plannerFor(problem)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_NEAR(pathOf(problem)->length(), costBetween('A', 'D'), 1e-9);

    const auto none = std::make_shared<ob::GoalStates>(si);
    none->addState(stateAt(si, rock));
    none->addState(stateAt(si, rock));
    problem->setGoal(none);
    const auto planner = plannerFor(problem);
    EXPECT_LT(secondsOf([&] { EXPECT_EQ(planner->solve(20.0), ob::PlannerStatus::INVALID_GOAL); }), 1.0);
}

TEST_F(HexAStarContract, NoPathIsTimeoutAndExhaustedAtOnce)
{
    const auto problem = between('A', 'C');
    problem->setGoalState(stateAt(si, world.centre('C')));
    const AsciiWorld walled(R"(
         A . # B
        . # # .
    )");
    const auto space = chartSpace(walled.shared());
    const auto planner = plannerFor(problemBetween(space, walled.centre('A'), walled.centre('B')));
    EXPECT_LT(secondsOf([&] { EXPECT_EQ(planner->solve(20.0), ob::PlannerStatus::TIMEOUT); }), 1.0);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
    EXPECT_EQ(planner->counters().expanded, 3u);
    EXPECT_EQ(planner->solve(20.0), ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
}

TEST_F(HexAStarContract, TheBestPairOfStartsAndGoalsWins)
{
    int direct = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const auto occupancy = randomOccupancy(random, HexLattice(Point(3, 9), 2.0, 7, 7), random.real(0.0, 0.4));
        const auto space = chartSpace(occupancy);
        const auto problem = std::make_shared<ob::ProblemDefinition>(space);
        const auto goalStates = std::make_shared<ob::GoalStates>(space);
        std::vector<Point> starts;
        std::vector<Point> goals;
        for (std::int64_t n = random.integer(1, 4); n > 0; --n)
        {
            starts.push_back(freePoint(random, *occupancy));
            problem->addStartState(stateAt(space, starts.back()));
        }
        for (std::int64_t n = random.integer(1, 4); n > 0; --n)
        {
            goals.push_back(freePoint(random, *occupancy));
            goalStates->addState(stateAt(space, goals.back()));
        }
        problem->setGoal(goalStates);
        double best = std::numeric_limits<double>::infinity();
        for (const Point &start : starts)
            for (const Point &goal : goals)
            {
                const auto one = problemBetween(space, start, goal);
                if (plannerFor(one)->solve(5.0) == ob::PlannerStatus::EXACT_SOLUTION)
                    best = std::min(best, pathOf(one)->length());
            }
        const auto planner = plannerFor(problem);
        const ob::PlannerStatus status = planner->solve(5.0);
        if (std::isinf(best))
        {
            EXPECT_EQ(status, ob::PlannerStatus::TIMEOUT);
            continue;
        }
        ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_NEAR(pathOf(problem)->length(), best, 1e-8);
        EXPECT_TRUE(pathOf(problem)->check());
        direct += pathOf(problem)->getStateCount() == 2 ? 1 : 0;
    }
    EXPECT_GT(direct, 5);
}

TEST_F(HexAStarContract, ManyPairsOfOneCellAreComparedInLittleTimeToo)
{
    Random random(3);
    const auto problem = std::make_shared<ob::ProblemDefinition>(si);
    const auto goals = std::make_shared<ob::GoalStates>(si);
    double best = std::numeric_limits<double>::infinity();
    std::vector<Point> starts;
    for (int i = 0; i < 6; ++i)
    {
        starts.push_back(world.centre('A') + random.pointIn({Point(-0.4, -0.2), Point(0.4, 0.2)}));
        problem->addStartState(stateAt(si, starts.back()));
    }
    for (int i = 0; i < 6; ++i)
    {
        const Point goal = world.centre('A') + random.pointIn({Point(-0.4, -0.2), Point(0.4, 0.2)});
        goals->addState(stateAt(si, goal));
        for (const Point &start : starts)
            best = std::min(best, (goal - start).norm());
    }
    problem->setGoal(goals);
    const auto planner = plannerFor(problem);
    int calls = 1;
    for (; planner->outcome() != PlanningOutcome::Found; ++calls)
    {
        ASSERT_LT(calls, 100);
        Watch watch([](int look) { return look >= 2; });
        planner->solve(watch.condition());
    }
    EXPECT_GT(calls, 5);
    EXPECT_NEAR(pathOf(problem)->length(), best, 1e-12);
}

/// A goal that can be recognised and not sampled.
class EastOf : public ob::Goal
{
public:
    using ob::Goal::Goal;
    bool isSatisfied(const ob::State *state) const override { return positionOf(si_, state).x() > 3.0; }
};

TEST_F(HexAStarContract, AGoalThatCannotBeSampledIsNotRecognised)
{
    const auto problem = std::make_shared<ob::ProblemDefinition>(si);
    problem->addStartState(stateAt(si, world.centre('A')));
    problem->setGoal(std::make_shared<EastOf>(si));
    EXPECT_EQ(plannerFor(problem)->solve(5.0), ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
    EXPECT_FALSE(problem->hasSolution());
}

TEST_F(HexAStarContract, AnIncompleteProblemIsAnException)
{
    HexAStar planner(si);
    EXPECT_THROW(planner.solve(1.0), ompl::Exception);
    const auto problem = std::make_shared<ob::ProblemDefinition>(si);
    planner.setProblemDefinition(problem);
    EXPECT_THROW(planner.solve(1.0), ompl::Exception);
    problem->addStartState(stateAt(si, world.centre('A')));
    EXPECT_THROW(planner.solve(1.0), ompl::Exception);
    problem->setGoalState(stateAt(si, world.centre('B')));
    EXPECT_EQ(planner.solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_THROW(HexAStar(nullptr), ompl::Exception);
}

TEST_F(HexAStarContract, AGoalRegionWithNoEndOfSamplesIsServed)
{
    const auto goal = std::make_shared<ob::GoalSpace>(si);
    const Point b = world.centre('B');
    goal->setSpace(spaceWithin({b - Point(0.2, 0.2), b + Point(0.2, 0.2)}, SpaceKind::Plane));
    const auto problem = std::make_shared<ob::ProblemDefinition>(si);
    problem->addStartState(stateAt(si, world.centre('A')));
    problem->setGoal(goal);
    const auto planner = plannerFor(problem);
    EXPECT_LT(secondsOf([&] { EXPECT_EQ(planner->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION); }), 5.0);
    EXPECT_TRUE(goal->isSatisfied(pathOf(problem)->getStates().back()));
    EXPECT_TRUE(pathOf(problem)->check());
}

TEST_F(HexAStarContract, AGoalThatTurnsUpLaterIsWaitedFor)
{
    std::atomic<int> calls{0};
    const auto sampler = [&](const ob::GoalLazySamples *, ob::State *state)
    {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        si->copyState(state, stateAt(si, world.centre('B')).get());
        return ++calls <= 1;
    };
    const auto problem = std::make_shared<ob::ProblemDefinition>(si);
    problem->addStartState(stateAt(si, world.centre('A')));
    const auto goal = std::make_shared<ob::GoalLazySamples>(si, sampler);
    problem->setGoal(goal);
    EXPECT_EQ(plannerFor(problem)->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
    goal->stopSampling();
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

TEST(HexAStarBudget, LittleTimeIsContinuedToTheSameCost)
{
    const auto si = chartSpace(openSea());
    const auto whole = problemBetween(si, Point(2.0, -3.0), Point(55.0, -50.0));
    const auto uninterrupted = plannerFor(whole);
    uninterrupted->setGuidance(Guidance::None);
    ASSERT_EQ(uninterrupted->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);

    const auto problem = problemBetween(si, Point(2.0, -3.0), Point(55.0, -50.0));
    const auto planner = plannerFor(problem);
    planner->setGuidance(Guidance::None);
    Watch watch([](int look) { return look % 2 == 0; });
    int calls = 1;
    for (; planner->solve(watch.condition()) != ob::PlannerStatus::EXACT_SOLUTION; ++calls)
    {
        ASSERT_EQ(planner->outcome(), PlanningOutcome::OutOfTime);
        ASSERT_FALSE(problem->hasSolution());
        ASSERT_LT(calls, 1000);
    }
    EXPECT_GE(calls, 5);
    EXPECT_EQ(pathOf(problem)->length(), pathOf(whole)->length());
    EXPECT_EQ(planner->counters().expanded, uninterrupted->counters().expanded) << "no work is lost or done twice";
}

TEST(HexAStarBudget, LooksEvery500Expansions)
{
    const auto si = chartSpace(openSea());
    const auto problem = problemBetween(si, Point(2.0, -3.0), Point(55.0, -50.0));
    const auto planner = plannerFor(problem);
    planner->setGuidance(Guidance::None);
    Watch watch([](int) { return false; });
    ASSERT_EQ(planner->solve(watch.condition()), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_GE(static_cast<std::uint64_t>(watch.looks()), planner->counters().expanded / 500);
}

TEST(HexAStarBudget, NoTimeAtAllReturnsAtOnce)
{
    const auto si = chartSpace(openSea());
    const auto problem = problemBetween(si, Point(2.0, -3.0), Point(55.0, -50.0));
    const auto planner = plannerFor(problem);
    EXPECT_LT(
        secondsOf([&]
                  { EXPECT_EQ(planner->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT); }),
        0.5);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::OutOfTime);
    EXPECT_EQ(planner->counters().expanded, 0u);
    EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    problem->clearSolutionPaths();
    EXPECT_EQ(planner->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION)
        << "what is known is told again";
}

TEST(HexAStarBudget, ATerminatedConditionStopsFromAnotherThread)
{
    const auto si = chartSpace(occupancyWith(HexLattice(Point(0, 0), 1.0, 3000, 3000), {}));
    const auto planner = plannerFor(problemBetween(si, Point(2.0, -3.0), Point(2990.0, -2500.0)));
    planner->setGuidance(Guidance::None);
    const ob::PlannerTerminationCondition condition = ob::plannerNonTerminatingCondition();
    std::thread other(
        [&]
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            condition.terminate();
        });
    const ob::PlannerStatus status = planner->solve(condition);
    other.join();
    EXPECT_EQ(status, ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::OutOfTime);
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

TEST_F(HexAStarContract, StatesAddedBetweenCallsTakePart)
{
    const auto problem = std::make_shared<ob::ProblemDefinition>(si);
    problem->addStartState(stateAt(si, world.centre('A')));
    const auto goals = std::make_shared<ob::GoalStates>(si);
    goals->addState(stateAt(si, world.centre('B')));
    problem->setGoal(goals);
    const auto planner = plannerFor(problem);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_NEAR(pathOf(problem)->length(), costBetween('A', 'B'), 1e-9);
    problem->clearSolutionPaths();
    goals->addState(stateAt(si, world.centre('D')));
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_NEAR(pathOf(problem)->length(), costBetween('A', 'D'), 1e-9);
    problem->clearSolutionPaths();
    problem->addStartState(stateAt(si, world.centre('D')));
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(pathOf(problem)->length(), 0.0);
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

TEST_F(HexAStarContract, AnotherProblemIsAnotherQuestion)
{
    const auto first = between('A', 'B');
    const auto planner = plannerFor(first);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    const auto second = between('C', 'D');
    planner->setProblemDefinition(second);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_EQ(positionOf(si, pathOf(second)->getState(0)), world.centre('C'));
    EXPECT_EQ(positionOf(si, pathOf(second)->getStates().back()), world.centre('D'));
    EXPECT_NEAR(pathOf(second)->length(), costBetween('C', 'D'), 1e-9);
    EXPECT_EQ(first->getSolutionCount(), 1u);

    const auto back = between('D', 'C');
    planner->setProblemDefinition(back);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_NEAR(pathOf(back)->length(), costBetween('C', 'D'), 1e-9)
        << "no start or goal is left of the problem before";
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
    const std::set<std::string> names = {"rings", "guidance", "all_jumps", "cell_size"};
    std::vector<std::string> declared;
    params.getParamNames(declared);
    EXPECT_EQ(std::set<std::string>(declared.begin(), declared.end()), names);
    for (const std::string &name : names)
        EXPECT_TRUE(params.setParam(name, params[name].getValue())) << name;

    EXPECT_TRUE(params.setParam("rings", "2"));
    EXPECT_EQ(planner.getRings(), 2);
    for (const char *guidance : {"none", "distance", "cheng", "tie_break"})
    {
        EXPECT_TRUE(params.setParam("guidance", guidance));
        EXPECT_EQ(planner.getGuidance(), guidance);
        EXPECT_EQ(params["guidance"].getValue(), guidance);
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
    EXPECT_EQ(planner.getGuidance(), "distance");
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
    EXPECT_EQ(planner->trace().front(), world.cell('A'));
    EXPECT_LE(planner->counters().expanded, planner->counters().generated + planner->counters().reopened);
    for (const HexCoord cell : planner->trace())
        EXPECT_TRUE(world.occupancy().isFree(cell));
}

TEST_F(HexAStarContract, PlannerDataHoldsTheSolution)
{
    const auto problem = between('A', 'B');
    const auto planner = plannerFor(problem);
    ob::PlannerData empty(si);
    planner->getPlannerData(empty);
    EXPECT_EQ(empty.numVertices(), 0u);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerData data(si);
    planner->getPlannerData(data);
    planner->getPlannerData(data);
    EXPECT_EQ(data.numVertices(), pathOf(problem)->getStateCount());
    EXPECT_EQ(data.numEdges(), pathOf(problem)->getStateCount() - 1);
    ASSERT_EQ(data.numStartVertices(), 1u);
    ASSERT_EQ(data.numGoalVertices(), 1u);
    EXPECT_EQ(positionOf(si, data.getStartVertex(0).getState()), world.centre('A'));
    EXPECT_EQ(positionOf(si, data.getGoalVertex(0).getState()), world.centre('B'));
    pathOf(problem)->getStates().back()->as<ob::RealVectorStateSpace::StateType>()->values[0] += 1.0;
    EXPECT_EQ(positionOf(si, data.getGoalVertex(0).getState()), world.centre('B')) << "the solution is the problem's";
    data.decoupleFromPlanner();
    planner->clear();
    EXPECT_EQ(positionOf(si, data.getGoalVertex(0).getState()), world.centre('B'));
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
