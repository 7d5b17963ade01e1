// The true shortest path of the plane, and its proof, against a visibility graph over the corners of blocked cells.

#include <seahex/planning/HexAStar.h>
#include <seahex/world/SegmentValidity.h>

#include "support/AsciiWorld.h"
#include "support/PlanningWorlds.h"
#include "support/Random.h"
#include "support/VisibilityGraph.h"

#include <gtest/gtest.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <limits>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

double lowerBoundOf(const HexAStar &planner)
{
    return std::stod(planner.getPlannerProgressProperties().at("lower bound REAL")());
}

std::shared_ptr<const HexOccupancy> randomBay(Random &random)
{
    const HexLattice lattice(Point(5.0, 7.0), 2.0, random.integer(2, 14), random.integer(2, 12));
    return randomOccupancy(random, lattice, random.real(0.0, 0.45));
}

bool hasFreeCell(const HexOccupancy &occupancy)
{
    return occupancy.blockedCount() < occupancy.lattice().cellCount();
}

}  // namespace

TEST(HexAStarExact, FindsTheShortestPathOfThePlane)
{
    int proven = 0;
    forEachSeed(150,
                [&](Random &random)
                {
                    const auto world = randomBay(random);
                    if (!hasFreeCell(*world))
                        return;
                    const Point start = freePoint(random, *world);
                    const Point goal = freePoint(random, *world);
                    const double shortest = VisibilityGraph(*world).shortest(start, goal);
                    const auto problem = problemBetween(chartSpace(world), start, goal);
                    HexAStar planner(problem->getSpaceInformation());
                    planner.setProblemDefinition(problem);
                    planner.setAnytime(random.chance(0.5));
                    planner.setRings(static_cast<int>(random.integer(1, 3)));
                    const ob::PlannerStatus status = planner.solve(20.0);
                    ASSERT_EQ(status == ob::PlannerStatus::EXACT_SOLUTION,
                              shortest < std::numeric_limits<double>::infinity());
                    if (!status)
                        return;
                    const auto path = pathOf(problem);
                    EXPECT_GE(path->length(), shortest * (1.0 - 1e-9));
                    EXPECT_LE(path->length(), shortest + 3e-6 * (shortest + 2.0));
                    EXPECT_LE(lowerBoundOf(planner), shortest * (1.0 + 1e-9));
                    EXPECT_EQ(planner.outcome(), PlanningOutcome::Found);
                    for (std::size_t i = 1; i < path->getStateCount(); ++i)
                        EXPECT_TRUE(isFree(*world, positionOf(problem->getSpaceInformation(), path->getState(i - 1)),
                                           positionOf(problem->getSpaceInformation(), path->getState(i))));
                    proven += planner.isProvenShortest() ? 1 : 0;
                });
    EXPECT_GT(proven, 60);
}

TEST(HexAStarExact, BoundsGrowAndMeetHoweverOftenItIsInterrupted)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const auto world = randomBay(random);
                    if (!hasFreeCell(*world))
                        return;
                    const auto problem =
                        problemBetween(chartSpace(world), freePoint(random, *world), freePoint(random, *world));
                    HexAStar whole(problem->getSpaceInformation());
                    whole.setProblemDefinition(problem);
                    const ob::PlannerStatus status = whole.solve(20.0);
                    const double length = status ? pathOf(problem)->length() : 0.0;
                    problem->clearSolutionPaths();

                    HexAStar pieces(problem->getSpaceInformation());
                    pieces.setProblemDefinition(problem);
                    double bound = 0.0;
                    for (int sitting = 0; sitting < 200 && pieces.outcome() != PlanningOutcome::Found &&
                                          pieces.outcome() != PlanningOutcome::Exhausted;
                         ++sitting)
                    {
                        int looks = 0;
                        const auto last = pieces.solve(ob::PlannerTerminationCondition([&] { return ++looks > 3; }));
                        EXPECT_GE(lowerBoundOf(pieces), bound);
                        bound = lowerBoundOf(pieces);
                        if (last == ob::PlannerStatus::EXACT_SOLUTION)
                        {
                            EXPECT_LE(bound, pathOf(problem)->length());
                        }
                    }
                    EXPECT_EQ(pieces.outcome(), whole.outcome());
                    if (status)
                    {
                        EXPECT_NEAR(pathOf(problem)->length(), length, 1e-12 * length);
                        EXPECT_EQ(pieces.isProvenShortest(), whole.isProvenShortest());
                    }
                });
}

TEST(HexAStarExact, IsLeftOutWhereItIsNotAskedForOrDoesNotHold)
{
    Random random(8);
    const auto world = randomOccupancy(random, HexLattice(Point::Zero(), 1.0, 30, 30), 0.15);
    const Point start = freePoint(random, *world);
    const Point goal = freePoint(random, *world);
    const auto solve = [&](SpaceKind kind, const auto &settings)
    {
        const auto problem = problemBetween(chartSpace(world, kind), start, goal);
        HexAStar planner(problem->getSpaceInformation());
        planner.setProblemDefinition(problem);
        settings(planner);
        EXPECT_TRUE(planner.solve(20.0));
        return planner.isProvenShortest();
    };
    const auto asItIs = [](HexAStar &) {
    };
    EXPECT_TRUE(solve(SpaceKind::Plane, asItIs));
    EXPECT_FALSE(solve(SpaceKind::Pose, asItIs));
    EXPECT_FALSE(solve(SpaceKind::Cells, asItIs));
    EXPECT_FALSE(solve(SpaceKind::Plane, [](HexAStar &planner) { planner.setExact(false); }));
    EXPECT_FALSE(solve(SpaceKind::Plane, [](HexAStar &planner) { planner.setSmoothing(false); }));
    EXPECT_FALSE(solve(SpaceKind::Plane, [](HexAStar &planner) { planner.setDirect(false); }));
    EXPECT_FALSE(solve(SpaceKind::Plane, [](HexAStar &planner) { planner.setGuidance(Guidance::Distance); }));
}

