// LengthSearch against Dijkstra's algorithm on an explicit graph, and its parts by themselves.

#include <seahex/geometry/HexNorm.h>
#include <seahex/search/LengthSearch.h>

#include "search/LengthWorlds.h"
#include "support/AsciiWorld.h"
#include "support/CellOracle.h"
#include "support/ExplicitGraph.h"
#include "support/HexOracle.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

/// The least lengths from one cell to all others, by Dijkstra's algorithm.
class LeastLengths
{
public:
    LeastLengths(const HexOccupancy &occupancy, int rings)
        : lattice_(occupancy.lattice()), graph_(jumpGraph(occupancy, rings, LengthMetric::Euclidean))
    {
    }

    double operator()(HexCoord from, HexCoord to) const
    {
        return graph_.cheapest({{vertexOf(lattice_, from), 0.0}}, {{vertexOf(lattice_, to), 0.0}});
    }

private:
    HexLattice lattice_;
    ExplicitGraph graph_;
};

/// Solves and compares with the oracle.
void expectShortest(LengthSearch &search, const HexOccupancy &occupancy, const LeastLengths &least, int rings,
                    HexCoord start, HexCoord goal)
{
    const double expected = least(start, goal);
    search.begin(start, goal);
    const SearchStatus status = search.run();
    ASSERT_EQ(status, expected < infinity ? SearchStatus::Found : SearchStatus::Exhausted);
    EXPECT_EQ(search.hasPath(), expected < infinity);
    if (expected == infinity)
        return;
    const double pitches = expected;
    EXPECT_NEAR(search.cost(), pitches, 1e-8 * (1.0 + pitches)) << toPicture(occupancy);
    EXPECT_NEAR(search.lowerBound(), pitches, 1e-8 * pitches);
    expectChain(search.path(), search.cost(), occupancy, rings, start, goal);
}

}  // namespace

TEST(LengthSearch, CostsWhatDijkstraFinds)
{
    forEachSeed(400,
                [](Random &random)
                {
                    const World world = randomWorld(random);
                    if (world->blockedCount() == world->lattice().cellCount())
                        return;
                    const int rings = static_cast<int>(random.integer(1, 3));
                    const LeastLengths least(*world, rings);
                    LengthSearch search(*world, rings);
                    for (int query = 0; query < 6; ++query)
                    {
                        const HexCoord start = freeCell(random, *world);
                        const HexCoord goal = freeCell(random, *world);
                        if (world->isFree(start) && world->isFree(goal))
                            expectShortest(search, *world, least, rings, start, goal);
                    }
                });
}

TEST(LengthSearch, CostsWhatDijkstraFindsAmongIslands)
{
    forEachSeed(12,
                [](Random &random)
                {
                    const World world = amongIslands(random, 70, 80);
                    for (const int rings : {1, 2, 3})
                    {
                        const LeastLengths least(*world, rings);
                        LengthSearch search(*world, rings);
                        for (int query = 0; query < 8; ++query)
                            expectShortest(search, *world, least, rings, freeCell(random, *world),
                                           freeCell(random, *world));
                    }
                });
}

TEST(LengthSearch, EveryPairOfASmallWorld)
{
    const AsciiWorld world(R"(
         . . # . . . .
        . # . . # # .
         . . # . . # .
        # . . # . . .
         . # . . # . #
        . . . # . . .
    )");
    for (const int rings : {1, 2, 3})
    {
        const LeastLengths least(world.occupancy(), rings);
        LengthSearch search(world.occupancy(), rings);
        forEachCell(world.lattice(), 0,
                    [&](HexCoord start)
                    {
                        forEachCell(world.lattice(), 0,
                                    [&](HexCoord goal)
                                    {
                                        if (world.occupancy().isFree(start) && world.occupancy().isFree(goal))
                                            expectShortest(search, world.occupancy(), least, rings, start, goal);
                                    });
                    });
    }
}

