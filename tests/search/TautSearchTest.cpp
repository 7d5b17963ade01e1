#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/Random.h"
#include "support/VisibilityGraph.h"

#include <seahex/route/CornerOffset.h>
#include <seahex/search/TautSearch.h>
#include <seahex/world/CellBits.h>
#include <seahex/world/SegmentValidity.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace seahex::test
{
namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();
const double root3 = std::sqrt(3.0);

using World = std::shared_ptr<const HexOccupancy>;

bool never()
{
    return false;
}

/// The cells for which isBlocked(cell) holds, and no other.
template <class IsBlocked>
World worldOf(const HexLattice &lattice, IsBlocked &&isBlocked)
{
    const CellLayout layout(lattice.columns(), lattice.rows());
    CellBits bits(layout);
    forEachCell(lattice, 0,
                [&](HexCoord cell)
                {
                    const OffsetCoord at = toOffset(cell);
                    if (isBlocked(cell))
                        bits.setSpan(at.row, at.column, at.column);
                });
    bits.setOutside();
    return std::make_shared<HexOccupancy>(lattice, layout, bits.words());
}

HexLattice randomLattice(Random &random, std::int64_t least, std::int64_t most)
{
    const Point origin(random.real(-50.0, 50.0), random.real(-50.0, 50.0));
    const double pitch = random.real(0.5, 3.0);
    const std::int64_t columns = random.integer(least, most);
    return HexLattice(origin, pitch, columns, random.integer(least, most));
}

/// A few round islands.
World islands(Random &random, const HexLattice &lattice)
{
    std::vector<std::pair<Point, double>> discs(static_cast<std::size_t>(random.integer(1, 6)));
    for (auto &disc : discs)
        disc = {random.pointIn(lattice.bounds()), lattice.pitch() * random.real(0.3, 3.0)};
    return worldOf(lattice,
                   [&](HexCoord cell)
                   {
                       for (const auto &[centre, radius] : discs)
                           if ((lattice.centre(cell) - centre).norm() < radius)
                               return true;
                       return false;
                   });
}

/// Land through which random walks have dug channels one cell wide.
World channels(Random &random, const HexLattice &lattice)
{
    static constexpr HexCoord steps[6] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}};
    std::vector<HexCoord> dug;
    HexCoord cell = random.cellOf(lattice);
    HexCoord step = steps[0];
    const std::int64_t count = lattice.cellCount();
    for (std::int64_t i = 0; i < count; ++i)
    {
        dug.push_back(cell);
        if (random.chance(0.5))
            step = steps[random.integer(0, 5)];
        if (lattice.contains(cell + step))
            cell = cell + step;
    }
    return worldOf(lattice, [&](HexCoord c) { return std::find(dug.begin(), dug.end(), c) == dug.end(); });
}

/// A point of a free cell that touches no blocked one.
Point freePoint(Random &random, const HexOccupancy &occupancy)
{
    while (true)
    {
        const HexCoord cell = random.cellOf(occupancy.lattice());
        const Point p = random.pointOf(occupancy.lattice(), cell);
        if (isFree(occupancy, p, p))
            return p;
    }
}

/// Searches between two points and holds all that comes of it against the graph.
void expectShortest(TautSearch &search, const HexOccupancy &occupancy, const VisibilityGraph &graph, const Point &start,
                    const Point &goal)
{
    SCOPED_TRACE(::testing::Message() << start.transpose() << " to " << goal.transpose());
    const double expected = graph.shortest(start, goal);
    search.begin(start, goal);
    const SearchStatus status = search.run(never, 1000);
    ASSERT_EQ(status, std::isfinite(expected) ? SearchStatus::Found : SearchStatus::Exhausted);
    EXPECT_EQ(search.hasPath(), std::isfinite(expected));
    EXPECT_EQ(search.lowerBound(), search.length());
    if (!std::isfinite(expected))
    {
        EXPECT_EQ(search.length(), infinite);
        EXPECT_TRUE(search.path().empty());
        EXPECT_TRUE(search.route().empty());
        return;
    }
    const double rounding = 1e-9 * (expected + occupancy.lattice().pitch());
    ASSERT_NEAR(search.length(), expected, rounding);

    const Route taut(search.path());
    ASSERT_GE(taut.waypoints().size(), 2U);
    EXPECT_EQ(taut.waypoints().front(), start);
    EXPECT_EQ(taut.waypoints().back(), goal);
    EXPECT_NEAR(taut.length(), search.length(), rounding);
    for (std::size_t i = 0; i < taut.legCount(); ++i)
        EXPECT_TRUE(graph.sees(taut.leg(i).from, taut.leg(i).to)) << "leg " << i;

    const Route route = search.route();
    ASSERT_FALSE(route.empty());
    EXPECT_EQ(route.waypoints().front(), start);
    EXPECT_EQ(route.waypoints().back(), goal);
    for (std::size_t i = 0; i < route.legCount(); ++i)
        EXPECT_TRUE(isFree(occupancy, route.leg(i).from, route.leg(i).to)) << "leg " << i;
    EXPECT_GE(route.length(), expected - rounding);
    EXPECT_LE(route.length(),
              expected + rounding + cornerOffset(occupancy, taut) * static_cast<double>(route.waypoints().size()));
    EXPECT_TRUE(search.isOptimal(route.length()));
    EXPECT_FALSE(search.isOptimal(1.00001 * route.length() + 0.0001 * occupancy.lattice().pitch()));
}

