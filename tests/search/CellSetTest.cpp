#include <seahex/search/CellSet.h>

#include "support/Random.h"

#include <set>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

std::set<CellIndex> cellsOf(const CellSet &set)
{
    std::set<CellIndex> cells;
    set.forEach([&cells](CellIndex cell) { EXPECT_TRUE(cells.insert(cell).second); });
    return cells;
}

}  // namespace

TEST(CellSet, HoldsACellOnceUntilItIsCleared)
{
    CellSet set(CellLayout(100, 20));
    Random random(1);
    for (int round = 0; round < 3; ++round)
    {
        std::set<CellIndex> expected;
        for (int i = 0; i < 300; ++i)
        {
            const auto cell = static_cast<CellIndex>(random.integer(0, 128 * 26 - 1));
            set.add(cell);
            expected.insert(cell);
        }
        EXPECT_EQ(cellsOf(set), expected);
        set.clear();
        EXPECT_TRUE(set.empty());
        EXPECT_TRUE(cellsOf(set).empty());
    }
}

TEST(CellSet, AddsAllCellsInWhoseWindowsTheyLie)
{
    forEachSeed(
        60,
        [](Random &random)
        {
            const CellLayout layout(random.integer(1, 200), random.integer(1, 12));
            CellSet set(layout);
            std::set<CellIndex> expected;
            for (int i = 0; i < 4; ++i)
            {
                const OffsetCoord middle{random.integer(0, layout.columns() - 1), random.integer(0, layout.rows() - 1)};
                const CellIndex cell = layout.index(middle);
                set.addAround(cell >> 6, std::uint64_t{1} << (cell & 63));
                for (std::int64_t row = -3; row <= 3; ++row)
                    for (std::int64_t column = -3; column <= 3; ++column)
                        expected.insert(layout.index(OffsetCoord{middle.column + column, middle.row + row}));
            }
            EXPECT_EQ(cellsOf(set), expected);
        });
}
