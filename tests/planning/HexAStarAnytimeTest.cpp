#include <seahex/planning/HexAStar.h>
#include <seahex/planning/LatticeLengthObjective.h>

#include "planning/ClosedBay.h"
#include "support/Random.h"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <limits>
#include <thread>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

struct Answer
{
    ob::PlannerStatus status;
    std::vector<Point> points;
    double cost = 0.0;
};

Answer answerOf(HexAStar &planner, const ob::ProblemDefinitionPtr &problem)
{
    problem->clearSolutionPaths();
    Answer answer{planner.solve(20.0), {}};
    if (const auto path = pathOf(problem))
    {
        for (const ob::State *state : path->getStates())
            answer.points.push_back(positionOf(problem->getSpaceInformation(), state));
        ob::PlannerSolution solution(nullptr);
        problem->getSolution(solution);
        answer.cost = solution.cost_.value();
    }
    return answer;
}

/// A random chart and a problem on it.
struct RandomBay
{
    explicit RandomBay(Random &random, SpaceKind kind = SpaceKind::Plane)
        : occupancy(randomOccupancy(random, HexLattice(Point(0, 0), 1.0, 14, 12), random.real(0.0, 0.4))),
          si(chartSpace(occupancy, kind, boundsOf(random))),
          problem(problemBetween(si, freePoint(random, *occupancy), freePoint(random, *occupancy)))
    {
    }

    /// Those of the lattice, or narrower.
    Box boundsOf(Random &random) const
    {
        Box box = occupancy->lattice().bounds();
        if (random.chance(0.3))
            box.min += Point(random.real(0, 2), random.real(0, 2));
        if (random.chance(0.3))
            box.max -= Point(random.real(0, 2), random.real(0, 2));
        return box;
    }

    std::shared_ptr<const HexOccupancy> occupancy;
    ob::SpaceInformationPtr si;
    ob::ProblemDefinitionPtr problem;
};

SpaceKind randomKind(Random &random)
{
    return static_cast<SpaceKind>(random.integer(0, 2));
}

/// Is it a problem in SE(2) whose objective charges for turns, as OMPL's path length does there?
bool knowsHeadings(const RandomBay &bay)
{
    const ob::OptimizationObjective &objective = *bay.problem->getOptimizationObjective();
    return bay.si->getStateSpace()->getType() == ob::STATE_SPACE_SE2 &&
           typeid(objective) == typeid(ob::PathLengthOptimizationObjective);
}

/// Planner with both ways to improve on.
std::shared_ptr<HexAStar> anytimePlanner(const ob::ProblemDefinitionPtr &problem)
{
    auto planner = std::make_shared<HexAStar>(problem->getSpaceInformation());
    planner->setProblemDefinition(problem);
    return planner;
}

class Slope : public ob::StateCostIntegralObjective
{
public:
    explicit Slope(const ob::SpaceInformationPtr &si) : ob::StateCostIntegralObjective(si) {}
    ob::Cost stateCost(const ob::State *state) const override
    {
        return ob::Cost(2.0 + std::sin(positionOf(si_, state).x()));
    }
};

ob::OptimizationObjectivePtr randomObjective(Random &random, const RandomBay &bay)
{
    switch (random.integer(0, 2))
    {
        case 0:
            return std::make_shared<LatticeLengthObjective>(bay.si, bay.occupancy->lattice());
        case 1:
            return std::make_shared<Slope>(bay.si);
        default:
            return std::make_shared<ob::PathLengthOptimizationObjective>(bay.si);
    }
}

TEST(HexAStarAnytime, ReadingTheOccupancyOrAskingGivesTheSameAnswer)
{
    int found = 0;
    forEachSeed(300,
                [&](Random &random)
                {
                    const RandomBay bay(random, randomKind(random));
                    bay.problem->setOptimizationObjective(randomObjective(random, bay));
                    const auto reading = anytimePlanner(bay.problem);
                    const auto asking = anytimePlanner(bay.problem);
                    for (const auto &planner : {reading, asking})
                    {
                        planner->setDirect(planner == reading);
                        planner->setTracing(true);
                    }
                    const int rings = static_cast<int>(random.integer(1, 3));
                    constexpr std::array<Guidance, 4> guidances = {Guidance::None, Guidance::Distance,
                                                                   Guidance::Euclidean, Guidance::Cheng};
                    const Guidance guidance = guidances[static_cast<std::size_t>(random.integer(0, 3))];
                    const bool smoothing = random.chance(0.5);
                    const bool allJumps = random.chance(0.5);
                    for (const auto &planner : {reading, asking})
                    {
                        planner->setRings(rings);
                        planner->setGuidance(guidance);
                        planner->setSmoothing(smoothing);
                        planner->setAllJumps(allJumps);
                    }
                    const Answer read = answerOf(*reading, bay.problem);
                    const Answer asked = answerOf(*asking, bay.problem);
                    EXPECT_EQ(read.status, static_cast<ob::PlannerStatus::StatusType>(asked.status));
                    EXPECT_EQ(reading->outcome(), asking->outcome());
                    found += read.points.empty() ? 0 : 1;
                    if (knowsHeadings(bay))
                    {
                        // who reads tells headings apart, and finds paths that turn less
                        EXPECT_TRUE(smoothing || read.points.empty() || read.cost <= asked.cost + 1e-9);
                        return;
                    }
                    EXPECT_EQ(read.cost, asked.cost);
                    EXPECT_EQ(read.points, asked.points);
                    EXPECT_EQ(reading->trace(), asking->trace());
                });
    EXPECT_GT(found, 100);
}

