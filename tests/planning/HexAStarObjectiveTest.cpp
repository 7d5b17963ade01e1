#include <seahex/planning/HexAStar.h>
#include <seahex/planning/PlanarEmbedding.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/PlanningWorlds.h"

#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/MechanicalWorkOptimizationObjective.h>
#include <ompl/base/objectives/MinimaxObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

/// Hills over the plane: the cost of a state for objectives that look at one. At least 0.2.
double height(const Point &p)
{
    return 1.2 + std::sin(0.7 * p.x()) * std::cos(0.9 * p.y() + 0.3 * p.x());
}

template <class Objective>
class OnHills : public Objective
{
public:
    using Objective::Objective;
    ob::Cost stateCost(const ob::State *state) const override
    {
        return ob::Cost(height(PlanarEmbedding(this->si_->getStateSpace().get()).position(state)));
    }
};

/// An integral of the hills with an admissible heuristic, and a price for where one starts and ends.
class PricedHills : public OnHills<ob::StateCostIntegralObjective>
{
public:
    using OnHills::OnHills;
    ob::Cost motionCostHeuristic(const ob::State *s1, const ob::State *s2) const override
    {
        return ob::Cost(0.2 * si_->distance(s1, s2));
    }
    ob::Cost initialCost(const ob::State *state) const override { return ob::Cost(3.0 * stateCost(state).value()); }
    ob::Cost terminalCost(const ob::State *state) const override { return ob::Cost(2.0 * stateCost(state).value()); }
};

using MakeObjective = std::function<ob::OptimizationObjectivePtr(const ob::SpaceInformationPtr &)>;

struct NamedObjective
{
    const char *name;
    MakeObjective make;
};

std::ostream &operator<<(std::ostream &out, const NamedObjective &objective)
{
    return out << objective.name;
}

const std::vector<NamedObjective> objectives = {
    {"StateCostIntegral",
     [](const auto &si)
     {
         return std::make_shared<OnHills<ob::StateCostIntegralObjective>>(si);
     }},
    {"InterpolatedIntegral",
     [](const auto &si)
     {
         return std::make_shared<OnHills<ob::StateCostIntegralObjective>>(si, true);
     }},
    {"PricedHills",
     [](const auto &si)
     {
         return std::make_shared<PricedHills>(si);
     }},
    {"MaximizeMinClearance",
     [](const auto &si)
     {
         return std::make_shared<ob::MaximizeMinClearanceObjective>(si);
     }},
    {"MechanicalWork",
     [](const auto &si)
     {
         return std::make_shared<OnHills<ob::MechanicalWorkOptimizationObjective>>(si, 0.01);
     }},
    {"Minimax",
     [](const auto &si)
     {
         return std::make_shared<OnHills<ob::MinimaxObjective>>(si);
     }},
    {"MultiOptimization",
     [](const auto &si)
     {
         auto both = std::make_shared<ob::MultiOptimizationObjective>(si);
         both->addObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si), 0.5);
         both->addObjective(std::make_shared<OnHills<ob::StateCostIntegralObjective>>(si), 2.0);
         return both;
     }},
};

/// The best cost over the centres of a lattice with the objective's own algebra: costs are lowered motion by motion
/// until nothing gets better, which needs no order and no heuristic.
class BestCost
{
public:
    BestCost(const ob::SpaceInformationPtr &si, const ob::OptimizationObjective &objective, std::vector<Point> centres,
             std::function<bool(std::size_t, std::size_t)> isJump)
        : si_(si), objective_(objective), centres_(std::move(centres)), isJump_(std::move(isJump))
    {
    }

