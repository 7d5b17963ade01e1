// In SE(2) on a chart, for objectives that charge length and turns, the planner's path is the lattice's best.

#include <seahex/planning/TurnCountObjective.h>
#include <seahex/planning/WeightedSumObjective.h>

#include "planning/TurnQuery.h"
#include "support/AsciiWorld.h"

#include <ompl/base/PlannerData.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

TEST(TurnAwarePlanner, ThePathIsTheLatticesBest)
{
    int found = 0;
    int without = 0;
    forEachSeed(500,
                [&](Random &random)
                {
                    TurnQuery query(random);
                    SCOPED_TRACE(query.text);
                    const ob::OptimizationObjectivePtr objective = query.problem->getOptimizationObjective();
                    const ob::PlannerStatus status = query.planner->solve(20.0);
                    if (std::isinf(query.best))
                    {
                        ++without;
                        EXPECT_NE(status, ob::PlannerStatus::EXACT_SOLUTION);
                        return;
                    }
                    ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
                    ob::PlannerSolution solution(nullptr);
                    ASSERT_TRUE(query.problem->getSolution(solution));
                    const double tolerance = 1e-9 * (1.0 + query.best);
                    EXPECT_LE(solution.cost_.value(), query.best + tolerance);
                    if (!query.hasPairInOneCell())
                    {
                        EXPECT_NEAR(solution.cost_.value(), query.best, tolerance);
                        EXPECT_NEAR(std::stod(query.planner->getPlannerProgressProperties().at("lower bound REAL")()),
                                    query.best, 1e-7 * (1.0 + query.best));
                    }
                    EXPECT_TRUE(pathOf(query.problem)->check());
                    ++found;
                });
    EXPECT_GE(found, 300);
    EXPECT_GE(without, 5);
}

TEST(TurnAwarePlanner, InSlicesItIsTheSamePath)
{
    int slices = 0;
    forEachSeed(60,
                [&](Random &random)
                {
                    TurnQuery query(random);
                    SCOPED_TRACE(query.text);
                    if (query.planner->solve(20.0) != ob::PlannerStatus::EXACT_SOLUTION)
                        return;
                    const auto whole = pathOf(query.problem);
                    const SearchCounters counters = query.planner->counters();
                    query.problem->clearSolutionPaths();
                    query.planner->clear();
                    ob::PlannerStatus status = ob::PlannerStatus::TIMEOUT;
                    for (int calls = 0; query.planner->outcome() != PlanningOutcome::Found; ++calls)
                    {
                        ASSERT_LT(calls, 1000);
                        Watch watch([](int look) { return look >= 2; });
                        status = query.planner->solve(watch.condition());
                        ++slices;
                    }
                    ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
                    const auto inSlices = pathOf(query.problem);
                    ASSERT_EQ(inSlices->getStateCount(), whole->getStateCount());
                    for (unsigned int i = 0; i < whole->getStateCount(); ++i)
                        EXPECT_TRUE(query.si->equalStates(inSlices->getState(i), whole->getState(i)));
                    EXPECT_EQ(query.planner->counters().expanded, counters.expanded);
                });
    EXPECT_GE(slices, 100);
}

TEST(TurnAwarePlanner, SmoothingMakesItNoWorse)
{
    forEachSeed(80,
                [&](Random &random)
                {
                    TurnQuery query(random);
                    SCOPED_TRACE(query.text);
                    query.planner->setSmoothing(true);
                    if (query.planner->solve(20.0) != ob::PlannerStatus::EXACT_SOLUTION)
                        return;
                    ob::PlannerSolution solution(nullptr);
                    ASSERT_TRUE(query.problem->getSolution(solution));
                    EXPECT_LE(solution.cost_.value(), query.best + 1e-9 * (1.0 + query.best));
                    EXPECT_TRUE(pathOf(query.problem)->check());
                });
}

/// Cost from the start vertices to every vertex, by lowering along edges until nothing changes.
std::vector<double> costsOf(const ob::PlannerData &data)
{
    std::vector<double> costs(data.numVertices(), std::numeric_limits<double>::infinity());
    for (unsigned int i = 0; i < data.numStartVertices(); ++i)
        costs[data.getStartIndex(i)] = 0.0;
    for (bool changed = true; changed;)
    {
        changed = false;
        for (unsigned int v = 0; v < data.numVertices(); ++v)
        {
            std::map<unsigned int, const ob::PlannerDataEdge *> edges;
            data.getEdges(v, edges);
            for (const auto &edge : edges)
            {
                ob::Cost weight;
                data.getEdgeWeight(v, edge.first, &weight);
                if (costs[v] + weight.value() < costs[edge.first] - 1e-12)
                {
                    costs[edge.first] = costs[v] + weight.value();
                    changed = true;
                }
            }
        }
    }
    return costs;
}