TEST(HexAStarAnytime, EachAnswerIsBetterAndAllAreTold)
{
    int several = 0;
    forEachSeed(200,
                [&](Random &random)
                {
                    const RandomBay bay(random, random.chance(0.3) ? SpaceKind::Cells : SpaceKind::Plane);
                    std::vector<double> told;
                    bay.problem->setIntermediateSolutionCallback(
                        [&](const ob::Planner *, const std::vector<const ob::State *> &states, ob::Cost cost)
                        {
                            told.push_back(cost.value());
                            og::PathGeometric path(bay.si);
                            for (const ob::State *state : states)
                                path.append(state);
                            EXPECT_TRUE(path.check());
                            EXPECT_EQ(path.length(), cost.value());
                            EXPECT_TRUE(bay.si->equalStates(states.front(), bay.problem->getStartState(0)));
                            EXPECT_TRUE(bay.problem->getGoal()->isSatisfied(states.back()));
                        });
                    const auto planner = anytimePlanner(bay.problem);
                    const Answer answer = answerOf(*planner, bay.problem);
                    ASSERT_EQ(told.size(), planner->improvements().size());
                    if (told.empty())
                        return;
                    EXPECT_EQ(told.back(), answer.cost);
                    double seconds = 0.0;
                    for (std::size_t i = 0; i < told.size(); ++i)
                    {
                        EXPECT_EQ(planner->improvements()[i].cost, told[i]);
                        EXPECT_GE(planner->improvements()[i].seconds, seconds);
                        EXPECT_TRUE(i == 0 || told[i] < told[i - 1]);
                        seconds = planner->improvements()[i].seconds;
                    }
                    several += told.size() > 1 ? 1 : 0;

                    bay.problem->setIntermediateSolutionCallback({});
                    const auto plain = plannerFor(bay.problem);
                    plain->setRings(1);
                    const double oneRing = answerOf(*plain, bay.problem).cost;
                    EXPECT_NEAR(told.front(), oneRing, 1e-12 * oneRing) << "one ring first";
                    plain->setRings(3);
                    EXPECT_LE(answer.cost, answerOf(*plain, bay.problem).cost);
                    for (std::size_t i = 1; i < answer.points.size(); ++i)
                        EXPECT_GT(distanceToBlocked(*bay.occupancy, answer.points[i - 1], answer.points[i]), 0.0L);
                });
    EXPECT_GT(several, 50);
}

TEST(HexAStarAnytime, InterruptedAnywhereItEndsWithTheSameAnswer)
{
    forEachSeed(60,
                [&](Random &random)
                {
                    const RandomBay bay(random, randomKind(random));
                    bay.problem->setOptimizationObjective(randomObjective(random, bay));
                    const auto whole = anytimePlanner(bay.problem);
                    const bool direct = random.chance(0.5);
                    whole->setDirect(direct);
                    const Answer expected = answerOf(*whole, bay.problem);

                    bay.problem->clearSolutionPaths();
                    const auto planner = anytimePlanner(bay.problem);
                    planner->setDirect(direct);
                    int looks = 0;
                    const int most = static_cast<int>(random.integer(2, 40));
                    double best = std::numeric_limits<double>::infinity();
                    for (int call = 0; planner->outcome() != whole->outcome(); ++call)
                    {
                        ASSERT_LT(call, 2000);
                        looks = 0;
                        planner->solve(ob::PlannerTerminationCondition([&] { return ++looks > most + call; }));
                        ob::PlannerSolution solution(nullptr);
                        if (bay.problem->getSolution(solution))
                        {
                            EXPECT_LE(solution.cost_.value(), best);
                            best = solution.cost_.value();
                        }
                    }
                    EXPECT_EQ(pathOf(bay.problem) != nullptr, !expected.points.empty());
                    EXPECT_TRUE(expected.points.empty() || best == expected.cost);
                });
}

class HexAStarAnytimeBay : public ClosedBay
{
};

