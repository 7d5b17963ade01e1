#include "planning/Dive.h"
#include "support/PrismOracle.h"
#include "support/Seabeds.h"

#include <seahex/planning/DiveSetup.h>
#include <seahex/planning/DiveStates.h>
#include <seahex/planning/PrismAStar.h>
#include <seahex/planning/SeabedMotionValidator.h>
#include <seahex/planning/SeabedValidityChecker.h>
#include <seahex/search/PrismMoves.h>

#include <ompl/base/terminationconditions/IterationTerminationCondition.h>
#include <ompl/util/Console.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

/// The seabed's own checker behind another face: a problem that must be asked.
class AskedValidityChecker : public SeabedValidityChecker
{
public:
    using SeabedValidityChecker::SeabedValidityChecker;
};

ob::SpaceInformationPtr waterOf(const std::shared_ptr<const DiveArena> &arena, bool mustBeAsked = false)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    auto si = std::make_shared<ob::SpaceInformation>(diveSpace(*arena));
    if (mustBeAsked)
        si->setStateValidityChecker(std::make_shared<AskedValidityChecker>(si, arena));
    else
        si->setStateValidityChecker(std::make_shared<SeabedValidityChecker>(si, arena));
    si->setMotionValidator(std::make_shared<SeabedMotionValidator>(si, arena));
    si->setup();
    return si;
}

/// A random seabed with or without columns that are kept out of, and how to plan on it.
struct World
{
    std::shared_ptr<const DiveArena> arena;
    Point3 start;
    Point3 goal;
    int rings;
    double climb;

    explicit World(Random &random, std::int64_t across = 14)
    {
        const auto seabed = randomSeabed(random, across, across, random.chance(0.5) ? 0.02 : 0.0);
        std::shared_ptr<const Occupancy> keepOut;
        const Box &box = seabed->grid().bounds();
        const double widest = (box.max - box.min).maxCoeff();
        if (random.chance(0.5))
            keepOut = randomOccupancy(random, HexLattice::covering(box, widest / 25.0), 0.05);
        arena = std::make_shared<const DiveArena>(seabed, DiveLimits{random.real(0.5, 5.0), random.real(0.0, 3.0)},
                                                  keepOut);
        start = freePosition(random, *arena);
        goal = freePosition(random, *arena);
        rings = static_cast<int>(random.integer(1, 3));
        climb = random.chance(0.4) ? 0.0 : random.real(0.05, 0.6);
    }
    double cellSize() const { return (arena->highest() - arena->lowest()).head<2>().maxCoeff() / 11.0; }
    std::shared_ptr<PrismAStar> planner(const ob::SpaceInformationPtr &si) const
    {
        auto planner = std::make_shared<PrismAStar>(si);
        planner->setRings(static_cast<unsigned int>(rings));
        planner->setClimb(climb);
        planner->setCellSize(cellSize());
        planner->setLayerThickness(std::min(6.0, climb == 0.0 ? 6.0 : climb * cellSize()));
        planner->setSmoothing(false);
        return planner;
    }
    /// On the lattice that the planner searched last; on any if it searched none.
    PrismOracle oracle(const std::optional<PrismLattice> &lattice) const
    {
        const HexLattice any(Point(0, 0), cellSize(), 1, 1);
        return {lattice ? *lattice : PrismLattice(any, 0.0, 1.0, 1), rings, climb,
                [this](const Point3 &a, const Point3 &b)
                {
                    return arena->isFree(a, b);
                }};
    }
    int jointSteps(const PrismLattice &lattice) const
    {
        const double run = climb == 0.0 ? 0.0 : lattice.thickness() / climb / lattice.pitch();
        return std::max(1, static_cast<int>(std::ceil(run)));
    }
    double optimum(const PrismLattice &lattice) const
    {
        const PrismOracle prisms = oracle(lattice);
        const int steps = jointSteps(lattice);
        return prisms.graph().cheapest(prisms.joints(start, steps, true), prisms.joints(goal, steps, false));
    }
    void expectSound(const std::vector<Point3> &path) const
    {
        ASSERT_GE(path.size(), 2u);
        EXPECT_EQ(path.front(), start);
        EXPECT_EQ(path.back(), goal);
        for (std::size_t i = 1; i < path.size(); ++i)
        {
            const Point3 by = path[i] - path[i - 1];
            if (climb > 0.0)
            {
                EXPECT_LE(std::abs(by.z()), climb * std::hypot(by.x(), by.y()) * (1.0 + 1e-8));
            }
            for (int k = 0; k <= 500; ++k)
            {
                const Point3 p = path[i - 1] + (k / 500.0) * by;
                ASSERT_GE(arena->seabed()->depthAt(horizontal(p)) - p.z(), arena->limits().clearanceM);
                ASSERT_GE(p.z(), arena->limits().ceilingM - 1e-9);
                if (arena->keepOut() != nullptr)
                {
                    ASSERT_TRUE(arena->keepOut()->isFree(
                        toOffset(arena->keepOut()->lattice().hexagons()->cellAt(horizontal(p)))));
                }
            }
        }
    }
};