TEST(LengthSearch, IsTheSameHoweverOftenItIsInterrupted)
{
    forEachSeed(20,
                [](Random &random)
                {
                    const World world = amongIslands(random, 60, 50);
                    const int rings = static_cast<int>(random.integer(1, 3));
                    const HexCoord start = freeCell(random, *world);
                    const HexCoord goal = freeCell(random, *world);
                    std::vector<CellIndex> inOneGo;
                    LengthSearch whole(*world, rings);
                    whole.setTrace(&inOneGo);
                    whole.begin(start, goal);
                    const SearchStatus status = whole.run();

                    std::vector<CellIndex> inPieces;
                    LengthSearch pieces(*world, rings);
                    pieces.setTrace(&inPieces);
                    pieces.begin(start, goal);
                    std::uint64_t polls = 0;
                    double bound = 0.0;
                    SearchStatus last = SearchStatus::Stopped;
                    while (last == SearchStatus::Stopped)
                    {
                        last = pieces.run([&] { return ++polls % 2 == 0; }, 3);
                        EXPECT_GE(pieces.lowerBound(), bound * (1.0 - 1e-12));
                        bound = pieces.lowerBound();
                        EXPECT_LE(bound, whole.cost());
                    }
                    EXPECT_EQ(last, status);
                    EXPECT_EQ(inPieces, inOneGo);
                    EXPECT_EQ(pieces.path(), whole.path());
                    EXPECT_EQ(inOneGo.size(), whole.counters().expanded);
                    EXPECT_GT(polls, inOneGo.size() / 3);
                });
}

TEST(LengthSearch, TellsWhatItReached)
{
    Random random(5);
    const World world = amongIslands(random, 60, 50);
    LengthSearch search(*world, 3);
    search.begin(freeCell(random, *world), freeCell(random, *world));
    ASSERT_EQ(search.run(), SearchStatus::Found);
    std::uint64_t reached = 0;
    search.forEachReached(
        [&](CellIndex cell, std::uint8_t arrivedBy, bool)
        {
            ++reached;
            EXPECT_TRUE(search.isReached(cell));
            EXPECT_TRUE(world->isFree(search.layout().cell(cell)));
            const std::vector<CellIndex> path = search.pathTo(cell);
            EXPECT_EQ(path.back(), cell);
            EXPECT_EQ(path.size() == 1, arrivedBy == LengthSearch::noJump);
        });
    EXPECT_EQ(reached, search.counters().generated);
}

TEST(LengthSearch, UsesOtherRingsWhenTold)
{
    Random random(9);
    const World world = amongIslands(random, 60, 50);
    const HexCoord start = freeCell(random, *world);
    const HexCoord goal = freeCell(random, *world);
    LengthSearch search(*world, 1);
    for (const int rings : {1, 3, 2, 1, 2, 3})
    {
        search.useRings(rings);
        expectShortest(search, *world, LeastLengths(*world, rings), rings, start, goal);
    }
}

TEST(HexWindow, HoldsTheBitsAroundACell)
{
    Random random(3);
    // rows that end anywhere in a word, and just before and after its end
    for (const std::int64_t columns : {1, 2, 49, 50, 51, 56, 57, 58, 59, 63, 64, 65, 114, 122, 128})
    {
        const HexLattice lattice(Point::Zero(), 1.0, columns, 5);
        const World world = randomOccupancy(random, lattice, 0.5);
        const HexWindow window(world->layout(), world->words().data());
        forEachCell(lattice, 0,
                    [&](HexCoord cell)
                    {
                        const OffsetCoord middle = toOffset(cell);
                        std::uint64_t expected = 0;
                        for (std::int64_t row = -3; row <= 3; ++row)
                            for (std::int64_t column = -3; column <= 3; ++column)
                                if (world->isBlocked(toCube({middle.column + column, middle.row + row})))
                                    expected |= HexWindow::bit({column, row});
                        EXPECT_EQ(window.around(world->layout().index(cell)), expected);
                    });
    }
}

TEST(UnitLengths, AreRingNormsInSmallUnits)
{
    for (const int rings : {1, 2, 3})
    {
        const units::RingNorm norm(rings);
        for (std::int32_t q = -40; q <= 40; ++q)
            for (std::int32_t s = -40; s <= 40; ++s)
            {
                const double expected = ringNorm({q, s}, rings) * static_cast<double>(units::pitch);
                EXPECT_NEAR(static_cast<double>(norm(q, s)), expected, units::error * expected);
            }
    }
}

