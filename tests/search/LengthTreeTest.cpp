// LengthTree and its repairs against a new LengthSearch, and against Dijkstra's algorithm, after every change.

#include <seahex/search/LengthTree.h>

#include "search/ChangingWorld.h"
#include "support/ExplicitGraph.h"

#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// Grows the tree to a cell and compares with a search of its own.
void expectGrown(LengthTree &tree, const HexOccupancy &occupancy, int rings, HexCoord target)
{
    const double expected = leastLength(occupancy, rings, *tree.root(), target);
    ASSERT_EQ(tree.growTo(target), expected < infinity ? SearchStatus::Found : SearchStatus::Exhausted);
    expectLength(tree.length(target), expected);
    if (expected < infinity)
        expectChain(tree.path(target), tree.length(target), occupancy, rings, *tree.root(), target);
    else
        EXPECT_TRUE(tree.path(target).empty());
}

}  // namespace

TEST(LengthTree, KnowsTheWayToOneTargetAfterTheOther)
{
    forEachSeed(150,
                [](Random &random)
                {
                    const World world = anyWorld(random);
                    const int rings = static_cast<int>(random.integer(1, 3));
                    LengthTree tree(world, rings);
                    for (int root = 0; root < 3; ++root)
                    {
                        tree.plant(freeCell(random, *world));
                        for (int target = 0; target < 12; ++target)
                            expectGrown(tree, *world, rings, random.cellOf(world->lattice()));
                    }
                });
}

TEST(LengthTree, ExpandsNoCellForTwoTargets)
{
    Random random(4);
    const World world = amongIslands(random, 120, 90);
    LengthTree tree(world, 3);
    tree.plant(freeCell(random, *world));
    for (int target = 0; target < 400; ++target)
        tree.growTo(freeCell(random, *world));
    // but for those whose label got better, which lie in one bucket
    EXPECT_LE(tree.counters().expanded, tree.counters().generated + tree.counters().reopened);
    EXPECT_LE(tree.counters().reopened, tree.counters().generated / 10);
}

TEST(LengthTree, HoldsTheLeastLengthsAfterEveryChangeOfCells)
{
    forEachSeed(2500,
                [](Random &random)
                {
                    ChangingWorld world(*anyWorld(random));
                    const int rings = static_cast<int>(random.integer(1, 3));
                    LengthTree tree(world.occupancy(), rings);
                    tree.plant(freeCell(random, *world.occupancy()));
                    for (int change = 0; change < 12 && !::testing::Test::HasFailure(); ++change)
                    {
                        for (int target = 0; target < random.integer(0, 3); ++target)
                            expectGrown(tree, *world.occupancy(), rings, random.cellOf(world.occupancy()->lattice()));
                        world.change(random);
                        tree.setOccupancy(world.occupancy());
                    }
                });
}

TEST(LengthTree, HoldsWhatDijkstraFindsForAllCellsAfterEveryChange)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const HexLattice lattice(Point::Zero(), 1.0, random.integer(5, 20), random.integer(5, 16));
                    ChangingWorld world(*randomOccupancy(random, lattice, random.real(0.0, 0.4)));
                    const int rings = static_cast<int>(random.integer(1, 3));
                    const HexCoord root = freeCell(random, *world.occupancy());
                    LengthTree tree(world.occupancy(), rings);
                    tree.plant(root);
                    for (int change = 0; change < 6; ++change)
                    {
                        const std::vector<double> least = jumpGraph(*world.occupancy(), rings, LengthMetric::Euclidean)
                                                              .costsFrom({{vertexOf(lattice, root), 0.0}});
                        forEachCell(lattice, 0,
                                    [&](HexCoord cell)
                                    {
                                        if (random.chance(0.3) || world.occupancy()->isBlocked(root) ||
                                            world.occupancy()->isBlocked(cell))
                                            return;
                                        tree.growTo(cell);
                                        expectLength(tree.length(cell), least[vertexOf(lattice, cell)]);
                                    });
                        world.change(random);
                        tree.setOccupancy(world.occupancy());
                    }
                });
}

TEST(LengthTree, IsTheSameHoweverOftenItIsInterrupted)
{
    forEachSeed(300,
                [](Random &random)
                {
                    ChangingWorld world(*anyWorld(random));
                    LengthTree tree(world.occupancy(), 3);
                    tree.plant(freeCell(random, *world.occupancy()));
                    for (int question = 0; question < 10; ++question)
                    {
                        // given up halfway, now and then
                        int polls = 0;
                        tree.growTo(
                            freeCell(random, *world.occupancy()), [&] { return ++polls > 20; }, 5);
                        if (random.chance(0.5))
                        {
                            world.change(random);
                            tree.setOccupancy(world.occupancy());
                        }
                        const HexCoord target = freeCell(random, *world.occupancy());
                        SearchStatus status = SearchStatus::Stopped;
                        while (status == SearchStatus::Stopped)
                        {
                            polls = 0;
                            status = tree.growTo(
                                target, [&] { return ++polls > 1; }, 1);
                        }
                        expectGrown(tree, *world.occupancy(), 3, target);
                    }
                });
}

TEST(LengthTree, WaitsForABlockedRootToBeFreed)
{
    const AsciiWorld open(R"(
         A . . . .
        . . . . .
         . . . . B
    )");
    const AsciiWorld blocked(R"(
         # . . . .
        . . . . .
         . . . . .
    )");
    LengthTree tree(blocked.shared(), 2);
    tree.plant(open.cell('A'));
    EXPECT_EQ(tree.growTo(open.cell('B')), SearchStatus::Exhausted);
    EXPECT_EQ(tree.length(open.cell('A')), infinity);
    tree.setOccupancy(open.shared());
    expectGrown(tree, open.occupancy(), 2, open.cell('B'));
    tree.setOccupancy(blocked.shared());
    EXPECT_EQ(tree.growTo(open.cell('B')), SearchStatus::Exhausted);
    EXPECT_EQ(tree.growTo({100, 100}), SearchStatus::Exhausted);
}

TEST(LengthTree, RefusesAnotherLattice)
{
    const AsciiWorld small(". .");
    const AsciiWorld large(". . .");
    LengthTree tree(small.shared(), 1);
    EXPECT_THROW(tree.setOccupancy(large.shared()), std::length_error);
}

TEST(LengthTree, IsLeftAloneByWhatHappensElsewhere)
{
    Random random(8);
    const HexLattice lattice(Point::Zero(), 1.0, 400, 120);
    const World open = occupancyWith(lattice, {});
    const World islet = occupancyWith(lattice, {toCube({380, 60})});
    LengthTree tree(open, 3);
    tree.plant(toCube({10, 60}));
    ASSERT_EQ(tree.growTo(toCube({200, 60})), SearchStatus::Found);
    const std::uint64_t expanded = tree.counters().expanded;
    tree.setOccupancy(islet);
    ASSERT_EQ(tree.growTo(toCube({200, 60})), SearchStatus::Found);
    tree.setOccupancy(open);
    ASSERT_EQ(tree.growTo(toCube({150, 60})), SearchStatus::Found);
    EXPECT_EQ(tree.counters().expanded, expanded);
    EXPECT_EQ(tree.cutOff(), 0U);
}
