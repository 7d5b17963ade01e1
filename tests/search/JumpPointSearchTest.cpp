// JumpPointSearch against breadth-first search.

#include <seahex/search/JumpPointSearch.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/Random.h"

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

using World = std::shared_ptr<const HexOccupancy>;

constexpr std::array<HexCoord, 6> neighbours = {HexCoord{1, 0},  HexCoord{1, -1}, HexCoord{0, -1},
                                                HexCoord{-1, 0}, HexCoord{-1, 1}, HexCoord{0, 1}};

/// The least numbers of steps from one cell to all others: with equal costs Dijkstra's algorithm is a queue.
class LeastSteps
{
public:
    LeastSteps(const HexOccupancy &occupancy, HexCoord from)
        : layout_(occupancy.layout()), steps_(layout_.size(), unreached)
    {
        std::deque<HexCoord> queue = {from};
        steps_[layout_.index(from)] = 0;
        for (; !queue.empty(); queue.pop_front())
            for (const HexCoord step : neighbours)
            {
                const HexCoord next = queue.front() + step;
                if (occupancy.isBlocked(next) || steps_[layout_.index(next)] != unreached)
                    continue;
                steps_[layout_.index(next)] = steps_[layout_.index(queue.front())] + 1;
                queue.push_back(next);
            }
    }

    /// Infinite where no path leads.
    double operator()(HexCoord to) const
    {
        const int steps = steps_[layout_.index(to)];
        return steps == unreached ? std::numeric_limits<double>::infinity() : steps;
    }

private:
    static constexpr int unreached = -1;

    CellLayout layout_;
    std::vector<int> steps_;
};

void expectSteps(const std::vector<CellIndex> &path, const HexOccupancy &occupancy, HexCoord start, HexCoord goal)
{
    ASSERT_FALSE(path.empty());
    const CellLayout &layout = occupancy.layout();
    EXPECT_EQ(layout.cell(path.front()), start);
    EXPECT_EQ(layout.cell(path.back()), goal);
    for (const CellIndex cell : path)
        EXPECT_FALSE(occupancy.isBlockedAt(cell));
    for (std::size_t i = 1; i < path.size(); ++i)
        EXPECT_EQ(hexDistance(layout.cell(path[i - 1]), layout.cell(path[i])), 1);
}

void expectShortest(JumpPointSearch &search, const HexOccupancy &occupancy, const LeastSteps &least, HexCoord start,
                    HexCoord goal)
{
    search.begin(start, goal);
    const bool isThere = least(goal) < std::numeric_limits<double>::infinity();
    ASSERT_EQ(search.run(), isThere ? SearchStatus::Found : SearchStatus::Exhausted);
    EXPECT_EQ(search.hasPath(), isThere);
    EXPECT_EQ(search.cost(), least(goal)) << toPicture(occupancy);
    EXPECT_EQ(search.lowerBound(), least(goal));
    const std::vector<CellIndex> path = search.path();
    EXPECT_EQ(path.empty(), !isThere);
    if (!isThere)
        return;
    EXPECT_EQ(static_cast<double>(path.size() - 1), search.cost());
    expectSteps(path, occupancy, start, goal);
}

std::vector<HexCoord> freeCells(const HexOccupancy &occupancy)
{
    std::vector<HexCoord> cells;
    forEachCell(occupancy.lattice(), 0,
                [&](HexCoord cell)
                {
                    if (occupancy.isFree(cell))
                        cells.push_back(cell);
                });
    return cells;
}

HexCoord anyOf(Random &random, const std::vector<HexCoord> &cells)
{
    return cells[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(cells.size()) - 1))];
}

/// Queries between random cells; one search answers them all.
void expectShortestInside(Random &random, const HexOccupancy &occupancy, int starts, int goals)
{
    const std::vector<HexCoord> cells = freeCells(occupancy);
    if (cells.empty())
        return;
    JumpPointSearch search(occupancy);
    for (int i = 0; i < starts; ++i)
    {
        const HexCoord start = anyOf(random, cells);
        const LeastSteps least(occupancy, start);
        for (int k = 0; k < goals; ++k)
            expectShortest(search, occupancy, least, start, anyOf(random, cells));
    }
}

