#include <seahex/geometry/HexNorm.h>
#include <seahex/planning/HexAStar.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/OccupancyMotionValidator.h>
#include <seahex/planning/OccupancyValidityChecker.h>

#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"
#include "support/PlanningWorlds.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

constexpr std::array<Guidance, 6> guidances = {Guidance::Automatic, Guidance::None,     Guidance::Distance,
                                               Guidance::Cheng,     Guidance::TieBreak, Guidance::Relaxed};

/// Cost of a straight leg between a point and its cell's centre, in cells.
double legCost(const HexLattice &lattice, LengthMetric metric, const Point &p)
{
    const Point leg = lattice.centre(lattice.cellAt(p)) - p;
    return metric == LengthMetric::Lattice ? hexNorm(leg, lattice) : leg.norm() / lattice.pitch();
}

/// A random lattice with a free start and goal, and all that can be asked of them.
class Question
{
public:
    Question(std::uint64_t seed, SpaceKind kind) : random(seed)
    {
        const double pitch = random.chance(0.5) ? 1.0 : random.real(0.2, 60.0);
        const Point northWest =
            random.chance(0.5) ? Point(0, 0) : Point(random.real(-1e4, 1e4), random.real(-1e4, 1e4));
        const std::int64_t columns = random.integer(1, 12);
        const HexLattice lattice(northWest, pitch, columns, random.integer(1, 12));
        do
            occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.45));
        while (occupancy->blockedCount() == lattice.cellCount());
        start = freePoint(random, *occupancy);
        goal = freePoint(random, *occupancy);
        si = chartSpace(occupancy, kind);
        problem = problemBetween(si, start, goal);
    }

    const HexLattice &lattice() const { return occupancy->lattice(); }
    bool inOneCell() const { return lattice().cellAt(start) == lattice().cellAt(goal); }

    /// Cost in cells that Dijkstra's algorithm finds; the direct leg where both lie in one cell.
    double leastCost(int rings, LengthMetric metric) const
    {
        if (inOneCell())
            return metric == LengthMetric::Lattice ? hexNorm(goal - start, lattice())
                                                   : (goal - start).norm() / lattice().pitch();
        return jumpGraph(*occupancy, rings, metric)
            .cheapest({{vertexOf(lattice(), lattice().cellAt(start)), legCost(lattice(), metric, start)}},
                      {{vertexOf(lattice(), lattice().cellAt(goal)), legCost(lattice(), metric, goal)}});
    }

    void setMetric(LengthMetric metric)
    {
        if (metric == LengthMetric::Lattice)
            problem->setOptimizationObjective(std::make_shared<LatticeLengthObjective>(si, lattice()));
        else
            problem->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
    }

    Random random;
    std::shared_ptr<const HexOccupancy> occupancy;
    Point start;
    Point goal;
    ob::SpaceInformationPtr si;
    ob::ProblemDefinitionPtr problem;
};

/// What every solution must be, whatever was asked. @return cost of the path's legs in cells
double checkSolution(const Question &question, const HexAStar &planner, LengthMetric metric)
{
    ob::PlannerSolution solution(nullptr);
    EXPECT_TRUE(question.problem->getSolution(solution));
    auto &path = static_cast<og::PathGeometric &>(*solution.path_);
    EXPECT_TRUE(path.check());
    EXPECT_EQ(positionOf(question.si, path.getState(0)), question.start);
    EXPECT_TRUE(question.si->equalStates(path.getStates().back(),
                                         question.problem->getGoal()->as<ob::GoalState>()->getState()));
    EXPECT_EQ(solution.cost_.value(), path.cost(question.problem->getOptimizationObjective()).value());
    EXPECT_EQ(solution.plannerName_, planner.getName());
    EXPECT_FALSE(solution.approximate_);
    for (unsigned int i = 1; i + 1 < path.getStateCount(); ++i)
    {
        const Point p = positionOf(question.si, path.getState(i));
        EXPECT_EQ(p, question.lattice().centre(question.lattice().cellAt(p))) << "only centres lie between the ends";
    }
    return metric == LengthMetric::Lattice ? solution.cost_.value() : lengthOf(path) / question.lattice().pitch();
}