TEST(PrismAStar, FindsTheOptimumOfItsLattice)
{
    int found = 0;
    int lost = 0;
    int straight = 0;
    forEachSeed(150,
                [&](Random &random)
                {
                    const World world(random);
                    const auto si = waterOf(world.arena);
                    const auto planner = world.planner(si);
                    const auto problem = dive(si, world.start, {world.goal});
                    const auto status = solve(*planner, problem);
                    if (isClimbable(world.goal - world.start, world.climb) &&
                        world.arena->isFree(world.start, world.goal))
                    {
                        ++straight;
                        EXPECT_EQ(solutionOf(problem), (std::vector<Point3>{world.start, world.goal}));
                        return;
                    }
                    ASSERT_TRUE(planner->lattice());
                    const double optimum = world.optimum(*planner->lattice());
                    if (status != ob::PlannerStatus::EXACT_SOLUTION)
                    {
                        ++lost;
                        EXPECT_EQ(status, ob::PlannerStatus::TIMEOUT);
                        EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
                        EXPECT_TRUE(std::isinf(optimum));
                        return;
                    }
                    ++found;
                    EXPECT_EQ(planner->outcome(), PlanningOutcome::Found);
                    EXPECT_NEAR(lengthOf(solutionOf(problem)), optimum, 1e-6 * optimum);
                    EXPECT_TRUE(problem->getSolutionPath()->check());
                    world.expectSound(solutionOf(problem));
                });
    EXPECT_GT(found, 50);
    EXPECT_GT(lost, 5);
    EXPECT_GT(straight, 5);
}

TEST(PrismAStar, AskedOrReadTheLatticeIsTheSame)
{
    int found = 0;
    forEachSeed(40,
                [&](Random &random)
                {
                    const World world(random);
                    // both have the same layers: from the ceiling to the deeper end
                    const auto read = waterOf(world.arena);
                    const auto asked = waterOf(world.arena, true);
                    auto bounds = static_cast<const ob::RealVectorStateSpace &>(*read->getStateSpace()).getBounds();
                    bounds.setHigh(2, std::max(world.start.z(), world.goal.z()));
                    for (const auto &si : {read, asked})
                        si->getStateSpace()->as<ob::RealVectorStateSpace>()->setBounds(bounds);
                    const auto first = dive(read, world.start, {world.goal});
                    const auto second = dive(asked, world.start, {world.goal});
                    const auto status = solve(*world.planner(read), first);
                    ASSERT_EQ(solve(*world.planner(asked), second), status);
                    found += status == ob::PlannerStatus::EXACT_SOLUTION ? 1 : 0;
                    EXPECT_EQ(solutionOf(first), solutionOf(second));
                });
    EXPECT_GT(found, 10);
}

