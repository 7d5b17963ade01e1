#include <seahex/geometry/HexCoord.h>
#include <seahex/geometry/HexRing.h>

#include <map>
#include <queue>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;

namespace
{

/// All cells within `radius` steps of the origin.
std::vector<HexCoord> ball(std::int64_t radius)
{
    std::vector<HexCoord> cells;
    for (std::int64_t q = -radius; q <= radius; ++q)
        for (std::int64_t s = -radius; s <= radius; ++s)
            if (std::abs(q + s) <= radius)
                cells.push_back({q, s});
    return cells;
}

}  // namespace

TEST(HexCoord, offsetAndCubeAreInverse)
{
    for (std::int64_t row = -70; row <= 70; ++row)
        for (std::int64_t column = -70; column <= 70; ++column)
        {
            const OffsetCoord offset{column, row};
            const HexCoord cell = toCube(offset);
            ASSERT_EQ(toOffset(cell), offset) << column << ", " << row;
            ASSERT_EQ(toCube(toOffset(HexCoord{column, row})), (HexCoord{column, row}));
            ASSERT_EQ(cell.q + cell.r() + cell.s, 0);
        }
}

TEST(HexCoord, evenRowsAreShiftedEast)
{
    // From a cell of an even row the north-eastern and south-eastern neighbours are one column on; of an odd row, not.
    const HexCoord northEast{1, -1};
    const HexCoord southEast{0, 1};
    for (const std::int64_t row : {-4, -3, 0, 1, 2, 7})
    {
        const std::int64_t shift = row % 2 == 0 ? 1 : 0;
        EXPECT_EQ(toOffset(toCube({5, row}) + northEast), (OffsetCoord{5 + shift, row - 1}));
        EXPECT_EQ(toOffset(toCube({5, row}) + southEast), (OffsetCoord{5 + shift, row + 1}));
    }
}

TEST(HexCoord, publishedCells)
{
    // start and goal of [Cheng2020] section 3
    const HexCoord start = toCube({5, 114});
    const HexCoord goal = toCube({115, 103});
    EXPECT_EQ(start, (HexCoord{-52, 114}));
    EXPECT_EQ(start.r(), -62);
    EXPECT_EQ(goal, (HexCoord{63, 103}));
    EXPECT_EQ(goal.r(), -166);
    EXPECT_EQ(hexDistance(start, goal), 115);
}

TEST(HexCoord, distanceCountsSteps)
{
    const std::int64_t radius = 12;
    std::map<HexCoord, std::int64_t> steps{{HexCoord{}, 0}};
    std::queue<HexCoord> waiting({HexCoord{}});
    while (!waiting.empty())
    {
        const HexCoord cell = waiting.front();
        waiting.pop();
        if (steps[cell] == radius)
            continue;
        for (const RingOffset &neighbour : ringOffsets(1))
            if (steps.emplace(cell + neighbour.offset, steps[cell] + 1).second)
                waiting.push(cell + neighbour.offset);
    }
    EXPECT_EQ(steps.size(), ball(radius).size());
    const HexCoord elsewhere{-3, 8};
    for (const auto &[cell, count] : steps)
    {
        ASSERT_EQ(hexNorm(cell), count) << cell.q << ", " << cell.s;
        ASSERT_EQ(hexDistance(elsewhere, elsewhere + cell), count);
    }
}

TEST(HexCoord, distanceIsAMetric)
{
    const std::vector<HexCoord> cells = ball(4);
    for (const HexCoord u : cells)
        for (const HexCoord v : cells)
        {
            ASSERT_EQ(hexDistance(u, v) == 0, u == v);
            ASSERT_EQ(hexDistance(u, v), hexDistance(v, u));
            for (const HexCoord w : cells)
                ASSERT_LE(hexDistance(u, w), hexDistance(u, v) + hexDistance(v, w));
        }
}
