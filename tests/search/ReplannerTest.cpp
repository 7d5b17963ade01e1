// Replanner against a new LengthSearch after every change of start, goal and cells.

#include <seahex/search/Replanner.h>

#include "search/ChangingWorld.h"

#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// Vessel, goal and hazards of a voyage of `steps` changes.
void expectEveryPlanOfAVoyage(Random &random, int steps)
{
    ChangingWorld world(*anyWorld(random));
    const int rings = static_cast<int>(random.integer(1, 3));
    Replanner replanner(world.occupancy(), rings);
    HexCoord start = freeCell(random, *world.occupancy());
    HexCoord goal = freeCell(random, *world.occupancy());
    for (int step = 0; step < steps; ++step)
    {
        const SearchStatus status = replanner.plan(start, goal);
        const double expected = leastLength(*world.occupancy(), rings, start, goal);
        ASSERT_EQ(status, expected < infinity ? SearchStatus::Found : SearchStatus::Exhausted);
        expectLength(replanner.length(), expected);
        const std::vector<CellIndex> path = replanner.path();
        if (expected < infinity)
            expectChain(path, replanner.length(), *world.occupancy(), rings, start, goal);
        else
            EXPECT_TRUE(path.empty());
        if (::testing::Test::HasFailure())
            return;

        if (random.chance(0.1))
            replanner.prepareForGoals();
        switch (random.integer(0, 5))
        {
            case 0:  // on along the route
                if (!path.empty())
                    start = world.occupancy()->layout().cell(path[path.size() / 4]);
                break;
            case 1:
                start = freeCell(random, *world.occupancy());
                break;
            case 2:
                goal = freeCell(random, *world.occupancy());
                break;
            default:
                world.change(random);
                replanner.setOccupancy(world.occupancy());
        }
    }
}

/// A function to stop a search that must not run at all.
bool neverAsked()
{
    ADD_FAILURE() << "the search ran";
    return true;
}

}  // namespace

TEST(Replanner, FindsWhatANewSearchFindsAfterEveryChange)
{
    forEachSeed(2500, [](Random &random) { expectEveryPlanOfAVoyage(random, 16); });
}

TEST(Replanner, ExpandsNothingForAVesselThatKeepsToItsRoute)
{
    Random random(2);
    const World world = amongIslands(random, 120, 90);
    Replanner replanner(world, 3);
    // a voyage of its own, and another one, of other ends
    for (int voyage = 0; voyage < 3; ++voyage)
    {
        const HexCoord goal = freeCell(random, *world);
        ASSERT_EQ(replanner.plan(freeCell(random, *world), goal), SearchStatus::Found);
        const std::vector<CellIndex> route = replanner.path();
        ASSERT_GT(route.size(), 8U);
        for (auto at = route.begin(); at != route.end(); ++at)
        {
            EXPECT_EQ(replanner.plan(world->layout().cell(*at), goal, neverAsked), SearchStatus::Found);
            EXPECT_EQ(replanner.path(), std::vector<CellIndex>(at, route.end()));
        }
    }
}

TEST(Replanner, ExpandsNothingForAGoalOnTheRouteOncePrepared)
{
    Random random(2);
    const World world = amongIslands(random, 120, 90);
    Replanner replanner(world, 3);
    EXPECT_EQ(replanner.prepareForGoals(), SearchStatus::Exhausted);
    const HexCoord start = freeCell(random, *world);
    ASSERT_EQ(replanner.plan(start, freeCell(random, *world)), SearchStatus::Found);
    const double length = replanner.length();
    ASSERT_EQ(replanner.prepareForGoals(), SearchStatus::Found);
    EXPECT_EQ(replanner.length(), length);
    // of the paths of equal length, that of the tree from the start
    ASSERT_EQ(replanner.plan(start, world->layout().cell(replanner.path().back()), neverAsked), SearchStatus::Found);
    for (int i = 0; i < 3; ++i)
    {
        ASSERT_EQ(replanner.plan(start, freeCell(random, *world)), SearchStatus::Found);
        for (const CellIndex cell : replanner.path())
            EXPECT_EQ(replanner.plan(start, world->layout().cell(cell), neverAsked), SearchStatus::Found);
    }
}