    /// @param joins  true if the state at a point joins a centre
    double between(const std::vector<Point> &starts, const std::vector<Point> &goals,
                   const std::function<bool(const Point &, std::size_t)> &joins) const
    {
        std::vector<ob::Cost> cost(centres_.size(), objective_.infiniteCost());
        for (const Point &start : starts)
            for (std::size_t i = 0; i < centres_.size(); ++i)
                if (joins(start, i))
                {
                    // a start that is a centre is one state of the path, with no motion between
                    ob::Cost entry = objective_.initialCost(stateAt(si_, start).get());
                    if (start != centres_[i])
                        entry = objective_.combineCosts(entry, motionCost(start, centres_[i]));
                    cost[i] = objective_.betterCost(cost[i], entry);
                }
        lower(cost);
        ob::Cost best = objective_.infiniteCost();
        for (const Point &goal : goals)
            for (std::size_t i = 0; i < centres_.size(); ++i)
                if (joins(goal, i))
                {
                    ob::Cost last = cost[i];
                    if (goal != centres_[i])
                        last = objective_.combineCosts(last, motionCost(centres_[i], goal));
                    best = objective_.betterCost(
                        best, objective_.combineCosts(last, objective_.terminalCost(stateAt(si_, goal).get())));
                }
        return best.value();
    }

private:
    ob::Cost motionCost(const Point &a, const Point &b) const
    {
        return objective_.motionCost(stateAt(si_, a).get(), stateAt(si_, b).get());
    }

    void lower(std::vector<ob::Cost> &cost) const
    {
        struct Jump
        {
            std::size_t from;
            std::size_t to;
            ob::Cost cost;
        };
        std::vector<Jump> jumps;
        for (std::size_t i = 0; i < centres_.size(); ++i)
            for (std::size_t k = 0; k < centres_.size(); ++k)
                if (i != k && isJump_(i, k))
                    jumps.push_back({i, k, motionCost(centres_[i], centres_[k])});
        for (bool changed = true; changed;)
        {
            changed = false;
            for (const Jump &jump : jumps)
            {
                const ob::Cost known = cost[jump.from];
                if (known.value() == objective_.infiniteCost().value())
                    continue;
                const ob::Cost reached = objective_.combineCosts(known, jump.cost);
                if (objective_.isCostBetterThan(reached, cost[jump.to]))
                {
                    cost[jump.to] = reached;
                    changed = true;
                }
            }
        }
    }

    ob::SpaceInformationPtr si_;
    const ob::OptimizationObjective &objective_;
    std::vector<Point> centres_;
    std::function<bool(std::size_t, std::size_t)> isJump_;
};

/// Solves and compares with `best`. @return true if there was a path
bool solveAndCompare(const ob::ProblemDefinitionPtr &problem, HexAStar &planner, double best)
{
    const ob::OptimizationObjectivePtr objective = problem->getOptimizationObjective();
    const ob::PlannerStatus status = planner.solve(20.0);
    if (best == objective->infiniteCost().value())
    {
        EXPECT_NE(status, ob::PlannerStatus::EXACT_SOLUTION);
        return false;
    }
    EXPECT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
    ob::PlannerSolution solution(nullptr);
    EXPECT_TRUE(problem->getSolution(solution));
    EXPECT_NEAR(solution.cost_.value(), best, 1e-9 * (1.0 + std::abs(best)));
    EXPECT_EQ(solution.path_->cost(objective).value(), solution.cost_.value());
    EXPECT_TRUE(solution.path_->check());
    return true;
}

class Objectives : public ::testing::TestWithParam<NamedObjective>
{
};

TEST_P(Objectives, BestOfTheLatticeOnAChart)
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
    {
        Random random(seed);
        const HexLattice lattice(Point(random.real(-5, 5), random.real(-5, 5)), random.real(0.7, 2.0), 6, 6);
        const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.35));
        SCOPED_TRACE(random.seedText() + toPicture(*occupancy));
        const auto si = chartSpace(occupancy);
        const auto objective = GetParam().make(si);
        const Point start = freePoint(random, *occupancy);
        const Point goal = freePoint(random, *occupancy);
        if (lattice.cellAt(start) == lattice.cellAt(goal))
            continue;
        const auto problem = problemBetween(si, start, goal);
        problem->setOptimizationObjective(objective);
        const auto planner = plannerFor(problem);
        const int rings = static_cast<int>(random.integer(1, 3));
        planner->setRings(rings);
        planner->setGuidance(random.chance(0.3)   ? Guidance::None
                             : random.chance(0.5) ? Guidance::Distance
                                                  : Guidance::TieBreak);

        std::vector<HexCoord> cells;
        std::vector<Point> centres;
        forEachCell(lattice, 0,
                    [&](HexCoord cell)
                    {
                        if (occupancy->isFree(cell))
                        {
                            cells.push_back(cell);
                            centres.push_back(lattice.centre(cell));
                        }
                    });
        const BestCost oracle(si, *objective, centres,
                              [&](std::size_t i, std::size_t k) {
                                  return hexDistance(cells[i], cells[k]) <= rings &&
                                         distanceToBlocked(*occupancy, centres[i], centres[k]) > 1e-9;
                              });
        const double best = oracle.between(
            {start}, {goal}, [&](const Point &p, std::size_t i) { return lattice.cellAt(p) == cells[i]; });
        found += solveAndCompare(problem, *planner, best) ? 1 : 0;
    }
    EXPECT_GT(found, 15);
}

