#pragma once

#include <seahex/planning/HexAStar.h>
#include <seahex/planning/SquareAStar.h>

#include "planning/ChartObjectives.h"
#include "support/AsciiWorld.h"
#include "support/CellOracle.h"
#include "support/JumpKinds.h"
#include "support/PlanningWorlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

namespace seahex::test
{

// HexAStar and SquareAStar on random charts of their own cells, for tests of what holds for both, and the optimum that
// they are held against.

struct HexPlanning : HexKind
{
    using Planner = HexAStar;
    static void setReach(HexAStar &planner, int rings) { planner.setRings(rings); }
};

struct SquarePlanning : SquareKind
{
    using Planner = SquareAStar;
    static void setReach(SquareAStar &planner, int neighbours) { planner.setNeighbours(neighbours); }
};

struct PlannerNames
{
    template <class Kind>
    static std::string GetName(int)
    {
        return std::is_same_v<Kind, HexPlanning> ? "HexAStar" : "SquareAStar";
    }
};

/// A random chart with a problem between two points, and one way to ask for its solution.
template <class Kind>
class ChartQuestion
{
public:
    ChartQuestion(Random &random, const ChartObjective &objective)
        : world(random), bounds(anyBounds(random)), cells(within(bounds)), start(pointWithin(random)),
          goal(pointWithin(random)),
          si(chartSpace(world.occupancy,
                        objective.looksAtYaw || random.chance(0.7) ? SpaceKind::Plane : SpaceKind::Pose, bounds)),
          problem(problemBetween(si, start, goal))
    {
        problem->setOptimizationObjective(objective.make(si, *world.occupancy));
        const std::vector<int> reaches = Kind::reaches();
        reach = reaches[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(reaches.size()) - 1))];
        guidance = static_cast<Guidance>(random.integer(0, 5));
        if (guidance == Guidance::Cheng && std::is_same_v<Kind, HexPlanning> && reach > 1)
            guidance = Guidance::None;  // not admissible there
    }

    /// By Dijkstra's algorithm; infinity where there is no way.
    double leastCost(JumpRule rule) const
    {
        const Lattice &lattice = static_cast<const Occupancy &>(*world.occupancy).lattice();
        const OffsetCoord first = lattice.cellAt(start);
        const OffsetCoord last = lattice.cellAt(goal);
        if (first == last)
            return motionCost(start, goal);
        const auto cost = [&](OffsetCoord from, OffsetCoord to)
        {
            return motionCost(lattice.centre(from), lattice.centre(to));
        };
        return Kind::graph(*cells, reach, rule, cost)
            .cheapest({{vertexOf(lattice, first), motionCost(start, lattice.centre(first))}},
                      {{vertexOf(lattice, last), motionCost(lattice.centre(last), goal)}});
    }

    std::shared_ptr<typename Kind::Planner> planner(JumpRule rule, bool isDirect) const
    {
        auto planner = plannerFor<typename Kind::Planner>(problem);
        Kind::setReach(*planner, reach);
        planner->setGuidance(guidance);
        planner->setJumps(rule);
        planner->setDirect(isDirect);
        return planner;
    }

    /// Solves, and holds the solution against the least cost.
    void solve(typename Kind::Planner &planner, double least, JumpRule rule) const
    {
        problem->clearSolutionPaths();
        const ompl::base::PlannerStatus status = planner.solve(ompl::base::plannerNonTerminatingCondition());
        if (std::isinf(least))
        {
            ASSERT_EQ(status, ompl::base::PlannerStatus::TIMEOUT);
            ASSERT_EQ(planner.outcome(), PlanningOutcome::Exhausted);
            return;
        }
        ASSERT_EQ(status, ompl::base::PlannerStatus::EXACT_SOLUTION);
        ompl::base::PlannerSolution solution(nullptr);
        ASSERT_TRUE(problem->getSolution(solution));
        ASSERT_NEAR(solution.cost_.value(), least, 1e-8 * (1.0 + least));
        ASSERT_EQ(solution.cost_.value(), pathOf(problem)->cost(problem->getOptimizationObjective()).value());
        const auto bound = planner.getPlannerProgressProperties().at("lower bound REAL");
        ASSERT_LE(std::stod(bound()), solution.cost_.value());
        if (rule == JumpRule::Safe)
            checkPath();
    }

    /// Every leg by exact geometry, and that only centres lie between the ends.
    void checkPath() const
    {
        const ompl::geometric::PathGeometric &path = *pathOf(problem);
        ASSERT_EQ(positionOf(si, path.getState(0)), start);
        ASSERT_EQ(positionOf(si, path.getState(static_cast<unsigned int>(path.getStateCount() - 1))), goal);
        for (unsigned int i = 1; i < path.getStateCount(); ++i)
        {
            const Point a = positionOf(si, path.getState(i - 1));
            const Point b = positionOf(si, path.getState(i));
            ASSERT_GT(distanceToBlocked(*world.occupancy, a, b), 0.0L);
            if (i + 1 < path.getStateCount())
            {
                ASSERT_EQ(b, world.lattice.centre(world.lattice.cellAt(b)));
            }
        }
    }

    std::vector<Point> positions() const
    {
        std::vector<Point> positions;
        if (const auto path = pathOf(problem))
            for (const ompl::base::State *state : path->getStates())
                positions.push_back(positionOf(si, state));
        return positions;
    }

    const RandomWorld<Kind> world;
    const Box bounds;  // of the space
    const std::shared_ptr<const LatticeOccupancy<typename Kind::KnownLattice>> cells;
    const Point start;
    const Point goal;
    const ompl::base::SpaceInformationPtr si;
    const ompl::base::ProblemDefinitionPtr problem;
    int reach;
    Guidance guidance;

private:
    /// Those of the lattice, or less: then cells with their centre outside are left out.
    Box anyBounds(Random &random) const
    {
        const Box whole = world.lattice.bounds();
        if (random.chance(0.7))
            return whole;
        const double most = 2.0 * world.lattice.pitch();
        const Box box = {whole.min + most * Point(random.unit(), random.unit()),
                         whole.max - most * Point(random.unit(), random.unit())};
        const bool hasWater =
            (box.max - box.min).minCoeff() > 0.0 && within(box)->blockedCount() < world.lattice.cellCount();
        return hasWater ? box : whole;
    }

    auto within(const Box &box) const
    {
        std::vector<typename Kind::KnownLattice::Cell> blocked;
        forEachCell(world.lattice, 0,
                    [&](typename Kind::KnownLattice::Cell cell)
                    {
                        if (world.occupancy->isBlocked(cell) || !box.contains(world.lattice.centre(cell)))
                            blocked.push_back(cell);
                    });
        return occupancyWith(world.lattice, blocked);
    }

    Point pointWithin(Random &random) const
    {
        for (;;)
        {
            const Point p = freePoint(random, *cells);
            if (bounds.contains(p))
                return p;
        }
    }

    double motionCost(const Point &a, const Point &b) const
    {
        if (a == b)
            return 0.0;
        return problem->getOptimizationObjective()->motionCost(stateAt(si, a).get(), stateAt(si, b).get()).value();
    }
};

using PlannerKinds = ::testing::Types<HexPlanning, SquarePlanning>;

}  // namespace seahex::test