TEST(PrismAStar, PulledTautItIsShorterAndAsSound)
{
    int shorter = 0;
    forEachSeed(60,
                [&](Random &random)
                {
                    const World world(random);
                    const auto si = waterOf(world.arena);
                    const auto planner = world.planner(si);
                    const auto plain = dive(si, world.start, {world.goal});
                    if (solve(*planner, plain) != ob::PlannerStatus::EXACT_SOLUTION)
                        return;
                    planner->setSmoothing(true);
                    const auto taut = dive(si, world.start, {world.goal});
                    ASSERT_EQ(solve(*planner, taut), ob::PlannerStatus::EXACT_SOLUTION);
                    EXPECT_LE(lengthOf(solutionOf(taut)), lengthOf(solutionOf(plain)) * (1.0 + 1e-12));
                    shorter += lengthOf(solutionOf(taut)) < 0.999 * lengthOf(solutionOf(plain)) ? 1 : 0;
                    EXPECT_TRUE(taut->getSolutionPath()->check());
                    world.expectSound(solutionOf(taut));
                });
    EXPECT_GT(shorter, 20);
}

TEST(PrismAStar, TheBestPairOfStartAndGoalWins)
{
    int searched = 0;
    int others = 0;
    forEachSeed(80,
                [&](Random &random)
                {
                    const World world(random);
                    const auto nearby = [&](const Point3 &p)
                    {
                        const double across = 0.2 * world.cellSize();
                        const Point3 by(random.real(-across, across), random.real(-across, across),
                                        random.real(-0.5, 0.0));
                        return world.arena->isFree(p + by) ? Point3(p + by) : p;
                    };
                    const std::vector<Point3> starts = {world.start, nearby(world.start)};
                    const std::vector<Point3> goals = {world.goal, nearby(world.goal)};
                    const auto si = waterOf(world.arena);
                    const auto problem = dive(si, starts[0], goals);
                    problem->addStartState(stateAt(si, starts[1]));
                    const auto planner = world.planner(si);
                    const auto status = solve(*planner, problem);
                    const PrismOracle oracle = world.oracle(planner->lattice());
                    double best = std::numeric_limits<double>::infinity();
                    std::vector<ExplicitGraph::Terminal> entries;
                    std::vector<ExplicitGraph::Terminal> exits;
                    for (int i = 0; i < 2; ++i)
                    {
                        for (const Point3 &goal : goals)
                            if (oracle.isMotion(starts[i], goal))
                                best = std::min(best, (goal - starts[i]).norm());
                        for (const auto &joint : oracle.joints(starts[i], world.jointSteps(oracle.lattice), true))
                            entries.push_back(joint);
                        for (const auto &joint : oracle.joints(goals[i], world.jointSteps(oracle.lattice), false))
                            exits.push_back(joint);
                    }
                    if (planner->lattice())
                    {
                        ++searched;
                        best = std::min(best, oracle.graph().cheapest(entries, exits));
                    }
                    ASSERT_EQ(status == ob::PlannerStatus::EXACT_SOLUTION, best < 1e9);
                    if (status != ob::PlannerStatus::EXACT_SOLUTION)
                        return;
                    const std::vector<Point3> path = solutionOf(problem);
                    EXPECT_NEAR(lengthOf(path), best, 1e-6 * best);
                    EXPECT_TRUE(problem->getSolutionPath()->check());
                    others += path.front() != starts[0] || path.back() != goals[0] ? 1 : 0;
                });
    EXPECT_GT(searched, 30);
    EXPECT_GT(others, 10);
}

