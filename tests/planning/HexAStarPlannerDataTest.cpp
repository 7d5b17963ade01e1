#include <seahex/planning/HexAStar.h>

#include "planning/ClosedBay.h"
#include "support/Random.h"

#include <ompl/base/PlannerData.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

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
            std::vector<unsigned int> next;
            data.getEdges(v, next);
            for (const unsigned int w : next)
            {
                ob::Cost weight;
                data.getEdgeWeight(v, w, &weight);
                if (costs[v] + weight.value() < costs[w])
                {
                    costs[w] = costs[v] + weight.value();
                    changed = true;
                }
            }
        }
    }
    return costs;
}

TEST(HexAStarPlannerData, IsTheTreeOfTheSearchAndThePath)
{
    int found = 0;
    forEachSeed(150,
                [&](Random &random)
                {
                    const HexLattice lattice(Point(0, 0), 1.0, 10, 9);
                    const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.4));
                    const bool chart = random.chance(0.7);
                    const auto kind = static_cast<SpaceKind>(random.integer(0, 2));
                    const bool pose = kind == SpaceKind::Pose;
                    const auto si = chart ? chartSpace(occupancy, kind)
                                          : userSpace(lattice.bounds(), kind, [](const ob::State *) { return true; });
                    const auto end = [&]
                    {
                        return random.chance(0.4) ? lattice.centre(lattice.cellAt(freePoint(random, *occupancy)))
                                                  : freePoint(random, *occupancy);
                    };
                    const auto problem = problemBetween(si, end(), end());
                    const auto planner = plannerFor(problem);
                    planner->setCellSize(1.0);
                    planner->setSmoothing(random.chance(0.5));
                    planner->setAnytime(random.chance(0.5));
                    const bool exact = planner->solve(5.0) == ob::PlannerStatus::EXACT_SOLUTION;
                    ob::PlannerData data(si);
                    planner->getPlannerData(data);
                    const unsigned int vertices = data.numVertices();
                    const unsigned int edges = data.numEdges();
                    planner->getPlannerData(data);
                    EXPECT_EQ(data.numVertices(), vertices) << "once more adds nothing";
                    EXPECT_EQ(data.numEdges(), edges);
                    EXPECT_EQ(data.properties.count("expanded INTEGER"), 1u);

                    const ob::PathLengthOptimizationObjective length(si);
                    int expanded = 0;
                    for (unsigned int v = 0; v < vertices; ++v)
                    {
                        const ob::State *state = data.getVertex(v).getState();
                        EXPECT_TRUE(si->isValid(state));
                        expanded += data.getVertex(v).getTag() == static_cast<int>(PlannerDataTag::Expanded) ? 1 : 0;
                        std::vector<unsigned int> next;
                        data.getEdges(v, next);
                        for (const unsigned int w : next)
                        {
                            const ob::State *other = data.getVertex(w).getState();
                            ob::Cost weight;
                            EXPECT_TRUE(data.getEdgeWeight(v, w, &weight));
                            EXPECT_EQ(weight.value(), length.motionCost(state, other).value());
                            EXPECT_TRUE((pose && !chart) || si->checkMotion(state, other));
                        }
                    }
                    const std::vector<double> costs = costsOf(data);
                    for (unsigned int v = 0; v < vertices; ++v)
                        EXPECT_TRUE(std::isfinite(costs[v]) || data.isGoalVertex(v)) << "a tree is connected";
                    if (!exact)
                        return;
                    ++found;
                    ASSERT_EQ(data.numStartVertices(), 1u);
                    ASSERT_EQ(data.numGoalVertices(), 1u);
                    EXPECT_GE(planner->counters().expanded + 2, static_cast<std::uint64_t>(expanded));
                    EXPECT_EQ(positionOf(si, data.getStartVertex(0).getState()),
                              positionOf(si, problem->getStartState(0)));
                    EXPECT_TRUE(pose || std::abs(costs[data.getGoalIndex(0)] - pathOf(problem)->length()) < 1e-9);
                    EXPECT_EQ(data.getGoalVertex(0).getTag(), static_cast<int>(PlannerDataTag::Solution));
                });
    EXPECT_GT(found, 60);
}

class HexAStarPlannerDataBay : public ClosedBay
{
};

TEST_F(HexAStarPlannerDataBay, HoldsEveryCellReachedAndOutlivesThePlanner)
{
    const auto problem = between('A', 'B');
    const auto planner = plannerFor(problem);
    ob::PlannerData empty(si);
    planner->getPlannerData(empty);
    EXPECT_EQ(empty.numVertices(), 0u);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerData data(si);
    planner->getPlannerData(data);
    EXPECT_EQ(data.numVertices(), planner->counters().generated) << "start and goal are centres";
    EXPECT_GE(data.numEdges(), data.numVertices() - 1);
    EXPECT_EQ(positionOf(si, data.getStartVertex(0).getState()), world.centre('A'));
    EXPECT_EQ(positionOf(si, data.getGoalVertex(0).getState()), world.centre('B'));
    pathOf(problem)->getStates().back()->as<ob::RealVectorStateSpace::StateType>()->values[0] += 1.0;
    EXPECT_EQ(positionOf(si, data.getGoalVertex(0).getState()), world.centre('B')) << "the solution is the problem's";
    data.decoupleFromPlanner();
    planner->clear();
    EXPECT_EQ(positionOf(si, data.getGoalVertex(0).getState()), world.centre('B'));
}

}  // namespace
}  // namespace seahex::test