/// As many queries between random points of a world.
void expectShortestPaths(Random &random, const World &world, int queries)
{
    if (world->blockedCount() == world->lattice().cellCount())
        return;
    const VisibilityGraph graph(*world);
    TautSearch search(*world);
    for (int i = 0; i < queries && !::testing::Test::HasFailure(); ++i)
    {
        const Point start = freePoint(random, *world);
        expectShortest(search, *world, graph, start, freePoint(random, *world));
    }
}

TEST(TautSearch, IsTheShortestPathOfTheVisibilityGraphInNoise)
{
    forEachSeed(500,
                [](Random &random)
                {
                    const double density = random.real(0.0, 0.5);
                    const HexLattice lattice = randomLattice(random, 2, 9);
                    expectShortestPaths(random, randomOccupancy(random, lattice, density), 10);
                });
}

TEST(TautSearch, IsTheShortestPathOfTheVisibilityGraphAmongIslands)
{
    forEachSeed(60,
                [](Random &random) { expectShortestPaths(random, islands(random, randomLattice(random, 6, 16)), 10); });
}

TEST(TautSearch, IsTheShortestPathOfTheVisibilityGraphInChannels)
{
    forEachSeed(200, [](Random &random)
                { expectShortestPaths(random, channels(random, randomLattice(random, 3, 12)), 10); });
}

TEST(TautSearch, IsTheShortestPathOfTheVisibilityGraphInEveryWorldOfNineCells)
{
    const HexLattice lattice(Point::Zero(), 1.0, 3, 3);
    for (unsigned pattern = 0; pattern < 512; ++pattern)
    {
        SCOPED_TRACE(pattern);
        const World world = worldOf(lattice,
                                    [pattern](HexCoord cell)
                                    {
                                        const OffsetCoord at = toOffset(cell);
                                        return ((pattern >> (3 * at.row + at.column)) & 1U) != 0;
                                    });
        const VisibilityGraph graph(*world);
        TautSearch search(*world);
        // centres, and the corners and middles of edges between free cells
        std::vector<Point> places;
        forEachCell(lattice, 0,
                    [&](HexCoord cell)
                    {
                        const auto corners = lattice.corners(cell);
                        for (const Point &p :
                             {lattice.centre(cell), corners[0], corners[1], Point(0.5 * (corners[1] + corners[2])),
                              Point(0.25 * corners[0] + 0.75 * corners[1])})
                            if (isFree(*world, p, p))
                                places.push_back(p);
                    });
        for (const Point &start : places)
            for (const Point &goal : places)
            {
                expectShortest(search, *world, graph, start, goal);
                if (HasFailure())
                    return;
            }
    }
}

TEST(TautSearch, TurnsAtTheTipsOfAWall)
{
    // Two cells stand in the straight way; pitch 1, so that A and B are 6 apart.
    const AsciiWorld world(R"(
         . . . . . . .
        . . . # . . .
         A . . # . . B
        . . . . . . .
         . . . . . . .
    )");
    // The way leads under the second: its lower tip lies a side below the row of A and B, halfway between them.
    const double side = 1.0 / root3;
    TautSearch search(world.occupancy());
    search.begin(world.centre('A'), world.centre('B'));
    ASSERT_EQ(search.run(never, 1), SearchStatus::Found);
    EXPECT_NEAR(search.length(), 2.0 * std::hypot(3.0, side), 1e-12);
    ASSERT_EQ(search.path().size(), 3U);
    EXPECT_NEAR((search.path()[1] - (world.lattice().centre(toCube({3, 2})) - Point(0.0, side))).norm(), 0.0, 1e-12);
}