TEST(PrismAStar, InterruptedItComesToTheSameAnswer)
{
    int searched = 0;
    forEachSeed(50,
                [&](Random &random)
                {
                    const World world(random);
                    for (const bool mustBeAsked : {false, true})
                        for (const bool smoothing : {false, true})
                        {
                            const auto si = waterOf(world.arena, mustBeAsked);
                            const auto whole = dive(si, world.start, {world.goal});
                            const auto planner = world.planner(si);
                            planner->setSmoothing(smoothing);
                            const auto status = solve(*planner, whole);
                            searched += planner->lattice() ? 1 : 0;
                            const std::uint64_t expanded = planner->counters().expanded;
                            const std::uint64_t generated = planner->counters().generated;
                            const auto pieces = dive(si, world.start, {world.goal});
                            planner->setProblemDefinition(pieces);
                            int calls = 0;
                            do
                            {
                                ob::IterationTerminationCondition few(static_cast<unsigned int>(random.integer(2, 5)));
                                planner->solve(ob::PlannerTerminationCondition(few));
                            } while (++calls < 1000000 && (planner->outcome() == PlanningOutcome::OutOfTime ||
                                                           planner->outcome() == PlanningOutcome::Improvable));
                            EXPECT_EQ(planner->outcome() == PlanningOutcome::Found,
                                      status == ob::PlannerStatus::EXACT_SOLUTION);
                            EXPECT_EQ(solutionOf(pieces), solutionOf(whole));
                            EXPECT_EQ(planner->counters().expanded, expanded);
                            EXPECT_EQ(planner->counters().generated, generated);
                        }
                });
    EXPECT_GT(searched, 60);
}

/// A seabed of one depth but for walls: nodes of these columns and rows are land.
std::shared_ptr<const DiveArena> walled(std::int64_t nodes, double depthM,
                                        const std::function<bool(std::int64_t, std::int64_t)> &isLand)
{
    std::vector<float> depths;
    for (std::int64_t row = 0; row < nodes; ++row)
        for (std::int64_t column = 0; column < nodes; ++column)
            depths.push_back(isLand(column, row) ? -5.0f : static_cast<float>(depthM));
    const NodeGrid grid(Point(0, 0), Point(10, 10), nodes, nodes);
    return std::make_shared<const DiveArena>(std::make_shared<const Bathymetry>(grid, std::move(depths)),
                                             DiveLimits{5.0, 1.0});
}

TEST(PrismAStar, WhereThereIsNoWayItSaysSo)
{
    const auto arena = walled(60, 50.0, [](std::int64_t column, std::int64_t) { return column == 30; });
    for (const bool mustBeAsked : {false, true})
    {
        const auto si = waterOf(arena, mustBeAsked);
        const auto planner = std::make_shared<PrismAStar>(si);
        planner->setCellSize(20.0);
        planner->setLayerThickness(10.0);
        const auto problem = dive(si, {100, 300, 10}, {{500, 300, 20}});
        for (int i = 0; i < 2; ++i)
        {
            EXPECT_EQ(solve(*planner, problem), ob::PlannerStatus::TIMEOUT);
            EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
        }
        ASSERT_TRUE(planner->lattice());
        EXPECT_TRUE(planner->lattice()->plane().bounds().contains({1, 1})) << "gave up before all was searched";
        EXPECT_TRUE(planner->lattice()->plane().bounds().contains({589, 589}));
    }
}

