#include <seahex/search/CoarseSearch.h>
#include <seahex/world/SegmentValidity.h>

#include "support/AsciiWorld.h"
#include "support/CellOracle.h"
#include "support/Random.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// Is every straight line of the path free, and does it join these cells?
void expectValid(const HexOccupancy &fine, const std::vector<HexCoord> &path, HexCoord start, HexCoord goal)
{
    ASSERT_FALSE(path.empty());
    EXPECT_EQ(path.front(), start);
    EXPECT_EQ(path.back(), goal);
    for (std::size_t i = 1; i < path.size(); ++i)
    {
        EXPECT_NE(path[i - 1], path[i]);
        EXPECT_TRUE(isFree(fine, fine.lattice().centre(path[i - 1]), fine.lattice().centre(path[i])));
    }
}

}  // namespace

TEST(CoarseSearch, findsValidPathsOnly)
{
    int found = 0;
    int asked = 0;
    forEachSeed(60,
                [&](Random &random)
                {
                    const HexLattice lattice(Point(3.0, -2.0), 0.5, random.integer(20, 160), random.integer(20, 120));
                    const auto fine = randomOccupancy(random, lattice, random.real(0.0, 0.05));
                    const CoarseOccupancy coarse(*fine, random.integer(2, 5));
                    CoarseSearch search(*fine, coarse);
                    LengthSearch whole(*fine, 1);
                    for (int query = 0; query < 10; ++query)
                    {
                        const HexCoord start = random.cellOf(lattice);
                        const HexCoord goal = random.cellOf(lattice);
                        if (fine->isBlocked(start) || fine->isBlocked(goal))
                            continue;
                        ++asked;
                        const std::vector<HexCoord> path = search.path(start, goal);
                        if (path.empty())
                            continue;
                        ++found;
                        expectValid(*fine, path, start, goal);
                        whole.begin(start, goal);
                        EXPECT_EQ(whole.run(), SearchStatus::Found);
                    }
                });
    EXPECT_GT(asked, 400);
    EXPECT_GT(found, asked / 4);
}

TEST(CoarseSearch, joinsEndsInNarrowWater)
{
    // open water in the middle, and inlets one cell wide in which no large cell is free
    const HexLattice lattice(Point::Zero(), 1.0, 80, 60);
    std::vector<HexCoord> land;
    forEachCell(lattice, 0,
                [&](HexCoord cell)
                {
                    const OffsetCoord at = toOffset(cell);
                    const bool isInlet = at.row == 30 && at.column > 1 && at.column < 78;
                    if ((at.column < 25 || at.column > 55) && !isInlet)
                        land.push_back(cell);
                });
    const auto fine = occupancyWith(lattice, land);
    const CoarseOccupancy coarse(*fine, 4);
    CoarseSearch search(*fine, coarse);
    const HexCoord west = toCube({2, 30});
    const HexCoord east = toCube({77, 30});
    expectValid(*fine, search.path(west, east), west, east);
    EXPECT_TRUE(coarse.cells().isBlocked(coarse.holding(west)));

    // an end in a pond too small for any large cell has no way out
    const HexCoord pond = toCube({5, 5});
    land.erase(std::remove(land.begin(), land.end(), pond), land.end());
    const auto ponds = occupancyWith(lattice, land);
    const CoarseOccupancy coarsePonds(*ponds, 4);
    EXPECT_TRUE(CoarseSearch(*ponds, coarsePonds).path(pond, east).empty());
}