TEST(NormCones, AddWhatTheNormSays)
{
    Random random(1);
    const HexJumps jumps(CellLayout(10, 10), 3, JumpSet::Primitive);
    for (const int rings : {1, 2, 3})
    {
        std::vector<HexCoord> offsets;
        for (std::size_t k = 0; k < jumps.countWithin(rings); ++k)
            offsets.push_back(jumps.offset(k).offset);
        const units::RingNorm norm(rings);
        const NormCones cones(rings, offsets);
        int held = 0;
        for (int i = 0; i < 5000; ++i)
        {
            const std::int64_t reach = random.chance(0.5) ? 40 : 50000;
            const auto q = static_cast<std::int32_t>(random.integer(-reach, reach));
            const auto s = static_cast<std::int32_t>(random.integer(-reach, reach));
            const NormCones::Cone *cone = cones.find(q, s);
            if (cone == nullptr)
                continue;
            ++held;
            for (std::size_t k = 0; k < offsets.size(); ++k)
            {
                const auto dq = static_cast<std::int32_t>(offsets[k].q);
                const auto ds = static_cast<std::int32_t>(offsets[k].s);
                EXPECT_EQ(cone->added[k], norm(dq, ds) + norm(q - dq, s - ds) - norm(q, s));
            }
        }
        EXPECT_GT(held, 2000);
    }
}

TEST(BucketQueue, GivesTheLeastBucketFirstAndTheLastOfItFirst)
{
    constexpr std::uint32_t width = 1U << BucketQueue::shift;
    forEachSeed(20,
                [](Random &random)
                {
                    BucketQueue queue;
                    const auto begin = static_cast<std::uint32_t>(random.integer(0, 1LL << 32) - 1);
                    queue.beginAt(begin);
                    std::vector<std::vector<CellIndex>> model(1);  // by bucket, from the current one on
                    CellIndex next = 0;
                    std::uint32_t passed = 0;
                    for (int step = 0; step < 5000; ++step)
                    {
                        if (queue.empty() || random.chance(0.55))
                        {
                            const auto ahead = static_cast<std::uint32_t>(random.integer(0, BucketQueue::buckets - 1));
                            model.resize(std::max<std::size_t>(model.size(), ahead + 1));
                            model[ahead].push_back(next);
                            queue.push((begin / width + passed + ahead) * width, next++);
                            continue;
                        }
                        if (queue.isCurrentEmpty())
                        {
                            const std::uint32_t steps = queue.advance();
                            passed += steps;
                            for (std::uint32_t i = 0; i < steps; ++i)
                                EXPECT_TRUE(model[i].empty());
                            model.erase(model.begin(), model.begin() + steps);
                        }
                        ASSERT_FALSE(model.front().empty());
                        EXPECT_EQ(queue.pop(), model.front().back());
                        model.front().pop_back();
                    }
                    queue.clear();
                    EXPECT_TRUE(queue.empty());
                });
}

TEST(LabelStore, ForgetsWhatWasTouched)
{
    LabelStore store(64 * 20);
    Random random(2);
    for (int round = 0; round < 3; ++round)
    {
        std::vector<CellIndex> cells;
        for (int i = 0; i < 100; ++i)
            cells.push_back(static_cast<CellIndex>(random.integer(0, 64 * 20 - 1)));
        for (const CellIndex cell : cells)
        {
            store.markReached(cell);
            store.setLabel(cell, cell * 7);
            if (cell % 2 == 0)
                store.markExpanded(cell);
        }
        for (CellIndex cell = 0; cell < store.size(); ++cell)
        {
            const bool isReached = std::find(cells.begin(), cells.end(), cell) != cells.end();
            EXPECT_EQ(store.isReached(cell), isReached);
            EXPECT_EQ(store.isExpanded(cell), isReached && cell % 2 == 0);
            EXPECT_TRUE(!isReached || store.label(cell) == cell * 7);
        }
        store.clear();
        for (CellIndex cell = 0; cell < store.size(); ++cell)
            EXPECT_FALSE(store.isReached(cell) || store.isExpanded(cell));
        EXPECT_TRUE(store.touchedWords().empty());
    }
}

TEST(LabelStore, ForgetsSingleCellsAndListsAWordOnce)
{
    LabelStoreOf<std::uint64_t> store(64 * 20);
    for (int round = 0; round < 3; ++round)
    {
        store.markReached(130);
        store.setLabel(130, std::uint64_t{1} << 40);
        store.markReached(131);
        store.markExpanded(131);
        EXPECT_EQ(store.openWord(2), std::uint64_t{1} << 2);
        EXPECT_EQ(store.label(130), std::uint64_t{1} << 40);
        store.forget(131);
        EXPECT_TRUE(store.isReached(130));
        EXPECT_FALSE(store.isReached(131) || store.isExpanded(131));
        store.forget(130);
        EXPECT_EQ(store.reachedWord(2), 0U);
    }
    EXPECT_EQ(store.touchedWords(), std::vector<std::uint32_t>{2});
    store.clear();
    store.markReached(130);
    EXPECT_EQ(store.touchedWords(), std::vector<std::uint32_t>{2});
}