TEST(HexAStarExact, ProvesNothingWhereBoundsLeaveOutWaterThatIsValid)
{
    // the tip of the blocked cell can be passed in the lower halves of the northern cells, whose centres are out
    const AsciiWorld world(R"(
         . . . . .
        . A # B .
         . . . . .
    )");
    const HexLattice &lattice = world.lattice();
    Box bounds = lattice.bounds();
    bounds.max.y() = lattice.centre(toCube(OffsetCoord{0, 0})).y() - 0.05;
    const Point lift(0.0, 0.3);
    const auto si = chartSpace(world.shared(), SpaceKind::Plane, bounds);
    const auto problem = problemBetween(si, world.centre('A') + lift, world.centre('B') + lift);
    HexAStar planner(si);
    planner.setProblemDefinition(problem);
    ASSERT_TRUE(planner.solve(20.0));
    EXPECT_EQ(planner.outcome(), PlanningOutcome::Found);

    const Point overTip = 0.5 * (world.centre('A') + world.centre('B')) + Point(0.0, lattice.side() + 0.01);
    const ob::ScopedState<> passing = stateAt(si, overTip);
    const auto found = pathOf(problem);
    ASSERT_TRUE(si->checkMotion(found->getStates().front(), passing.get()));
    ASSERT_TRUE(si->checkMotion(passing.get(), found->getStates().back()));
    const double shorter = (overTip - world.centre('A') - lift).norm() + (world.centre('B') + lift - overTip).norm();
    ASSERT_LT(shorter, found->length() - 0.1);
    EXPECT_FALSE(planner.isProvenShortest());
}

TEST(HexAStarExact, BoundsThatChangedAreHeededAfterClear)
{
    const AsciiWorld world(R"(
         . . . . .
        . A # B .
         . . . . .
    )");
    const Box whole = world.lattice().bounds();
    Box southern = whole;
    southern.max.y() = world.centre('A').y() + 0.5;
    const auto si = chartSpace(world.shared());
    const Point lift(0.0, 0.1);
    const auto problem = problemBetween(si, world.centre('A') + lift, world.centre('B') + lift);
    HexAStar planner(si);
    planner.setProblemDefinition(problem);
    const auto lengthWithin = [&](const Box &box)
    {
        ob::RealVectorBounds bounds(2);
        for (unsigned int axis = 0; axis < 2; ++axis)
        {
            bounds.setLow(axis, box.min[axis]);
            bounds.setHigh(axis, box.max[axis]);
        }
        si->getStateSpace()->as<ob::RealVectorStateSpace>()->setBounds(bounds);
        problem->clearSolutionPaths();
        planner.clear();
        EXPECT_TRUE(planner.solve(20.0));
        return pathOf(problem)->length();
    };
    const double northAbout = lengthWithin(whole);
    EXPECT_GT(lengthWithin(southern), northAbout + 0.05);
    EXPECT_FALSE(planner.isProvenShortest());
    EXPECT_EQ(lengthWithin(whole), northAbout);
    EXPECT_TRUE(planner.isProvenShortest());
}

TEST(HexAStarExact, BeginningAtWaterLeftOutIsAsGoodAsWithoutIt)
{
    int paths = 0;
    forEachSeed(60,
                [&](Random &random)
                {
                    const HexLattice lattice(Point(5.0, 7.0), 2.0, 25, 20);
                    const auto world = randomOccupancy(random, lattice, 0.25);
                    Box bounds = lattice.bounds();
                    const HexCoord leftOut = toCube(OffsetCoord{random.integer(1, 23), 0});
                    bounds.max.y() = lattice.centre(leftOut).y() - 0.1;
                    // by a hair in the row beneath, and still touching the cell left out
                    const Point start = lattice.centre(leftOut) - Point(0.0, lattice.side() + 1e-9);
                    const Point goal = lattice.centre(toCube(OffsetCoord{random.integer(1, 23), 19}));
                    const auto si = chartSpace(world, SpaceKind::Plane, bounds);
                    if (!isFree(*world, start, start) || !isFree(*world, goal, goal))
                        return;
                    const auto solve = [&](bool exact)
                    {
                        const auto problem = problemBetween(si, start, goal);
                        HexAStar planner(si);
                        planner.setProblemDefinition(problem);
                        planner.setExact(exact);
                        const ob::PlannerStatus status = planner.solve(20.0);
                        EXPECT_FALSE(planner.isProvenShortest());
                        return status ? pathOf(problem)->length() : std::numeric_limits<double>::infinity();
                    };
                    const double length = solve(true);
                    EXPECT_LE(length, solve(false));
                    paths += length < std::numeric_limits<double>::infinity() ? 1 : 0;
                });
    EXPECT_GT(paths, 10);
}

TEST(HexAStarExact, GuidanceMayBeChangedAndChangedBack)
{
    Random random(8);
    const auto world = randomOccupancy(random, HexLattice(Point::Zero(), 1.0, 30, 30), 0.15);
    const auto problem = problemBetween(chartSpace(world), freePoint(random, *world), freePoint(random, *world));
    HexAStar planner(problem->getSpaceInformation());
    planner.setProblemDefinition(problem);
    for (const Guidance guidance : {Guidance::Distance, Guidance::Automatic, Guidance::None, Guidance::Automatic})
    {
        planner.setGuidance(guidance);
        ASSERT_TRUE(planner.solve(20.0));
        EXPECT_EQ(planner.isProvenShortest(), guidance == Guidance::Automatic);
    }
}

}  // namespace seahex::test
