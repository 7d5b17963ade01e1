#include <seahex/planning/HexAStar.h>
#include <seahex/planning/PlanarEmbedding.h>

#include "support/ExplicitGraph.h"
#include "support/HexOracle.h"
#include "support/PlanningWorlds.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

using Place = std::pair<double, double>;

Place placeOf(const Point &p)
{
    return {p.x(), p.y()};
}

/// What a planner asked, place by place and motion by motion, there and back counted as one.
struct Questions
{
    std::map<Place, int> states;
    std::map<std::pair<Place, Place>, int> motions;
    Watch *watch = nullptr;

    void tick() const
    {
        if (watch != nullptr)
            watch->tick();
    }
};

class CountingChecker : public ob::StateValidityChecker
{
public:
    CountingChecker(const ob::SpaceInformationPtr &si, const Discs &discs, Questions &questions)
        : ob::StateValidityChecker(si), discs_(discs), questions_(questions)
    {
    }
    bool isValid(const ob::State *state) const override
    {
        const Point p = PlanarEmbedding(si_->getStateSpace().get()).position(state);
        questions_.tick();
        ++questions_.states[placeOf(p)];
        return discs_.isFree(p);
    }

private:
    const Discs &discs_;
    Questions &questions_;
};

class CountingMotionValidator : public ob::MotionValidator
{
public:
    CountingMotionValidator(const ob::SpaceInformationPtr &si, const Discs &discs, Questions &questions)
        : ob::MotionValidator(si), discs_(discs), questions_(questions)
    {
    }
    bool checkMotion(const ob::State *s1, const ob::State *s2) const override
    {
        const PlanarEmbedding embedding(si_->getStateSpace().get());
        const Place a = placeOf(embedding.position(s1));
        const Place b = placeOf(embedding.position(s2));
        questions_.tick();
        ++questions_.motions[std::minmax(a, b)];
        return discs_.isFree(embedding.position(s1), embedding.position(s2));
    }
    bool checkMotion(const ob::State *s1, const ob::State *s2, std::pair<ob::State *, double> &) const override
    {
        return checkMotion(s1, s2);
    }

private:
    const Discs &discs_;
    Questions &questions_;
};

/// Discs in a box, a start and a goal between them, and whoever asks is counted.
class DiscWorld
{
public:
    DiscWorld(std::uint64_t seed, SpaceKind kind) : random(seed)
    {
        const Point corner = random.chance(0.5) ? Point(0, 0) : random.pointIn({Point(-500, -500), Point(500, 500)});
        const double size = random.chance(0.5) ? 1.0 : random.real(0.1, 200.0);
        const double width = random.real(0.5, 1.0);
        box = {corner, corner + size * Point(width, random.real(0.5, 1.0))};
        discs = randomDiscs(random, box, 5);
        start = freePoint();
        goal = freePoint();
        cellSize = size / static_cast<double>(random.integer(4, 14));
        si = std::make_shared<ob::SpaceInformation>(spaceWithin(box, kind));
        si->setStateValidityChecker(std::make_shared<CountingChecker>(si, discs, questions));
        si->setMotionValidator(std::make_shared<CountingMotionValidator>(si, discs, questions));
        si->setup();
        problem = problemBetween(si, start, goal);
    }

    Point freePoint()
    {
        for (;;)
        {
            const Point p = random.pointIn(box);
            if (discs.isFree(p))
                return p;
        }
    }

    Random random;
    Box box;
    Discs discs;
    Point start;
    Point goal;
    double cellSize;
    Questions questions;
    ob::SpaceInformationPtr si;
    ob::ProblemDefinitionPtr problem;
};