TEST(TautSearch, SeesAlongAWallOfTips)
{
    // A and B lie on the very line of the wall's lower tips: the way is straight and touches every one.
    const AsciiWorld world(R"(
         . . . . . . . . .
        . . # # # # # . .
         . . . . . . . . .
        . . . . . . . . .
    )");
    const HexLattice &lattice = world.lattice();
    const Point tip = lattice.corners(toCube({2, 1}))[3];
    const Point start = tip - Point(1.0, 0.0);
    const Point goal = tip + Point(5.0, 0.0);
    TautSearch search(world.occupancy());
    search.begin(start, goal);
    ASSERT_EQ(search.run(never, 1), SearchStatus::Found);
    EXPECT_NEAR(search.length(), 6.0, 1e-12);
    const Route route = search.route();
    ASSERT_FALSE(route.empty());
    EXPECT_NEAR(route.length(), 6.0, 1e-5);
    EXPECT_FALSE(isFree(world.occupancy(), start, goal));
}

TEST(TautSearch, HasNoPathFromOrToWhatIsBlockedOutsideOrNoNumber)
{
    const AsciiWorld world(R"(
         A . #
        . . .
    )");
    const Point a = world.centre('A');
    const Point blocked = world.lattice().centre(toCube({2, 0}));
    TautSearch search(world.occupancy());
    for (const Point &bad : {blocked, Point(-5.0, 0.0), Point(infinite, 0.0), Point(std::nan(""), 0.0)})
    {
        search.begin(a, bad);
        EXPECT_EQ(search.run(never, 1), SearchStatus::Exhausted);
        EXPECT_EQ(search.lowerBound(), infinite);
        search.begin(bad, a);
        EXPECT_EQ(search.run(never, 1), SearchStatus::Exhausted);
        EXPECT_FALSE(search.hasPath());
    }
    search.begin(a, a);
    EXPECT_EQ(search.run(never, 1), SearchStatus::Found);
    EXPECT_EQ(search.length(), 0.0);
}

TEST(TautSearch, LowerBoundNeverFallsNorExceedsTheShortestPath)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const HexLattice lattice = randomLattice(random, 10, 30);
                    const World world = randomOccupancy(random, lattice, 0.3);
                    const Point start = freePoint(random, *world);
                    const Point goal = freePoint(random, *world);
                    TautSearch search(*world);
                    search.begin(start, goal);
                    search.run(never, 1000);
                    const double length = search.length();
                    const std::uint64_t expanded = search.expanded();

                    search.begin(start, goal);
                    double least = 0.0;
                    int calls = 0;
                    while (search.run([&calls] { return calls++ % 2 == 1; }, 1) == SearchStatus::Stopped)
                    {
                        EXPECT_GE(search.lowerBound(), least);
                        least = search.lowerBound();
                        EXPECT_LE(least, length * (1.0 + 1e-12));
                        EXPECT_FALSE(search.hasPath());
                    }
                    EXPECT_EQ(search.length(), length);
                    EXPECT_EQ(search.expanded(), expanded);
                });
}

TEST(TautSearch, IsAsLongBackAsThere)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const HexLattice lattice = randomLattice(random, 20, 60);
                    const World world = randomOccupancy(random, lattice, random.real(0.05, 0.4));
                    TautSearch search(*world);
                    for (int i = 0; i < 10; ++i)
                    {
                        const Point a = freePoint(random, *world);
                        const Point b = freePoint(random, *world);
                        search.begin(a, b);
                        const SearchStatus there = search.run(never, 1000);
                        const double length = search.length();
                        search.begin(b, a);
                        EXPECT_EQ(search.run(never, 1000), there);
                        if (std::isfinite(length))
                        {
                            EXPECT_NEAR(search.length(), length, 1e-11 * length);
                        }
                    }
                });
}

TEST(TautSearch, FindsNothingAsLongAsTheBoundAndProvesIt)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const HexLattice lattice = randomLattice(random, 10, 30);
                    const World world = randomOccupancy(random, lattice, 0.3);
                    const Point start = freePoint(random, *world);
                    const Point goal = freePoint(random, *world);
                    TautSearch search(*world);
                    search.begin(start, goal);
                    if (search.run(never, 1000) != SearchStatus::Found || search.length() == 0.0)
                        return;
                    const double length = search.length();
                    const double longer = length * (1.0 + 1e-9);
                    search.begin(start, goal, longer);
                    EXPECT_EQ(search.run(never, 1000), SearchStatus::Found);
                    EXPECT_EQ(search.length(), length);
                    const double shorter = length * (1.0 - 1e-9);
                    search.begin(start, goal, shorter);
                    EXPECT_LE(search.lowerBound(), shorter * (1.0 + 1e-15));
                    EXPECT_EQ(search.run(never, 1000), SearchStatus::Exhausted);
                    EXPECT_DOUBLE_EQ(search.lowerBound(), shorter);
                    EXPECT_TRUE(search.isOptimal(shorter));
                });
}

}  // namespace
}  // namespace seahex::test