TEST(HexAStarAnytime, TheThresholdEndsTheWork)
{
    int several = 0;
    forEachSeed(40,
                [&](Random &random)
                {
                    const RandomBay bay(random, random.chance(0.3) ? SpaceKind::Cells : SpaceKind::Plane);
                    const auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(bay.si);
                    bay.problem->setOptimizationObjective(objective);
                    const auto whole = anytimePlanner(bay.problem);
                    if (answerOf(*whole, bay.problem).points.empty())
                        return;
                    EXPECT_EQ(whole->outcome(), PlanningOutcome::Found);
                    const std::vector<Improvement> all = whole->improvements();
                    several += all.size() >= 3 ? 1 : 0;
                    for (std::size_t enough = 0; enough + 1 < all.size(); ++enough)
                    {
                        const double between = enough == 0 ? std::numeric_limits<double>::infinity()
                                                           : 0.5 * (all[enough - 1].cost + all[enough].cost);
                        objective->setCostThreshold(ob::Cost(between));
                        const auto planner = anytimePlanner(bay.problem);
                        answerOf(*planner, bay.problem);
                        EXPECT_EQ(planner->improvements().size(), enough + 1);
                        EXPECT_EQ(planner->outcome(), PlanningOutcome::Improvable);
                        EXPECT_TRUE(bay.problem->hasOptimizedSolution());

                        // asked for more, it goes on
                        objective->setCostThreshold(ob::Cost(0.0));
                        EXPECT_EQ(answerOf(*planner, bay.problem).cost, all.back().cost);
                        EXPECT_EQ(planner->outcome(), PlanningOutcome::Found);
                        EXPECT_FALSE(bay.problem->hasOptimizedSolution());
                    }
                });
    EXPECT_GT(several, 3);
}

double progressOf(const HexAStar &planner, const std::string &name)
{
    return std::stod(planner.getPlannerProgressProperties().at(name)());
}

TEST(HexAStarProgress, TheLowerBoundIsOneAndMeetsTheLatticesOptimum)
{
    forEachSeed(200,
                [&](Random &random)
                {
                    const RandomBay bay(random, random.chance(0.3) ? SpaceKind::Cells : SpaceKind::Plane);
                    const auto planner = plannerFor(bay.problem);
                    const bool smoothing = random.chance(0.5);
                    planner->setSmoothing(smoothing);
                    planner->setAnytime(random.chance(0.5));
                    planner->setRings(static_cast<int>(random.integer(1, 3)));
                    double bound = 0.0;
                    planner->setup();
                    EXPECT_EQ(progressOf(*planner, "best cost REAL"), std::numeric_limits<double>::infinity());
                    std::vector<double> bounds;
                    const auto look = [&]
                    {
                        const double now = progressOf(*planner, "lower bound REAL");
                        EXPECT_GE(now, bound);
                        bound = now;
                        return false;
                    };
                    if (planner->solve(ob::PlannerTerminationCondition(look)) != ob::PlannerStatus::EXACT_SOLUTION)
                        return;
                    look();
                    const double cost = pathOf(bay.problem)->length();
                    EXPECT_NEAR(progressOf(*planner, "best cost REAL"), cost, 1e-12 * cost);
                    EXPECT_LE(bound, cost);
                    const ob::State *start = bay.problem->getStartState(0);
                    EXPECT_GE(bound * (1.0 + 1e-12), bay.si->distance(start, pathOf(bay.problem)->getStates().back()));
                    EXPECT_TRUE(smoothing || std::abs(bound - cost) < 1e-6);
                });
}

TEST_F(HexAStarAnytimeBay, ProgressCanBeReadAtAnyTime)
{
    const auto planner = std::make_shared<HexAStar>(si);
    EXPECT_EQ(planner->getPlannerProgressProperties().size(), 4u);
    std::atomic<bool> over{false};
    std::atomic<int> reads{0};
    std::thread reader(
        [&]
        {
            while (!over)
                for (const auto &property : planner->getPlannerProgressProperties())
                    reads += property.second().empty() ? 0 : 1;
        });
    while (reads == 0)
        std::this_thread::yield();
    for (int i = 0; i < 200; ++i)
    {
        planner->setProblemDefinition(between('A', 'B'));
        EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        planner->clear();
    }
    over = true;
    reader.join();
    EXPECT_GT(reads, 0);
}

TEST(HexAStarApproximate, LeadsToTheNearestCentreThatCanBeReached)
{
    AsciiWorld world(R"(
         A . . # . . .
        . . . # . . .
         . . . # . B .
        . . . # . . .
    )");
    const auto si = chartSpace(world.shared());
    const auto problem = problemBetween(si, world.centre('A'), world.centre('B'));
    const auto planner = anytimePlanner(problem);
    EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
    EXPECT_FALSE(problem->hasSolution());

    planner->setApproximate(true);
    EXPECT_TRUE(planner->getSpecs().approximateSolutions);
    EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::APPROXIMATE_SOLUTION);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
    ASSERT_TRUE(problem->hasApproximateSolution());
    const auto path = pathOf(problem);
    EXPECT_TRUE(path->check());
    const Point end = positionOf(si, path->getStates().back());
    EXPECT_EQ(end, world.lattice().centre(toCube({2, 2})));
    EXPECT_DOUBLE_EQ(problem->getSolutionDifference(), (end - world.centre('B')).norm());
    EXPECT_FALSE(problem->hasOptimizedSolution());
}

}  // namespace
}  // namespace seahex::test