TEST(TurnAwarePlanner, ItsDataIsTheTreeOfCellsAndHeadings)
{
    int found = 0;
    int severalHeadings = 0;
    forEachSeed(80,
                [&](Random &random)
                {
                    TurnQuery query(random);
                    SCOPED_TRACE(query.text);
                    const ob::OptimizationObjective &objective = *query.problem->getOptimizationObjective();
                    const bool isSolved = query.planner->solve(20.0) == ob::PlannerStatus::EXACT_SOLUTION;
                    ob::PlannerData data(query.si);
                    query.planner->getPlannerData(data);
                    const unsigned int vertices = data.numVertices();
                    const unsigned int edges = data.numEdges();
                    query.planner->getPlannerData(data);
                    EXPECT_EQ(data.numVertices(), vertices) << "once more adds nothing";
                    EXPECT_EQ(data.numEdges(), edges);
                    std::map<std::pair<double, double>, int> places;
                    for (unsigned int v = 0; v < vertices; ++v)
                    {
                        const ob::State *state = data.getVertex(v).getState();
                        EXPECT_TRUE(query.si->isValid(state));
                        const Point p = positionOf(query.si, state);
                        severalHeadings += ++places[{p.x(), p.y()}] == 2 ? 1 : 0;
                        std::vector<unsigned int> next;
                        data.getEdges(v, next);
                        for (const unsigned int w : next)
                        {
                            ob::Cost weight;
                            EXPECT_TRUE(data.getEdgeWeight(v, w, &weight));
                            EXPECT_EQ(weight.value(),
                                      objective.motionCost(state, data.getVertex(w).getState()).value());
                            EXPECT_TRUE(query.si->checkMotion(state, data.getVertex(w).getState()));
                        }
                    }
                    const std::vector<double> costs = costsOf(data);
                    for (unsigned int v = 0; v < vertices; ++v)
                        EXPECT_TRUE(std::isfinite(costs[v]) || data.isGoalVertex(v)) << "a tree is connected";
                    if (!isSolved)
                        return;
                    ++found;
                    double best = std::numeric_limits<double>::infinity();
                    for (unsigned int i = 0; i < data.numGoalVertices(); ++i)
                        best = std::min(best, costs[data.getGoalIndex(i)]);
                    ob::PlannerSolution solution(nullptr);
                    ASSERT_TRUE(query.problem->getSolution(solution));
                    EXPECT_NEAR(best, solution.cost_.value(), 1e-9 * (1.0 + best)) << "nothing in the data is cheaper";
                });
    EXPECT_GE(found, 40);
    EXPECT_GE(severalHeadings, 100);
}

/// Derived from an objective that is known, so that it may charge anything.
class LongWay : public ob::PathLengthOptimizationObjective
{
public:
    using ob::PathLengthOptimizationObjective::PathLengthOptimizationObjective;
    ob::Cost motionCost(const ob::State *a, const ob::State *b) const override
    {
        return ob::Cost(3.0 * si_->distance(a, b) + 1.0);
    }
};

TEST(TurnAwarePlanner, ObjectivesOfOnesOwnAreTakenAtTheirWord)
{
    const AsciiWorld world(R"(
         A . . . . . B
    )");
    const auto si = chartSpace(world.shared(), SpaceKind::Pose);
    const auto problem = problemBetween(si, world.centre('A'), world.centre('B'));
    for (const bool isPart : {false, true})
    {
        ob::OptimizationObjectivePtr objective = std::make_shared<LongWay>(si);
        if (isPart)
            objective = std::make_shared<WeightedSumObjective>(
                si, std::vector<WeightedSumObjective::Part>{{objective, 1.0},
                                                            {std::make_shared<TurnCountObjective>(si), 1.0}});
        problem->clearSolutionPaths();
        problem->setOptimizationObjective(objective);
        const auto planner = plannerFor(problem);
        ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        // jumps of three cells: two of them, from the start to its cell's centre, and on to the goal
        EXPECT_DOUBLE_EQ(pathOf(problem)->cost(objective).value(), 18.0 + 4.0);
    }
}

TEST(TurnAwarePlanner, FewTurnsAreFound)
{
    const AsciiWorld world(R"(
         . . . . . . . . . . . . . . . . . .
        . . . . . . . . . . . . . . . . . .
         . . . . . # . . . # . . . # . . . .
        . . . . . # . . . # . . . # . . . .
         . . . . . # . . . # . . . # . . . .
        . . . . . # . . . # . . . # . . . .
         A . . . . # . . . # . . . # . . . B
        . . . . . . . # . . . # . . . . . .
         . . . . . . . # . . . # . . . . . .
        . . . . . # # # # # # # # # . . . .
    )");
    const auto si = chartSpace(world.shared(), SpaceKind::Pose);
    const auto problem = problemBetween(si, world.centre('A'), world.centre('B'));
    const auto turnsFor = [&](double price)
    {
        const auto turns = std::make_shared<TurnCountObjective>(si);
        problem->clearSolutionPaths();
        problem->setOptimizationObjective(std::make_shared<WeightedSumObjective>(
            si, std::vector<WeightedSumObjective::Part>{
                    {std::make_shared<ob::PathLengthOptimizationObjective>(si), 1.0}, {turns, price}}));
        EXPECT_EQ(plannerFor(problem)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        return pathOf(problem)->cost(turns).value();
    };
    // east at both ends: a turn to the first leg, one to the second, and so on
    EXPECT_GT(turnsFor(0.0), 4.0);
    EXPECT_EQ(turnsFor(50.0), 4.0);
}

}  // namespace
}  // namespace seahex::test