TEST_P(Objectives, BestOfTheLatticeWithNoChartFromSeveralStartsToSeveralGoals)
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Box box{Point(0, 0), Point(8, 7)};
        const Discs discs = randomDiscs(random, box, 4);
        const auto si = std::make_shared<ob::SpaceInformation>(spaceWithin(box, SpaceKind::Plane));
        si->setStateValidityChecker([&](const ob::State *state) { return discs.isFree(positionOf(si, state)); });
        si->setup();
        const auto objective = GetParam().make(si);
        const auto problem = std::make_shared<ob::ProblemDefinition>(si);
        const auto goalStates = std::make_shared<ob::GoalStates>(si);
        std::vector<Point> starts;
        std::vector<Point> goals;
        const HexLattice lattice = HexLattice::covering(box, 1.3);
        // the two sides lie apart, so that no pair shares a cell
        for (int i = 0; i < 2; ++i)
        {
            const Point start(random.real(0.1, 2.0), random.real(0.1, 6.9));
            const Point goal(random.real(6.0, 7.9), random.real(0.1, 6.9));
            if (discs.isFree(start))
                starts.push_back(start);
            if (discs.isFree(goal))
                goals.push_back(goal);
        }
        if (starts.empty() || goals.empty())
            continue;
        for (const Point &start : starts)
            problem->addStartState(stateAt(si, start));
        for (const Point &goal : goals)
            goalStates->addState(stateAt(si, goal));
        problem->setGoal(goalStates);
        problem->setOptimizationObjective(objective);
        const auto planner = plannerFor(problem);
        planner->setCellSize(1.3);
        const int rings = static_cast<int>(random.integer(1, 3));
        planner->setRings(rings);

        std::vector<HexCoord> cells;
        std::vector<Point> centres;
        forEachCell(lattice, 0,
                    [&](HexCoord cell)
                    {
                        const Point centre = lattice.centre(cell);
                        if (box.contains(centre) && discs.isFree(centre))
                        {
                            cells.push_back(cell);
                            centres.push_back(centre);
                        }
                    });
        const auto holds = [&](const Point &a, const Point &b)
        {
            return si->checkMotion(stateAt(si, a).get(), stateAt(si, b).get());
        };
        const BestCost oracle(si, *objective, centres,
                              [&](std::size_t i, std::size_t k)
                              { return hexDistance(cells[i], cells[k]) <= rings && holds(centres[i], centres[k]); });
        const double best =
            oracle.between(starts, goals,
                           [&](const Point &p, std::size_t i)
                           { return hexDistance(lattice.cellAt(p), cells[i]) <= 1 && holds(p, centres[i]); });
        found += solveAndCompare(problem, *planner, best) ? 1 : 0;
    }
    EXPECT_GT(found, 15);
}

INSTANTIATE_TEST_SUITE_P(OfOmpl, Objectives, ::testing::ValuesIn(objectives),
                         [](const auto &instance) { return std::string(instance.param.name); });

TEST(Objectives, TheLargestClearanceIsWorthADetour)
{
    const AsciiWorld world(R"(
         . . . . . . .
        . . . . . . .
         . . . . . . .
        A . # . # . B
         # # # # # # #
    )");
    const auto si = chartSpace(world.shared());
    const auto problem = problemBetween(si, world.centre('A'), world.centre('B'));
    ASSERT_EQ(plannerFor(problem)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    const double shortest = lengthOf(*pathOf(problem));
    problem->clearSolutionPaths();
    problem->setOptimizationObjective(std::make_shared<ob::MaximizeMinClearanceObjective>(si));
    ASSERT_EQ(plannerFor(problem)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_GT(lengthOf(*pathOf(problem)), shortest);
}

}  // namespace
}  // namespace seahex::test
