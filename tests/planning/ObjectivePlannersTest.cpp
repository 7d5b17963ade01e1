// The project's objectives in the hands of planners: HexAStar against Dijkstra's algorithm, and OMPL's planners against
// what they say of their own paths.

#include <seahex/planning/AdmissibleHeuristic.h>
#include <seahex/planning/HexAStar.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/RouteFromPath.h>
#include <seahex/planning/TurnAngleObjective.h>
#include <seahex/planning/TurnCountObjective.h>
#include <seahex/route/RouteMetrics.h>

#include "planning/MakeObjectives.h"
#include "planning/MotionCosts.h"
#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"

#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

class ObjectiveWithPlanners : public ::testing::TestWithParam<NamedObjective>
{
};

TEST_P(ObjectiveWithPlanners, HexAStarFindsWhatDijkstraFinds)
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
    {
        Random random(seed);
        const HexLattice lattice(Point(random.real(-50, 50), random.real(-50, 50)), random.real(0.5, 3.0), 9, 9);
        const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.35));
        SCOPED_TRACE(random.seedText() + toPicture(*occupancy));
        const Point start = freePoint(random, *occupancy);
        const Point goal = freePoint(random, *occupancy);
        const HexCoord first = lattice.cellAt(start);
        const HexCoord last = lattice.cellAt(goal);
        if (first == last)
            continue;
        const auto si = chartSpace(occupancy, random.chance(0.7) ? SpaceKind::Plane : SpaceKind::Cells);
        const auto objective = GetParam().make(si, *occupancy);
        const auto problem = problemBetween(si, start, goal);
        problem->setOptimizationObjective(objective);
        const auto planner = plannerFor(problem);
        const int rings = static_cast<int>(random.integer(1, 3));
        planner->setRings(rings);
        planner->setGuidance(random.chance(0.5) ? Guidance::Distance : Guidance::TieBreak);

        const ExplicitGraph graph =
            jumpGraph(*occupancy, rings,
                      [&](HexCoord from, HexCoord to)
                      { return motionCost(*objective, lattice.centre(from), lattice.centre(to)); });
        const double best =
            graph.cheapest({{vertexOf(lattice, first), motionCost(*objective, start, lattice.centre(first))}},
                           {{vertexOf(lattice, last), motionCost(*objective, lattice.centre(last), goal)}});
        const ob::PlannerStatus status = planner->solve(20.0);
        if (std::isinf(best))
        {
            EXPECT_NE(status, ob::PlannerStatus::EXACT_SOLUTION);
            continue;
        }
        ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
        ++found;
        ob::PlannerSolution solution(nullptr);
        ASSERT_TRUE(problem->getSolution(solution));
        EXPECT_NEAR(solution.cost_.value(), best, 1e-9 * best);
        EXPECT_EQ(solution.path_->cost(objective).value(), solution.cost_.value());
    }
    EXPECT_GT(found, 25);
}

/// Two places in an archipelago, and the planners of OMPL's that optimise.
void expectHonestCosts(const NamedObjective &named, SpaceKind kind)
{
    Random random(7);
    const HexLattice lattice(Point(100, 50), 2.0, 20, 20);
    const auto occupancy = randomOccupancy(random, lattice, 0.12);
    const auto si = chartSpace(occupancy, kind);
    const auto objective = named.make(si, *occupancy);
    const Point start = freePoint(random, *occupancy);
    Point goal = freePoint(random, *occupancy);
    while ((goal - start).norm() < 20.0)
        goal = freePoint(random, *occupancy);
    std::vector<ob::PlannerPtr> planners = {std::make_shared<og::RRTstar>(si),
                                            std::make_shared<og::InformedRRTstar>(si),
                                            std::make_shared<og::BITstar>(si), std::make_shared<HexAStar>(si)};
    if (objective->isSymmetric())  // PRM* has one cost for both directions of an edge
        planners.push_back(std::make_shared<og::PRMstar>(si));
    for (const ob::PlannerPtr &planner : planners)
    {
        SCOPED_TRACE(planner->getName());
        const auto problem = problemBetween(si, start, goal);
        problem->setOptimizationObjective(objective);
        planner->setProblemDefinition(problem);
        ob::PlannerStatus status = planner->solve(0.1);
        for (int again = 0; again < 60 && status != ob::PlannerStatus::EXACT_SOLUTION; ++again)
            status = planner->solve(0.1);
        ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
        ob::PlannerSolution solution(nullptr);
        ASSERT_TRUE(problem->getSolution(solution));
        const double cost = solution.path_->cost(objective).value();
        EXPECT_NEAR(solution.cost_.value(), cost, 1e-9 * cost) << "what the planner says of its path";
        EXPECT_GE(cost, admissibleHeuristic(*objective, problem->getStartState(0), stateAt(si, goal).get()).value());
        EXPECT_TRUE(solution.path_->check());
    }
}

TEST_P(ObjectiveWithPlanners, CostsInThePlaneAreWhatPathsCost)
{
    expectHonestCosts(GetParam(), SpaceKind::Plane);
}

TEST_P(ObjectiveWithPlanners, CostsOnCellsAreWhatPathsCost)
{
    expectHonestCosts(GetParam(), SpaceKind::Cells);
}