/// Solves the question for all rings, guidances and metrics and compares with Dijkstra's algorithm.
void compareWithDijkstra(Question &question, std::map<std::string, int> &seen)
{
    for (const LengthMetric metric : {LengthMetric::Euclidean, LengthMetric::Lattice})
    {
        question.setMetric(metric);
        for (int rings = 1; rings <= 3; ++rings)
        {
            const double least = question.leastCost(rings, metric);
            for (const Guidance guidance : guidances)
            {
                SCOPED_TRACE(toString(guidance) + std::string(" guidance, rings ") + std::to_string(rings) +
                             (metric == LengthMetric::Lattice ? ", lattice metric" : ", Euclidean"));
                question.problem->clearSolutionPaths();
                const auto planner = plannerFor(question.problem);
                planner->setRings(rings);
                planner->setGuidance(guidance);
                planner->setAllJumps(question.random.chance(0.5));
                const ob::PlannerStatus status = planner->solve(10.0);
                if (std::isinf(least))
                {
                    ASSERT_EQ(status, ob::PlannerStatus::TIMEOUT);
                    ASSERT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
                    ASSERT_LT(planner->searchMs(), 2000.0);
                    ASSERT_FALSE(question.problem->hasSolution());
                    ++seen["unreachable"];
                    continue;
                }
                ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
                ASSERT_EQ(planner->outcome(), PlanningOutcome::Found);
                const double cost = checkSolution(question, *planner, metric);
                const double tolerance = 1e-8 * (1.0 + least);
                EXPECT_GE(cost, least - tolerance);
                // the published guidance overestimates Euclidean costs of jumps over rings
                const bool admissible = guidance != Guidance::Cheng || metric == LengthMetric::Lattice || rings == 1;
                EXPECT_TRUE(!admissible || cost <= least + tolerance) << cost << " instead of " << least;
                ++seen[question.inOneCell() ? "one cell" : cost > least + tolerance ? "longer" : "least"];
            }
        }
    }
}

TEST(HexAStarOnChart, CostsWhatDijkstraFindsInThePlane)
{
    std::map<std::string, int> seen;
    for (std::uint64_t seed = 1; seed <= 400; ++seed)
    {
        Question question(seed, SpaceKind::Plane);
        SCOPED_TRACE(question.random.seedText() + toPicture(*question.occupancy));
        compareWithDijkstra(question, seen);
        if (HasFatalFailure() || HasNonfatalFailure())
            break;
    }
    EXPECT_GT(seen["least"], 4000);
    EXPECT_GT(seen["unreachable"], 300);
    EXPECT_GT(seen["one cell"], 300);
}

TEST(HexAStarOnChart, CostsWhatDijkstraFindsForPoses)
{
    std::map<std::string, int> seen;
    for (std::uint64_t seed = 1001; seed <= 1100; ++seed)
    {
        Question question(seed, SpaceKind::Pose);
        SCOPED_TRACE(question.random.seedText() + toPicture(*question.occupancy));
        // the space's distance charges for yaw, unless that has no weight
        question.si->getStateSpace()->as<ob::SE2StateSpace>()->setSubspaceWeight(1, 0.0);
        compareWithDijkstra(question, seen);
        if (HasFatalFailure() || HasNonfatalFailure())
            break;
    }
    EXPECT_GT(seen["least"], 1000);
}

TEST(HexAStarOnChart, YawAtEachCentreIsTheCourseOfTheLegThatLedThere)
{
    for (std::uint64_t seed = 1; seed <= 50; ++seed)
    {
        Question question(seed, SpaceKind::Pose);
        SCOPED_TRACE(question.random.seedText());
        if (plannerFor(question.problem)->solve(10.0) != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        const auto path = pathOf(question.problem);
        for (unsigned int i = 1; i + 1 < path->getStateCount(); ++i)
        {
            const Point leg =
                positionOf(question.si, path->getState(i)) - positionOf(question.si, path->getState(i - 1));
            const double yaw = path->getState(i)->as<ob::SE2StateSpace::StateType>()->getYaw();
            EXPECT_LT((Point(std::cos(yaw), std::sin(yaw)) * leg.norm() - leg).norm(), 1e-9);
            EXPECT_TRUE(question.si->satisfiesBounds(path->getState(i))) << yaw;
        }
    }
}

/// A checker or motion validator that only passes on what the chart's says, so that the planner can't know it.
class AskedChecker : public ob::StateValidityChecker
{
public:
    AskedChecker(const ob::SpaceInformationPtr &si, const std::shared_ptr<const HexOccupancy> &occupancy)
        : ob::StateValidityChecker(si), checker_(si, occupancy)
    {
    }
    bool isValid(const ob::State *state) const override { return checker_.isValid(state); }

private:
    OccupancyValidityChecker checker_;
};

class AskedMotionValidator : public ob::MotionValidator
{
public:
    AskedMotionValidator(const ob::SpaceInformationPtr &si, const std::shared_ptr<const HexOccupancy> &occupancy)
        : ob::MotionValidator(si), validator_(si, occupancy)
    {
    }
    bool checkMotion(const ob::State *s1, const ob::State *s2) const override { return validator_.checkMotion(s1, s2); }
    bool checkMotion(const ob::State *s1, const ob::State *s2, std::pair<ob::State *, double> &last) const override
    {
        return validator_.checkMotion(s1, s2, last);
    }

private:
    OccupancyMotionValidator validator_;
};

/// Bounds over which the planner itself lays the lattice's own centres.
Box boundsOfTheSameCentres(const HexLattice &lattice)
{
    const double pitch = lattice.pitch();
    const double side = lattice.side();
    const Point northWest = lattice.northWest() + Point(-1.5 * pitch, 2.5 * side);
    const Box box = lattice.bounds();
    return {Point(northWest.x(), box.min.y() - side), Point(box.max.x() + pitch, northWest.y())};
}

TEST(HexAStarOnChart, AskingTheProblemFindsWhatReadingTheOccupancyFinds)
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 150; ++seed)
    {
        Question question(seed, SpaceKind::Plane);
        SCOPED_TRACE(question.random.seedText() + toPicture(*question.occupancy));
        // from centre to centre both lattices join in the same places
        const HexLattice &lattice = question.lattice();
        question.start = lattice.centre(lattice.cellAt(question.start));
        question.goal = lattice.centre(lattice.cellAt(question.goal));
        const Box bounds = boundsOfTheSameCentres(lattice);
        const auto read =
            problemBetween(chartSpace(question.occupancy, SpaceKind::Plane, bounds), question.start, question.goal);
        const auto si = std::make_shared<ob::SpaceInformation>(spaceWithin(bounds, SpaceKind::Plane));
        si->setStateValidityChecker(std::make_shared<AskedChecker>(si, question.occupancy));
        si->setMotionValidator(std::make_shared<AskedMotionValidator>(si, question.occupancy));
        si->setup();
        const auto asked = problemBetween(si, question.start, question.goal);

        const auto reader = plannerFor(read);
        const auto asker = plannerFor(asked);
        asker->setCellSize(lattice.pitch());
        const int rings = static_cast<int>(question.random.integer(1, 3));
        reader->setRings(rings);
        asker->setRings(rings);
        const ob::PlannerStatus status = reader->solve(10.0);
        ASSERT_EQ(asker->solve(10.0).asString(), status.asString());
        ASSERT_EQ(asker->outcome(), reader->outcome());
        if (status != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++found;
        EXPECT_NEAR(lengthOf(*pathOf(asked)), lengthOf(*pathOf(read)), 1e-8 * (1.0 + lengthOf(*pathOf(read))));
        EXPECT_TRUE(pathOf(asked)->check());
    }
    EXPECT_GT(found, 80);
}