/// Least length from start to goal over the lattice's centres, in the plane's unit, by a graph written out with
/// SpaceInformation::checkMotion.
double leastLength(const ob::SpaceInformation &si, const HexLattice &lattice, const Box &bounds, const Point &start,
                   const Point &goal, int rings)
{
    const PlanarEmbedding embedding(si.getStateSpace().get());
    ob::State *from = si.allocState();
    ob::State *to = si.allocState();
    const auto holds = [&](const Point &a, const Point &b)
    {
        embedding.place(from, a);
        embedding.place(to, b);
        return si.checkMotion(from, to);
    };
    const auto isUsable = [&](HexCoord cell)
    {
        embedding.place(from, lattice.centre(cell));
        return lattice.contains(cell) && bounds.contains(lattice.centre(cell)) && si.isValid(from);
    };
    ExplicitGraph graph(static_cast<std::size_t>(lattice.cellCount()));
    std::vector<ExplicitGraph::Terminal> starts;
    std::vector<ExplicitGraph::Terminal> goals;
    forEachCell(lattice, 0,
                [&](HexCoord cell)
                {
                    if (!isUsable(cell))
                        return;
                    const Point centre = lattice.centre(cell);
                    forEachCell(lattice, 0,
                                [&](HexCoord other)
                                {
                                    const std::int64_t steps = hexDistance(cell, other);
                                    if (steps > 0 && steps <= rings && isUsable(other) &&
                                        holds(centre, lattice.centre(other)))
                                        graph.addEdge(vertexOf(lattice, cell), vertexOf(lattice, other),
                                                      (lattice.centre(other) - centre).norm());
                                });
                    if (hexDistance(cell, lattice.cellAt(start)) <= 1 && holds(start, centre))
                        starts.emplace_back(vertexOf(lattice, cell), (centre - start).norm());
                    if (hexDistance(cell, lattice.cellAt(goal)) <= 1 && holds(centre, goal))
                        goals.emplace_back(vertexOf(lattice, cell), (centre - goal).norm());
                });
    const bool direct = lattice.cellAt(start) == lattice.cellAt(goal) && holds(start, goal);
    si.freeState(from);
    si.freeState(to);
    return direct ? (goal - start).norm() : graph.cheapest(starts, goals);
}