/// Cells blocked but for corridors one cell wide, without loops but for the few that are broken open.
World maze(Random &random, const HexLattice &lattice)
{
    std::map<HexCoord, bool> isOpen;
    std::vector<HexCoord> trail = {{0, 0}};
    isOpen[trail.front()] = true;
    while (!trail.empty())
    {
        std::vector<HexCoord> ways;
        for (const HexCoord step : neighbours)
            if (const HexCoord to = trail.back() + 2 * step; lattice.contains(to) && !isOpen[to])
                ways.push_back(step);
        if (ways.empty())
        {
            trail.pop_back();
            continue;
        }
        const HexCoord step = anyOf(random, ways);
        isOpen[trail.back() + step] = true;
        trail.push_back(trail.back() + 2 * step);
        isOpen[trail.back()] = true;
    }
    std::vector<HexCoord> walls;
    const double broken = random.real(0.0, 0.1);
    forEachCell(lattice, 0,
                [&](HexCoord cell)
                {
                    if (!isOpen[cell] && !random.chance(broken))
                        walls.push_back(cell);
                });
    return occupancyWith(lattice, walls);
}

/// Round islands in open water.
World amongIslands(Random &random, std::int64_t columns, std::int64_t rows)
{
    const HexLattice lattice(Point::Zero(), 1.0, columns, rows);
    std::vector<HexCoord> islands;
    for (std::int64_t i = random.integer(1, 30); i > 0; --i)
    {
        const Point middle = lattice.centre(random.cellOf(lattice));
        const double radius = random.real(1.0, 0.12 * static_cast<double>(columns));
        forEachCell(lattice, 0,
                    [&](HexCoord cell)
                    {
                        if ((lattice.centre(cell) - middle).norm() < radius)
                            islands.push_back(cell);
                    });
    }
    return occupancyWith(lattice, islands);
}

}  // namespace

TEST(JumpPointSearch, TakesAsManyStepsAsABreadthFirstSearch)
{
    forEachSeed(6000,
                [](Random &random)
                {
                    const HexLattice lattice(Point(5.0, 7.0), 2.0, random.integer(1, 40), random.integer(1, 30));
                    const double density = random.chance(0.3) ? 0.05 : random.real(0.0, 0.6);
                    expectShortestInside(random, *randomOccupancy(random, lattice, density), 2, 5);
                });
}

TEST(JumpPointSearch, TakesAsManyStepsInWorldsOfManyWords)
{
    forEachSeed(200,
                [](Random &random)
                {
                    const HexLattice lattice(Point::Zero(), 1.0, random.integer(100, 200), random.integer(100, 200));
                    expectShortestInside(random, *randomOccupancy(random, lattice, random.real(0.0, 0.4)), 2, 8);
                });
}

TEST(JumpPointSearch, TakesAsManyStepsInMazes)
{
    forEachSeed(100,
                [](Random &random)
                {
                    const HexLattice lattice(Point::Zero(), 1.0, random.integer(1, 90), random.integer(1, 60));
                    expectShortestInside(random, *maze(random, lattice), 2, 6);
                });
}

TEST(JumpPointSearch, TakesAsManyStepsAmongIslands)
{
    forEachSeed(200,
                [](Random &random)
                {
                    const World world = amongIslands(random, random.integer(20, 140), random.integer(20, 140));
                    expectShortestInside(random, *world, 3, 8);
                });
}

TEST(JumpPointSearch, TakesAsManyStepsInOneRowAndOneColumn)
{
    forEachSeed(100,
                [](Random &random)
                {
                    const std::int64_t length = random.integer(1, 200);
                    const double density = random.chance(0.3) ? 0.0 : 0.02;
                    const HexLattice row(Point::Zero(), 1.0, length, random.integer(1, 2));
                    expectShortestInside(random, *randomOccupancy(random, row, density), 2, 4);
                    const HexLattice column(Point::Zero(), 1.0, random.integer(1, 2), length);
                    expectShortestInside(random, *randomOccupancy(random, column, density), 2, 4);
                });
}

TEST(JumpPointSearch, EveryPairOfASmallWorld)
{
    const AsciiWorld world(R"(
         . . # . . . .
        . # . . # # .
         . . # . . # .
        # . . # . . .
         . # . . # . #
        . . . # . . .
    )");
    JumpPointSearch search(world.occupancy());
    const std::vector<HexCoord> cells = freeCells(world.occupancy());
    for (const HexCoord start : cells)
    {
        const LeastSteps least(world.occupancy(), start);
        for (const HexCoord goal : cells)
            expectShortest(search, world.occupancy(), least, start, goal);
    }
}