TEST(HexAStarOnChart, KeepsWithinBoundsNarrowerThanTheLattice)
{
    const AsciiWorld world(R"(
         . . . . .
        . A # B .
         . . # . .
        . . . . .
    )");
    for (const SpaceKind kind : {SpaceKind::Plane, SpaceKind::Pose})
    {
        // The short way leads over row 0, whose centres lie beyond the northern bound.
        const Box whole = world.lattice().bounds();
        const Box bounds{whole.min, Point(whole.max.x(), world.centre('A').y() + 0.3)};
        const auto free = problemBetween(chartSpace(world.shared(), kind), world.centre('A'), world.centre('B'));
        ASSERT_EQ(plannerFor(free)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        const auto problem =
            problemBetween(chartSpace(world.shared(), kind, bounds), world.centre('A'), world.centre('B'));
        ASSERT_EQ(plannerFor(problem)->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(pathOf(problem)->check());
        EXPECT_GT(lengthOf(*pathOf(problem)), lengthOf(*pathOf(free)));
    }
}

TEST(HexAStarOnChart, StaysValidUnderRandomBounds)
{
    int found = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Question question(seed, SpaceKind::Plane);
        SCOPED_TRACE(question.random.seedText() + toPicture(*question.occupancy));
        const Point a = question.random.pointIn(question.lattice().bounds());
        const Box bounds{question.start.cwiseMin(question.goal).cwiseMin(a) - Point(1e-3, 1e-3),
                         question.start.cwiseMax(question.goal).cwiseMax(a) + Point(1e-3, 1e-3)};
        const auto problem =
            problemBetween(chartSpace(question.occupancy, SpaceKind::Plane, bounds), question.start, question.goal);
        if (plannerFor(problem)->solve(5.0) != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++found;
        EXPECT_TRUE(pathOf(problem)->check());
    }
    EXPECT_GT(found, 50);
}

/// A chart's checker that forbids one more place.
class StricterChecker : public OccupancyValidityChecker
{
public:
    StricterChecker(const ob::SpaceInformationPtr &si, const std::shared_ptr<const HexOccupancy> &occupancy,
                    const Point &forbidden)
        : OccupancyValidityChecker(si, occupancy), forbidden_(forbidden)
    {
    }
    using OccupancyValidityChecker::isValid;
    bool isValid(const ob::State *state) const override
    {
        return OccupancyValidityChecker::isValid(state) &&
               (PlanarEmbedding(si_->getStateSpace().get()).position(state) - forbidden_).norm() > 0.9;
    }

private:
    Point forbidden_;
};

TEST(HexAStarOnChart, ADerivedCheckerIsAskedToo)
{
    const AsciiWorld world(R"(
         . . . . . . .
        . A . C . B .
         . . . . . . .
    )");
    const auto si = chartSpace(world.shared());
    si->setStateValidityChecker(std::make_shared<StricterChecker>(si, world.shared(), world.centre('C')));
    si->setup();
    const auto problem = problemBetween(si, world.centre('A'), world.centre('B'));
    const auto planner = plannerFor(problem);
    planner->setCellSize(0.25);
    ASSERT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    for (const ob::State *state : pathOf(problem)->getStates())
        EXPECT_TRUE(si->isValid(state));
    EXPECT_GT(lengthOf(*pathOf(problem)), 4.01) << "the straight way leads over the forbidden place";
}

}  // namespace
}  // namespace seahex::test
