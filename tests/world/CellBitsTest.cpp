#include <seahex/world/CellBits.h>

#include "support/Random.h"

#include <set>
#include <utility>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

bool bit(const CellBits &bits, std::size_t index)
{
    return ((bits.words()[index >> 6] >> (index & 63)) & 1) != 0;
}

}  // namespace

TEST(CellBits, spansAreCutToTheRectangle)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const CellLayout layout(random.integer(1, 200), random.integer(1, 5));
        CellBits bits(layout);
        std::set<std::pair<std::int64_t, std::int64_t>> expected;
        for (int i = 0; i < 4; ++i)
        {
            const std::int64_t row = random.integer(-2, layout.rows() + 1);
            const std::int64_t first = random.integer(-10, layout.columns() + 10);
            const std::int64_t last = first + random.integer(-2, random.chance(0.3) ? 300 : 20);
            bits.setSpan(row, first, last);
            for (std::int64_t column = first; column <= last; ++column)
                if (row >= 0 && row < layout.rows() && column >= 0 && column < layout.columns())
                    expected.emplace(row, column);
        }
        for (std::size_t index = 0; index < layout.size(); ++index)
        {
            const OffsetCoord cell = layout.offset(static_cast<CellIndex>(index));
            ASSERT_EQ(bit(bits, index), expected.count({cell.row, cell.column}) == 1)
                << cell.column << ", " << cell.row;
        }
    }
}

TEST(CellBits, spansOfAnyIntegersAreCut)
{
    const CellLayout layout(100, 3);
    CellBits bits(layout);
    const std::int64_t far = std::int64_t{1} << 62;
    bits.setSpan(far, 0, 5);
    bits.setSpan(-far, 0, 5);
    bits.setSpan(1, far, far);
    bits.setSpan(1, -far, -far);
    EXPECT_EQ(bits.words(), CellBits(layout).words());
    bits.setSpan(1, -far, far);
    CellBits row(layout);
    row.setSpan(1, 0, 99);
    EXPECT_EQ(bits.words(), row.words());
}

TEST(CellBits, outsideIsAllButTheRectangle)
{
    for (const std::int64_t columns : {1, 57, 58, 59, 61, 64, 122, 128, 200})
    {
        const CellLayout layout(columns, 3);
        CellBits bits(layout);
        bits.setOutside();
        for (std::size_t index = 0; index < layout.size(); ++index)
        {
            const OffsetCoord cell = layout.offset(static_cast<CellIndex>(index));
            const bool inside = cell.column >= 0 && cell.column < columns && cell.row >= 0 && cell.row < 3;
            ASSERT_EQ(bit(bits, index), !inside) << cell.column << ", " << cell.row << " of " << columns;
        }
    }
}
