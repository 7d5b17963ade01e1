#include <seahex/planning/HexAStar.h>

#include "planning/ClosedBay.h"

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalSpace.h>
#include <ompl/base/goals/GoalStates.h>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// Which starts and goals a problem may have, and what is said of those that are no good.

class HexAStarStates : public ClosedBay
{
};

TEST_F(HexAStarStates, StartAndGoalInOnePlaceOrOneCellAreJoinedDirectly)
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

TEST_F(HexAStarStates, AnInvalidStartOrGoalIsToldAtOnce)
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

TEST_F(HexAStarStates, OneValidStateOfSeveralIsEnough)
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

TEST(HexAStarNoPath, IsTimeoutAndExhaustedAtOnce)
{
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

TEST_F(HexAStarStates, TheBestPairOfStartsAndGoalsWins)
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

TEST_F(HexAStarStates, ManyPairsOfOneCellAreComparedInLittleTimeToo)
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

TEST_F(HexAStarStates, AGoalThatCannotBeSampledIsNotRecognised)
{
    const auto problem = std::make_shared<ob::ProblemDefinition>(si);
    problem->addStartState(stateAt(si, world.centre('A')));
    problem->setGoal(std::make_shared<EastOf>(si));
    EXPECT_EQ(plannerFor(problem)->solve(5.0), ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
    EXPECT_FALSE(problem->hasSolution());
}

TEST_F(HexAStarStates, AnIncompleteProblemIsAnException)
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

TEST_F(HexAStarStates, AGoalRegionWithNoEndOfSamplesIsServed)
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

TEST_F(HexAStarStates, AGoalThatTurnsUpLaterIsWaitedFor)
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

TEST_F(HexAStarStates, StatesAddedBetweenCallsTakePart)
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

TEST_F(HexAStarStates, AnotherProblemIsAnotherQuestion)
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

}  // namespace
}  // namespace seahex::test
