#include <seahex/geometry/CellLayout.h>
#include <seahex/geometry/HexRing.h>
#include <seahex/geometry/HexTraversal.h>

#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

using namespace seahex;

TEST(CellLayout, indexAndCellAreInverseFrameIncluded)
{
    for (const std::int64_t columns : {1, 5, 57, 58, 59, 64, 122, 130})
    {
        const CellLayout layout(columns, 4);
        std::set<CellIndex> indices;
        for (std::int64_t row = -CellLayout::frame; row < 4 + CellLayout::frame; ++row)
            for (std::int64_t column = -CellLayout::frame; column < columns + CellLayout::frame; ++column)
            {
                const OffsetCoord offset{column, row};
                const CellIndex index = layout.index(offset);
                ASSERT_LT(index, layout.size());
                ASSERT_TRUE(indices.insert(index).second) << column << ", " << row;
                ASSERT_EQ(layout.offset(index), offset);
                ASSERT_EQ(layout.index(toCube(offset)), index);
                ASSERT_EQ(layout.cell(index), toCube(offset));
            }
    }
}

TEST(CellLayout, rowsAreWholeWords)
{
    for (std::int64_t columns = 1; columns < 200; ++columns)
    {
        const CellLayout layout(columns, 3);
        EXPECT_EQ(layout.stride() % 64, 0);
        EXPECT_GE(layout.stride(), columns + 2 * CellLayout::frame + CellLayout::spare);
        EXPECT_LT(layout.stride(), columns + 2 * CellLayout::frame + CellLayout::spare + 64);
        EXPECT_EQ(layout.size(), 64 * layout.wordCount());
        EXPECT_EQ(layout.index(OffsetCoord{-CellLayout::frame, 0}) % 64, 0u) << "a row begins with a word";
    }
}

TEST(CellLayout, frameHoldsAllThatAJumpTouches)
{
    const CellLayout layout(5, 4);
    for (std::int64_t row = 0; row < 4; ++row)
        for (std::int64_t column = 0; column < 5; ++column)
            for (const RingOffset &jump : ringOffsets(3))
            {
                const HexCoord from = toCube({column, row});
                forEachTouchedCell(from, from + jump.offset,
                                   [&](HexCoord cell)
                                   {
                                       const OffsetCoord o = toOffset(cell);
                                       EXPECT_GE(o.column, -CellLayout::frame);
                                       EXPECT_LT(o.column, 5 + CellLayout::frame);
                                       EXPECT_GE(o.row, -CellLayout::frame);
                                       EXPECT_LT(o.row, 4 + CellLayout::frame);
                                       return true;
                                   });
            }
}

TEST(CellLayout, refusesWhatCannotBeNumbered)
{
    EXPECT_THROW(CellLayout(0, 5), std::length_error);
    EXPECT_THROW(CellLayout(5, 0), std::length_error);
    EXPECT_THROW(CellLayout(-7, 5), std::length_error);
    EXPECT_THROW(CellLayout(65536, 65536), std::length_error);
    EXPECT_THROW(CellLayout(std::int64_t{1} << 40, std::int64_t{1} << 40), std::length_error);
    // 10^9 cells fit; nothing is allocated by a layout
    EXPECT_NO_THROW(CellLayout(32000, 32000));
    const CellLayout largest(65536 - 14, 65535 - 6);
    EXPECT_EQ(largest.offset(largest.index(OffsetCoord{65521, 65528})), (OffsetCoord{65521, 65528}));
}
