#include <seahex/geometry/HexTraversal.h>
#include <seahex/geometry/SquareTraversal.h>

#include "support/LatticeKinds.h"
#include "support/Random.h"
#include "support/TouchedCells.h"

#include <algorithm>
#include <set>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

// from centre to centre, in integers

template <class LatticeType>
class CellTraversalOf : public testing::Test
{
};
TYPED_TEST_SUITE(CellTraversalOf, LatticeKinds, LatticeKindNames);

using Wide = boost::multiprecision::checked_int256_t;

/// A pair of cells far apart; many level or nearly so, many that see each other through corners or along edges.
void farPair(Random &random, std::int64_t reach, int kind, HexCoord &a, HexCoord &b)
{
    a = {random.integer(-reach, reach), random.integer(-reach, reach)};
    b = {random.integer(-reach, reach), random.integer(-reach, reach)};
    if (kind == 0)
        b.s = a.s + random.integer(-2, 2);
    if (kind == 1)
        b = a + random.integer(-reach / 8, reach / 8) * HexCoord{1, 1};  // through corners all the way
    if (kind == 2)
        b = a + random.integer(-reach / 8, reach / 8) * HexCoord{-1, 2};  // along edges all the way
    b.q = std::clamp(b.q, -reach, reach);
    b.s = std::clamp(b.s, -reach, reach);
}

void farPair(Random &random, std::int64_t reach, int kind, OffsetCoord &a, OffsetCoord &b)
{
    a = {random.integer(-reach, reach), random.integer(-reach, reach)};
    b = {random.integer(-reach, reach), random.integer(-reach, reach)};
    const std::int64_t far = random.integer(-reach / 8, reach / 8);
    if (kind == 0)
        b.row = a.row + random.integer(-2, 2);
    if (kind == 1)
        b = {a.column + far, a.row + far};  // through corners all the way
    if (kind == 2)
        b = {a.column - 3 * far, a.row + far};  // through corners, and whole cells between them
    b.column = std::clamp(b.column, -reach, reach);
    b.row = std::clamp(b.row, -reach, reach);
}

}  // namespace

TYPED_TEST(CellTraversalOf, isExactWithinEightRowsAndColumns)
{
    using Cell = typename TypeParam::Cell;
    // from one cell of an even and one of an odd row to all cells that near: by symmetry all such pairs
    for (const OffsetCoord from : {OffsetCoord{0, 0}, {-4, 1}, {5, -3}})
        for (std::int64_t columns = -8; columns <= 8; ++columns)
            for (std::int64_t rows = -8; rows <= 8; ++rows)
            {
                const Cell a = TypeParam::cell(from);
                const Cell b = TypeParam::cell({from.column + columns, from.row + rows});
                std::vector<Cell> expected;
                for (std::int64_t row = from.row - 10; row <= from.row + 10; ++row)
                    for (std::int64_t column = from.column - 10; column <= from.column + 10; ++column)
                        if (touchesExactly<std::int64_t>(a, b, TypeParam::cell({column, row})))
                            expected.push_back(TypeParam::cell({column, row}));
                // row by row, each cell once
                ASSERT_EQ(touchedCells(a, b), expected) << columns << " columns, " << rows << " rows";
                ASSERT_EQ(touchedCells(b, a), expected) << "backwards";
            }
}

TYPED_TEST(CellTraversalOf, isExactHoweverFar)
{
    using Cell = typename TypeParam::Cell;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        // 10^9 cells, and as far as the header promises
        const std::int64_t reach = seed % 3 == 0 ? std::int64_t{1} << 60 : 1000000000;
        Cell a;
        Cell b;
        farPair(random, reach, static_cast<int>(seed % 5), a, b);
        const std::int64_t north = std::min(toOffset(a).row, toOffset(b).row);
        const std::int64_t south = std::max(toOffset(a).row, toOffset(b).row);
        for (int i = 0; i < 12; ++i)
        {
            const std::int64_t row = i == 0 ? north : i == 1 ? south : random.integer(north, south);
            const RowSpan span = touchedSpan(a, b, row);
            ASSERT_EQ(span.row, row);
            ASSERT_LE(span.firstColumn, span.lastColumn);
            for (const std::int64_t end : {span.firstColumn, span.lastColumn})
                ASSERT_TRUE(touchesExactly<Wide>(a, b, TypeParam::cell({end, row})));
            ASSERT_FALSE(touchesExactly<Wide>(a, b, TypeParam::cell({span.firstColumn - 1, row})));
            ASSERT_FALSE(touchesExactly<Wide>(a, b, TypeParam::cell({span.lastColumn + 1, row})));
            const RowSpan back = touchedSpan(b, a, row);
            ASSERT_EQ(back.firstColumn, span.firstColumn);
            ASSERT_EQ(back.lastColumn, span.lastColumn);
        }
    }
}

TYPED_TEST(CellTraversalOf, stopsWhenTheVisitorSaysSo)
{
    using Cell = typename TypeParam::Cell;
    int visited = 0;
    EXPECT_FALSE(forEachTouchedCell(Cell{0, 0}, Cell{9, 4}, [&visited](Cell) { return ++visited < 3; }));
    EXPECT_EQ(visited, 3);
    EXPECT_TRUE(forEachTouchedCell(Cell{0, 0}, Cell{9, 4}, [](Cell) { return true; }));
}