void solveAndCompare(DiscWorld &world, std::map<std::string, int> &seen)
{
    const auto planner = plannerFor(world.problem);
    const int rings = static_cast<int>(world.random.integer(1, 3));
    constexpr std::array<Guidance, 5> admissible = {Guidance::Automatic, Guidance::None, Guidance::Distance,
                                                    Guidance::TieBreak, Guidance::Relaxed};
    planner->setRings(rings);
    planner->setGuidance(admissible[static_cast<std::size_t>(world.random.integer(0, 4))]);
    planner->setAllJumps(world.random.chance(0.5));
    planner->setCellSize(world.cellSize);
    Watch watch([](int) { return false; });
    world.questions.watch = &watch;
    const ob::PlannerStatus status = planner->solve(watch.condition());
    world.questions.watch = nullptr;
    EXPECT_LE(watch.mostTicks(), 16);
    ASSERT_DOUBLE_EQ(planner->cellSize(), world.cellSize);

    // the lattice's own questions; OMPL asks about start and goal
    for (const auto &[place, times] : world.questions.states)
        EXPECT_TRUE(times == 1 || place == placeOf(world.start) || place == placeOf(world.goal))
            << "cell at " << place.first << ", " << place.second;
    for (const auto &[motion, times] : world.questions.motions)
        EXPECT_LE(times, 1) << "motion from " << motion.first.first << ", " << motion.first.second;

    const double least =
        leastLength(*world.si, *planner->lattice(), world.box, world.start, world.goal, planner->getRings());
    if (std::isinf(least))
    {
        EXPECT_NE(status, ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_NE(planner->outcome(), PlanningOutcome::OutOfTime);
        ++seen["unreachable"];
        return;
    }
    ASSERT_EQ(status, ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_NEAR(lengthOf(*pathOf(world.problem)), least, 1e-8 * (least + world.cellSize));
    EXPECT_TRUE(pathOf(world.problem)->check());
    EXPECT_EQ(positionOf(world.si, pathOf(world.problem)->getStates().front()), world.start);
    EXPECT_EQ(positionOf(world.si, pathOf(world.problem)->getStates().back()), world.goal);
    ++seen[pathOf(world.problem)->getStateCount() == 2 ? "one cell" : "least"];
}

TEST(HexAStarWithNoChart, CostsWhatDijkstraFindsAndAsksOnce)
{
    std::map<std::string, int> seen;
    for (std::uint64_t seed = 1; seed <= 400; ++seed)
    {
        DiscWorld world(seed, SpaceKind::Plane);
        SCOPED_TRACE(world.random.seedText());
        solveAndCompare(world, seen);
        if (::testing::Test::HasFailure())
            break;
    }
    EXPECT_GT(seen["least"], 200);
    EXPECT_GT(seen["unreachable"], 10);
}

TEST(HexAStarWithNoChart, ServesOmplsOwnMotionValidator)
{
    int found = 0;
    for (std::uint64_t seed = 2001; seed <= 2100; ++seed)
    {
        DiscWorld world(seed, SpaceKind::Plane);
        SCOPED_TRACE(world.random.seedText());
        const auto si = std::make_shared<ob::SpaceInformation>(spaceWithin(world.box, SpaceKind::Plane));
        si->setStateValidityChecker([&](const ob::State *state) { return world.discs.isFree(positionOf(si, state)); });
        si->setup();
        const auto problem = problemBetween(si, world.start, world.goal);
        const auto planner = plannerFor(problem);
        planner->setCellSize(world.cellSize);
        const ob::PlannerStatus status = planner->solve(10.0);
        const double least = leastLength(*si, *planner->lattice(), world.box, world.start, world.goal, 3);
        ASSERT_EQ(status == ob::PlannerStatus::EXACT_SOLUTION, std::isfinite(least));
        if (status != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++found;
        EXPECT_NEAR(lengthOf(*pathOf(problem)), least, 1e-8 * (least + world.cellSize));
        EXPECT_TRUE(pathOf(problem)->check());
    }
    EXPECT_GT(found, 50);
}

TEST(HexAStarWithNoChart, LooksAtTheConditionEvery16QuestionsForPosesToo)
{
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
    {
        DiscWorld world(seed, SpaceKind::Pose);
        SCOPED_TRACE(world.random.seedText());
        Watch watch([](int) { return false; });
        world.questions.watch = &watch;
        const auto planner = plannerFor(world.problem);
        planner->setCellSize(world.cellSize);
        planner->solve(watch.condition());
        EXPECT_LE(watch.mostTicks(), 16);
        world.questions.watch = nullptr;
        EXPECT_TRUE(!world.problem->hasSolution() || pathOf(world.problem)->check());
    }
}

TEST(HexAStarWithNoChart, EveryLittleTimeBringsItOn)
{
    int interrupted = 0;
    for (const SpaceKind kind : {SpaceKind::Plane, SpaceKind::Pose})
        for (std::uint64_t seed = 1; seed <= 30; ++seed)
        {
            DiscWorld world(seed, kind);
            SCOPED_TRACE(world.random.seedText());
            const auto whole = plannerFor(world.problem);
            whole->setCellSize(world.cellSize);
            const ob::PlannerStatus expected = whole->solve(20.0);
            const auto path = pathOf(world.problem);

            world.problem->clearSolutionPaths();
            const auto planner = plannerFor(world.problem);
            planner->setCellSize(world.cellSize);
            int calls = 0;
            do
            {
                Watch watch([](int look) { return look >= 2; });
                planner->solve(watch.condition());
                ASSERT_LT(++calls, 100000);
            } while (planner->outcome() == PlanningOutcome::OutOfTime);
            interrupted += calls - 1;
            EXPECT_EQ(planner->outcome(), whole->outcome());
            if (expected == ob::PlannerStatus::EXACT_SOLUTION && pathOf(world.problem))
            {
                EXPECT_NEAR(lengthOf(*pathOf(world.problem)), lengthOf(*path), 1e-9 * (1.0 + lengthOf(*path)));
            }
        }
    EXPECT_GT(interrupted, 300);
}

TEST(HexAStarWithNoChart, NoTimeAtAllAsksAlmostNothing)
{
    DiscWorld world(5, SpaceKind::Plane);
    const auto planner = plannerFor(world.problem);
    planner->setCellSize(world.cellSize);
    Watch watch([](int) { return true; });
    world.questions.watch = &watch;
    EXPECT_EQ(planner->solve(watch.condition()), ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::OutOfTime);
    EXPECT_LE(world.questions.states.size() + world.questions.motions.size(), 4u);
}

TEST(HexAStarWithNoChart, TheLatticeCoversTheBoundsWithCellsOfTheSizeAskedFor)
{
    const Box box{Point(-20.0, 5.0), Point(80.0, 45.0)};
    const auto si = userSpace(box, SpaceKind::Plane, [](const ob::State *) { return true; });
    const auto problem = problemBetween(si, Point(-19.9, 5.1), Point(79.9, 44.9));
    const auto planner = plannerFor(problem);
    planner->setup();
    EXPECT_DOUBLE_EQ(planner->cellSize(), 0.5) << "a 200th of the largest extent";
    ASSERT_EQ(planner->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION) << "from corner to corner";
    EXPECT_TRUE(pathOf(problem)->check());
    planner->setCellSize(4.0);
    problem->clearSolutionPaths();
    ASSERT_EQ(planner->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_DOUBLE_EQ(planner->cellSize(), 4.0);
    for (unsigned int i = 0; i < pathOf(problem)->getStateCount(); ++i)
        EXPECT_TRUE(box.contains(positionOf(si, pathOf(problem)->getState(i))));
    EXPECT_LT(lengthOf(*pathOf(problem)), 1.1 * Point(99.8, 39.8).norm());
}

TEST(HexAStarWithNoChart, TooManyCellsAreRefusedAgainAndAgain)
{
    const auto si =
        userSpace({Point(0, 0), Point(1000, 1000)}, SpaceKind::Plane, [](const ob::State *) { return true; });
    const auto problem = problemBetween(si, Point(1, 1), Point(900, 900));
    for (const double size : {0.9, 1e-3, 1e-9, 1e-300})
    {
        const auto planner = plannerFor(problem);
        planner->setCellSize(size);
        EXPECT_THROW(planner->setup(), ompl::Exception) << size;
        EXPECT_FALSE(planner->isSetup());
        EXPECT_THROW(planner->solve(1.0), ompl::Exception) << size;
        planner->setCellSize(20.0);
        EXPECT_EQ(planner->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);
        problem->clearSolutionPaths();
    }
}

TEST(HexAStarWithNoChart, AStateThatReachesNoCentreIsInvalid)
{
    // a closed pen around the start, smaller than a cell
    Discs pen;
    for (int i = 0; i < 40; ++i)
    {
        pen.centres.push_back(Point(5.0, 5.0) + 0.2 * Point(std::cos(0.05 * 3.1416 * i), std::sin(0.05 * 3.1416 * i)));
        pen.radii.push_back(0.05);
    }
    Questions questions;
    const auto si = std::make_shared<ob::SpaceInformation>(spaceWithin({Point(0, 0), Point(10, 10)}, SpaceKind::Plane));
    si->setStateValidityChecker(std::make_shared<CountingChecker>(si, pen, questions));
    si->setMotionValidator(std::make_shared<CountingMotionValidator>(si, pen, questions));
    si->setup();
    for (const bool fromPen : {true, false})
    {
        const Point inside(5.0, 5.05);
        const auto planner =
            plannerFor(fromPen ? problemBetween(si, inside, Point(1, 1)) : problemBetween(si, Point(1, 1), inside));
        planner->setCellSize(1.0);
        planner->setup();
        ASSERT_FALSE(pen.isFree(inside, planner->lattice()->centre(planner->lattice()->cellAt(inside))));
        EXPECT_EQ(planner->solve(10.0), fromPen ? ob::PlannerStatus::INVALID_START : ob::PlannerStatus::INVALID_GOAL);
        EXPECT_EQ(planner->outcome(), fromPen ? PlanningOutcome::InvalidStart : PlanningOutcome::InvalidGoal);
    }
}

/// Where a long thin vehicle fits: no disc meets its keel line.
ob::StateValidityCheckerFn keelIsClear(const ob::SpaceInformationPtr &si, const Discs &discs, double halfLength)
{
    return [si = si.get(), &discs, halfLength](const ob::State *state)
    {
        const auto *pose = state->as<ob::SE2StateSpace::StateType>();
        const Point p(pose->getX(), pose->getY());
        const Point bow = halfLength * Point(std::cos(pose->getYaw()), std::sin(pose->getYaw()));
        return si->satisfiesBounds(state) && discs.isFree(p - bow, p + bow);
    };
}

TEST(HexAStarWithNoChart, ALongThinVehiclePassesWithTheYawOfItsCourse)
{
    int found = 0;
    int longer = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        DiscWorld world(seed, SpaceKind::Pose);
        SCOPED_TRACE(world.random.seedText());
        const auto si = std::make_shared<ob::SpaceInformation>(spaceWithin(world.box, SpaceKind::Pose));
        si->setStateValidityChecker(keelIsClear(si, world.discs, 1.2 * world.cellSize));
        si->setStateValidityCheckingResolution(0.005);
        si->setup();
        const auto problem = problemBetween(si, world.start, world.goal);
        const auto planner = plannerFor(problem);
        planner->setCellSize(world.cellSize);
        planner->setRings(static_cast<int>(world.random.integer(1, 3)));
        // the published guidance reopens cells, so that yaws change under motions that were asked for
        planner->setGuidance(world.random.chance(0.5) ? Guidance::Cheng : Guidance::Distance);
        planner->setTracing(true);
        if (planner->solve(20.0) != ob::PlannerStatus::EXACT_SOLUTION)
        {
            EXPECT_NE(planner->outcome(), PlanningOutcome::OutOfTime);
            continue;
        }
        ++found;
        EXPECT_EQ(planner->trace().size(), planner->counters().expanded);
        const auto path = pathOf(problem);
        EXPECT_TRUE(path->check());
        EXPECT_TRUE(si->equalStates(path->getStates().front(), stateAt(si, world.start).get()));
        EXPECT_TRUE(si->equalStates(path->getStates().back(), stateAt(si, world.goal).get()));
        for (unsigned int i = 1; i + 1 < path->getStateCount(); ++i)
        {
            const Point leg = positionOf(si, path->getState(i)) - positionOf(si, path->getState(i - 1));
            const double yaw = path->getState(i)->as<ob::SE2StateSpace::StateType>()->getYaw();
            EXPECT_LT((leg.norm() * Point(std::cos(yaw), std::sin(yaw)) - leg).norm(), 1e-9 * leg.norm());
        }
        longer += lengthOf(*path) > leastLength(*world.si, *planner->lattice(), world.box, world.start, world.goal, 3) *
                                        (1.0 + 1e-9)
                      ? 1
                      : 0;
    }
    EXPECT_GT(found, 15);
    EXPECT_GT(longer, 3) << "the vehicle's length matters";
}

TEST(HexAStarWithNoChart, AThinVehicleRunsAlongANarrowChannel)
{
    const Box box{Point(-2.5, 0.0), Point(2.5, 12.0)};
    const HexLattice lattice = HexLattice::covering(box, 1.0);
    const double north = 0.5 * std::acos(-1.0);
    Discs banks;
    for (int i = 0; i <= 120; ++i)
        for (const double x : {-0.45, 0.45})
        {
            banks.centres.push_back(Point(x, 0.1 * i));
            banks.radii.push_back(0.1);
        }
    const auto si = std::make_shared<ob::SpaceInformation>(spaceWithin(box, SpaceKind::Pose));
    si->setStateValidityChecker(keelIsClear(si, banks, 0.9));
    si->setStateValidityCheckingResolution(0.002);
    si->setup();
    // centres of even rows lie in mid-channel; the start is in one of them, or before it: there is no room to turn
    const Point centre = lattice.centre(toCube({2, 10}));
    ASSERT_EQ(centre.x(), 0.0);
    for (const Point &off : {Point(0.0, 0.0), Point(0.0, -0.4)})
    {
        SCOPED_TRACE(off.transpose());
        const auto problem = std::make_shared<ob::ProblemDefinition>(si);
        problem->setStartAndGoalStates(stateAt(si, centre + off, north), stateAt(si, Point(0.0, 10.5), north));
        const auto planner = plannerFor(problem);
        planner->setCellSize(1.0);
        EXPECT_EQ(planner->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION) << planner->counters().expanded;
        EXPECT_TRUE(!problem->hasSolution() || pathOf(problem)->check());
    }
}

TEST(HexAStarWithNoChart, AMotionThatFailsWithALaterYawIsTakenOutOfTheLattice)
{
    // A rare world: a cell is reached anew, from another side, after a jump from it was found valid.
    DiscWorld world(2769, SpaceKind::Pose);
    for (const int rings : {2, 3})
    {
        const auto si = std::make_shared<ob::SpaceInformation>(spaceWithin(world.box, SpaceKind::Pose));
        si->setStateValidityChecker(keelIsClear(si, world.discs, 1.2 * world.cellSize));
        si->setStateValidityCheckingResolution(0.005);
        si->setup();
        const auto problem = problemBetween(si, world.start, world.goal);
        const auto planner = plannerFor(problem);
        planner->setCellSize(world.cellSize);
        planner->setRings(rings);
        planner->setGuidance(Guidance::Cheng);
        ASSERT_EQ(planner->solve(20.0), ob::PlannerStatus::EXACT_SOLUTION);
        EXPECT_TRUE(pathOf(problem)->check());
    }
}

}  // namespace
}  // namespace seahex::test