TEST(JumpPointSearch, EveryWorldOfThreeRowsAndFourColumns)
{
    const HexLattice lattice(Point::Zero(), 1.0, 4, 3);
    for (unsigned int world = 0; world < 1U << 12; ++world)
    {
        std::vector<HexCoord> blocked;
        unsigned int bits = world;
        forEachCell(lattice, 0,
                    [&](HexCoord cell)
                    {
                        if (bits & 1)
                            blocked.push_back(cell);
                        bits >>= 1;
                    });
        const World occupancy = occupancyWith(lattice, blocked);
        const std::vector<HexCoord> cells = freeCells(*occupancy);
        if (cells.empty())
            continue;
        JumpPointSearch search(*occupancy);
        for (const HexCoord start : {cells.front(), cells[cells.size() / 2]})
        {
            const LeastSteps least(*occupancy, start);
            for (const HexCoord goal : cells)
                expectShortest(search, *occupancy, least, start, goal);
        }
    }
}

TEST(JumpPointSearch, IsTheSameHoweverOftenItIsInterruptedAndUsed)
{
    forEachSeed(40,
                [](Random &random)
                {
                    const World world = amongIslands(random, 90, 80);
                    const std::vector<HexCoord> cells = freeCells(*world);
                    const HexCoord start = anyOf(random, cells);
                    const HexCoord goal = anyOf(random, cells);
                    std::vector<CellIndex> inOneGo;
                    JumpPointSearch whole(*world);
                    whole.setTrace(&inOneGo);
                    whole.begin(start, goal);
                    const SearchStatus status = whole.run();
                    EXPECT_EQ(inOneGo.size(), whole.counters().expanded);

                    JumpPointSearch pieces(*world);
                    pieces.begin(anyOf(random, cells), anyOf(random, cells));
                    pieces.run();
                    std::vector<CellIndex> inPieces;
                    pieces.setTrace(&inPieces);
                    pieces.begin(start, goal);
                    EXPECT_FALSE(pieces.hasPath());
                    EXPECT_TRUE(pieces.path().empty());
                    std::uint64_t polls = 0;
                    double bound = 0.0;
                    SearchStatus last = SearchStatus::Stopped;
                    while (last == SearchStatus::Stopped)
                    {
                        last = pieces.run([&] { return ++polls % 2 == 0; }, 3);
                        EXPECT_GE(pieces.lowerBound(), bound);
                        bound = pieces.lowerBound();
                        EXPECT_LE(bound, whole.cost());
                    }
                    EXPECT_EQ(last, status);
                    EXPECT_EQ(inPieces, inOneGo);
                    EXPECT_EQ(pieces.path(), whole.path());
                    EXPECT_GE(polls, inOneGo.size() / 3);
                    EXPECT_EQ(pieces.counters().generated, whole.counters().generated);
                    EXPECT_EQ(pieces.scannedWords(), whole.scannedWords());
                });
}

TEST(JumpPointSearch, FromACellToItself)
{
    const World world = occupancyWith(HexLattice(Point::Zero(), 1.0, 5, 5), {});
    JumpPointSearch search(*world);
    search.begin({1, 2}, {1, 2});
    EXPECT_EQ(search.lowerBound(), 0.0);
    EXPECT_EQ(search.run(), SearchStatus::Found);
    EXPECT_EQ(search.cost(), 0.0);
    EXPECT_EQ(search.path(), std::vector<CellIndex>{search.layout().index(HexCoord{1, 2})});
}

TEST(JumpPointSearch, SharesRays)
{
    Random random(6);
    const World world = amongIslands(random, 90, 80);
    const std::vector<HexCoord> cells = freeCells(*world);
    JumpPointSearch first(*world);
    JumpPointSearch second(*world, first.rays());
    EXPECT_EQ(second.rays(), first.rays());
    const HexCoord start = anyOf(random, cells);
    const LeastSteps least(*world, start);
    for (int query = 0; query < 10; ++query)
    {
        const HexCoord goal = anyOf(random, cells);
        expectShortest(first, *world, least, start, goal);
        expectShortest(second, *world, least, start, goal);
        EXPECT_EQ(first.path(), second.path());
    }
}

TEST(JumpPointSearch, RefusesALatticeTooLong)
{
    // one row of 2^27 + 1 columns
    const std::int64_t columns = (std::int64_t{1} << 27) + 1;
    const CellLayout layout(columns, 1);
    const Occupancy row(HexLattice(Point::Zero(), 1.0, columns, 1), layout,
                        std::vector<std::uint64_t>(layout.wordCount(), ~std::uint64_t{0}));
    EXPECT_THROW(JumpPointSearch{row}, std::length_error);
}