/// The only gap lies far outside the first box.
TEST(PrismAStar, TheBoxGrowsUntilThereIsAWay)
{
    const auto arena =
        walled(300, 50.0, [](std::int64_t column, std::int64_t row) { return column == 30 && row < 290; });
    const auto si = waterOf(arena);
    const auto planner = std::make_shared<PrismAStar>(si);
    const auto far = dive(si, {100, 300, 10}, {{500, 300, 20}});
    ASSERT_EQ(solve(*planner, far), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_GT(lengthOf(solutionOf(far)), 5200.0);
    EXPECT_LT(lengthOf(solutionOf(far)), 5400.0);
    EXPECT_TRUE(far->getSolutionPath()->check());
    const auto near = dive(si, {100, 2880, 10}, {{500, 2880, 20}});
    ASSERT_EQ(solve(*planner, near), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_FALSE(planner->lattice()->plane().bounds().contains({1500, 1500})) << "more was searched than had to be";
}

/// A sill that is passed at 4 m: whoever climbs little needs way for it.
TEST(PrismAStar, TheClimbIsKeptOverASill)
{
    std::vector<float> depths;
    for (int row = 0; row < 40; ++row)
        for (int column = 0; column < 100; ++column)
            depths.push_back(column >= 48 && column <= 52 ? 9.0f : 200.0f);
    const auto seabed = std::make_shared<const Bathymetry>(NodeGrid({0, 0}, {10, 10}, 100, 40), std::move(depths));
    const auto arena = std::make_shared<const DiveArena>(seabed, DiveLimits{5.0, 1.0});
    const auto si = waterOf(arena);
    const Point3 start(300, 200, 150);
    const Point3 goal(700, 200, 150);
    double before = 0.0;
    for (const double climb : {0.0, 2.0, 0.5, 0.25})
    {
        const auto planner = std::make_shared<PrismAStar>(si);
        planner->setClimb(climb);
        planner->setCellSize(10.0);
        const auto problem = dive(si, start, {goal});
        ASSERT_EQ(solve(*planner, problem), ob::PlannerStatus::EXACT_SOLUTION) << climb;
        const std::vector<Point3> path = solutionOf(problem);
        EXPECT_TRUE(problem->getSolutionPath()->check());
        double steepest = 0.0;
        for (std::size_t i = 1; i < path.size(); ++i)
            steepest =
                std::max(steepest, std::abs(path[i].z() - path[i - 1].z()) / (path[i] - path[i - 1]).head<2>().norm());
        if (climb > 0.0)
        {
            EXPECT_LE(steepest, climb * (1.0 + 1e-8));
            // up by 146 m and down again, as steeply as it can or as the straight way needs
            const double run = std::max(400.0, 2.0 * 146.0 / climb);
            EXPECT_GE(lengthOf(path), std::hypot(run, 2.0 * 146.0) * (1.0 - 1e-6));
        }
        EXPECT_GT(lengthOf(path), before);
        before = lengthOf(path) * 0.999;
    }
}

TEST(PrismAStar, AcrossALargeSeabed)
{
    // ridges that are passed through gaps now north, now south
    const auto arena = walled(1500, 80.0,
                              [](std::int64_t column, std::int64_t row)
                              {
                                  const std::int64_t ridge = column / 100;
                                  return column % 100 < 10 && ridge > 0 && (ridge % 2 == 0 ? row < 800 : row > 700);
                              });
    const auto si = waterOf(arena);
    const auto planner = std::make_shared<PrismAStar>(si);
    planner->setClimb(0.3);
    const auto problem = dive(si, {2500, 7500, 30}, {{12500, 7500, 60}});
    ASSERT_EQ(solve(*planner, problem), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_TRUE(problem->getSolutionPath()->check());
    EXPECT_GT(lengthOf(solutionOf(problem)), 10000.0);
    EXPECT_LT(lengthOf(solutionOf(problem)), 20000.0);
    EXPECT_LT(planner->lattice()->plane().cellCount(), 60000);
}

TEST(PrismAStar, TooManyNodesAreNotSearched)
{
    const auto arena = walled(60, 50.0, [](std::int64_t column, std::int64_t) { return column == 30; });
    const auto si = waterOf(arena);
    const auto planner = std::make_shared<PrismAStar>(si);
    for (const double thickness : {0.0, 1e-4})
    {
        planner->setCellSize(thickness > 0.0 ? 20.0 : 0.01);
        planner->setLayerThickness(thickness);
        EXPECT_EQ(solve(*planner, dive(si, {100, 300, 10}, {{500, 300, 20}})), ob::PlannerStatus::TIMEOUT);
        EXPECT_EQ(planner->outcome(), PlanningOutcome::Exhausted);
        EXPECT_FALSE(planner->lattice());
    }
}

}  // namespace
}  // namespace seahex::test
