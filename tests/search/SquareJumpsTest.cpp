#include <seahex/search/SquareJumps.h>

#include "support/SquareOracle.h"

#include <cmath>
#include <set>
#include <stdexcept>
#include <tuple>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// The cells that a step needs, by the exact rule of what it touches.
std::set<OffsetCoord> neededBy(OffsetCoord from, OffsetCoord to, JumpRule rule)
{
    if (rule == JumpRule::Hopping)
        return {to};
    std::set<OffsetCoord> cells;
    for (std::int64_t row = from.row - 3; row <= from.row + 3; ++row)
        for (std::int64_t column = from.column - 3; column <= from.column + 3; ++column)
            if (OffsetCoord{column, row} != from && touchesExactly<std::int64_t>(from, to, OffsetCoord{column, row}))
                cells.insert({column, row});
    return cells;
}

class SquareJumpsOfAllKinds : public ::testing::TestWithParam<std::tuple<int, JumpRule>>
{
protected:
    const int neighbours = std::get<0>(GetParam());
    const JumpRule rule = std::get<1>(GetParam());
};

}  // namespace

TEST_P(SquareJumpsOfAllKinds, areTheNeighbours)
{
    const SquareJumps jumps(CellLayout(9, 8), neighbours, rule);
    ASSERT_EQ(jumps.size(), static_cast<std::size_t>(neighbours));
    EXPECT_EQ(jumps.rings(), 1);
    EXPECT_EQ(jumps.countWithin(0), 0u);
    for (const int rings : {1, 2, 3})
        EXPECT_EQ(jumps.countWithin(rings), jumps.size());
    for (std::size_t k = 0; k < jumps.size(); ++k)
    {
        const bool isDiagonal = k >= 4;
        const double course = (static_cast<double>(k % 4) + (isDiagonal ? 0.5 : 0.0)) * 0.5 * M_PI;
        const double length = isDiagonal ? std::sqrt(2.0) : 1.0;
        EXPECT_NEAR((jumps.vector(k) - length * Point(std::cos(course), std::sin(course))).norm(), 0.0, 1e-12) << k;
        EXPECT_NEAR(jumps.length(k), length, 1e-12);
        EXPECT_EQ(jumps.steps(k), jumps.length(k)) << "octile";
        EXPECT_EQ(jumps.vector(jumps.opposite(k)), Point(-jumps.vector(k)));
    }
}

TEST_P(SquareJumpsOfAllKinds, tablesEqualBruteForceFromEveryCell)
{
    // wide enough that rows are of more than one word
    for (const std::int64_t columns : {1, 9, 64, 70})
    {
        const CellLayout layout(columns, 7);
        const SquareJumps jumps(layout, neighbours, rule);
        for (std::int64_t row = 0; row < 7; ++row)
            for (std::int64_t column = 0; column < columns; ++column)
            {
                const OffsetCoord from{column, row};
                const CellIndex index = layout.index(from);
                const std::vector<Jump> &table = jumps.from(jumps.parity(index));
                ASSERT_EQ(table.size(), jumps.size());
                for (std::size_t k = 0; k < jumps.size(); ++k)
                {
                    const OffsetCoord to{column + std::lround(jumps.vector(k).x()),
                                         row - std::lround(jumps.vector(k).y())};
                    ASSERT_EQ(static_cast<CellIndex>(index + table[k].delta), layout.index(to));
                    ASSERT_EQ(jumps.successor(index, k), layout.index(to));
                    ASSERT_EQ(jumps.predecessor(layout.index(to), k), index);
                    std::set<OffsetCoord> needed;
                    for (std::uint16_t t = table[k].firstTouch; t < table[k].endTouch; ++t)
                        needed.insert(layout.offset(static_cast<CellIndex>(index + jumps.touched()[t])));
                    ASSERT_EQ(needed, neededBy(from, to, rule)) << "row " << row << ", jump " << k;
                }
            }
    }
}

INSTANTIATE_TEST_SUITE_P(All, SquareJumpsOfAllKinds,
                         ::testing::Combine(::testing::Values(4, 8),
                                            ::testing::Values(JumpRule::Safe, JumpRule::Hopping)));

TEST(SquareJumps, aSquareHasFourOrEightNeighbours)
{
    for (const int neighbours : {-4, 0, 1, 6, 9, 16})
        EXPECT_THROW(SquareJumps(CellLayout(9, 8), neighbours), std::domain_error) << neighbours;
}