/// Asks for states as BIT* does: those whose solutions may cost at least what start and goal do, and anything more.
void expectSamplesWhereASolutionMayPass(const MakeObjective &make, SpaceKind kind)
{
    const auto occupancy = occupancyWith(HexLattice(Point(0, 0), 1.0, 20, 20), {});
    const auto si = chartSpace(occupancy, kind);
    const auto objective = make(si, *occupancy);
    // westward, with yaws to the east: two half turns
    const Point start = occupancy->lattice().centre(toCube({14, 10}));
    const Point goal = occupancy->lattice().centre(toCube({5, 10}));
    const auto problem = problemBetween(si, start, goal);
    problem->setOptimizationObjective(objective);
    const auto sampler = objective->allocInformedStateSampler(problem, 1000);
    ob::ScopedState<> state(si);
    int between = 0;
    for (int i = 0; i < 2000; ++i)
    {
        ASSERT_TRUE(sampler->sampleUniform(state.get(), ob::Cost(heuristic(*objective, start, goal)),
                                           objective->infiniteCost()));
        const Point p = positionOf(si, state.get());
        between += p.x() < start.x() && p.x() > goal.x() && std::abs(p.y() - start.y()) < 2.0 ? 1 : 0;
    }
    EXPECT_GT(between, 60) << "a tenth of all states";
}

TEST_P(ObjectiveWithPlanners, SamplesWhereASolutionMayPass)
{
    for (const SpaceKind kind : {SpaceKind::Plane, SpaceKind::Pose, SpaceKind::Cells})
        expectSamplesWhereASolutionMayPass(GetParam().make, kind);
}

TEST(ObjectiveSampling, OfLatticeLengthAndTurnsToo)
{
    expectSamplesWhereASolutionMayPass([](const auto &si, const HexOccupancy &occupancy)
                                       { return std::make_shared<LatticeLengthObjective>(si, occupancy.lattice()); },
                                       SpaceKind::Plane);
    expectSamplesWhereASolutionMayPass(
        [](const auto &si, const HexOccupancy &) { return std::make_shared<TurnAngleObjective>(si); }, SpaceKind::Pose);
}

TEST_P(ObjectiveWithPlanners, BitStarGetsAsGoodAsTheLattice)
{
    Random random(11);
    const auto occupancy = randomOccupancy(random, HexLattice(Point(0, 0), 1.0, 16, 16), 0.08);
    const auto si = chartSpace(occupancy);
    const auto objective = GetParam().make(si, *occupancy);
    Point start = freePoint(random, *occupancy);
    Point goal = freePoint(random, *occupancy);
    while ((goal - start).norm() < 9.0)
        goal = freePoint(random, *occupancy);
    const auto problem = problemBetween(si, start, goal);
    problem->setOptimizationObjective(objective);
    ASSERT_EQ(plannerFor(problem)->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    const double lattice = problem->getSolutionPath()->cost(objective).value();
    problem->clearSolutionPaths();
    const std::shared_ptr<ob::Planner> planner = std::make_shared<og::BITstar>(si);
    planner->setProblemDefinition(problem);
    const auto isAsGood = [&]
    {
        return problem->hasExactSolution() && problem->getSolutionPath()->cost(objective).value() < 1.1 * lattice;
    };
    for (int again = 0; again < 60 && !isAsGood(); ++again)
        planner->solve(0.1);
    EXPECT_TRUE(isAsGood());
}

INSTANTIATE_TEST_SUITE_P(Each, ObjectiveWithPlanners,
                         ::testing::Values(NamedObjective{"SafetyOnArrival", safetyOnArrival},
                                           NamedObjective{"SafetyAlongLine", safetyAlongLine},
                                           NamedObjective{"Clearance", clearance},
                                           NamedObjective{"WeightedSum", weightedSum},
                                           NamedObjective{"AsymmetricSum", asymmetricSum},
                                           NamedObjective{"MultiOptimization", omplsSum}),
                         [](const auto &instance) { return std::string(instance.param.name); });

TEST(ObjectiveOfPoses, CostsAreWhatPathsCost)
{
    const std::vector<NamedObjective> objectives = {{"TurnAngle",
                                                     [](const auto &si, const HexOccupancy &)
                                                     {
                                                         return std::make_shared<TurnAngleObjective>(si);
                                                     }},
                                                    {"TurnCount",
                                                     [](const auto &si, const HexOccupancy &)
                                                     {
                                                         return std::make_shared<TurnCountObjective>(si);
                                                     }},
                                                    {"WeightedSum", weightedSum}};
    for (const NamedObjective &objective : objectives)
    {
        SCOPED_TRACE(objective.name);
        expectHonestCosts(objective, SpaceKind::Pose);
    }
}

TEST(ObjectiveOfPoses, OnHexAStarsPathsTheyAreTheMetricsOfTheRoute)
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
    {
        Random random(seed);
        const HexLattice lattice(Point(random.real(-50, 50), random.real(-50, 50)), random.real(0.5, 3.0), 12, 12);
        const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.3));
        SCOPED_TRACE(random.seedText() + toPicture(*occupancy));
        const auto si = chartSpace(occupancy, SpaceKind::Pose);
        const auto problem = problemBetween(si, freePoint(random, *occupancy), freePoint(random, *occupancy));
        const auto planner = plannerFor(problem);
        if (planner->solve(10.0) != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        const auto path = pathOf(problem);
        const Route route = routeFromPath(*path);
        if (route.legCount() == 0)
            continue;
        ++found;
        // start and goal have yaw 0, so departing and arriving may be turns too
        const RouteMetrics metrics = measureRoute(route, *occupancy, CountedLegs::All);
        const double departure = std::abs(route.leg(0).heading());
        const double arrival = std::abs(route.leg(route.legCount() - 1).heading());
        EXPECT_NEAR(path->cost(std::make_shared<TurnAngleObjective>(si)).value(),
                    metrics.turnAngleRad + departure + arrival, 1e-9);
        EXPECT_EQ(path->cost(std::make_shared<TurnCountObjective>(si)).value(),
                  metrics.turns + (departure > leastTurnRad ? 1 : 0) + (arrival > leastTurnRad ? 1 : 0));
    }
    EXPECT_GT(found, 20);
}

}  // namespace
}  // namespace seahex::test
