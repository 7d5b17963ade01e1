#include <seahex/search/HexJumps.h>

#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/HexTraversal.h>

#include <vector>

#include <gtest/gtest.h>

using namespace seahex;

namespace
{

std::vector<HexCoord> touchedBesides(HexCoord from, HexCoord to)
{
    std::vector<HexCoord> cells;
    forEachTouchedCell(from, to,
                       [&](HexCoord cell)
                       {
                           if (cell != from)
                               cells.push_back(cell);
                           return true;
                       });
    return cells;
}

}  // namespace

class HexJumpsOfAllKinds : public ::testing::TestWithParam<std::tuple<int, JumpSet>>
{
protected:
    const int rings = std::get<0>(GetParam());
    const JumpSet set = std::get<1>(GetParam());
};

TEST_P(HexJumpsOfAllKinds, areThoseOfTheRings)
{
    const HexJumps jumps(CellLayout(9, 8), rings, set);
    std::vector<HexCoord> expected;
    for (const RingOffset &offset : ringOffsets(rings))
        if (set == JumpSet::All || offset.primitive)
            expected.push_back(offset.offset);
    ASSERT_EQ(jumps.size(), expected.size());
    EXPECT_EQ(jumps.rings(), rings);
    const HexLattice lattice(Point::Zero(), 1.0, 9, 8);
    for (std::size_t k = 0; k < jumps.size(); ++k)
    {
        EXPECT_EQ(jumps.offset(k).offset, expected[k]);
        EXPECT_NEAR(jumps.length(k), (lattice.centre(expected[k]) - lattice.centre({0, 0})).norm(), 1e-12);
        EXPECT_EQ(jumps.offset(jumps.opposite(k)).offset, -1 * expected[k]);
    }
}

TEST_P(HexJumpsOfAllKinds, tablesEqualTheTraversalFromEveryCell)
{
    // wide enough that rows are of more than one word
    for (const std::int64_t columns : {1, 9, 64, 70})
    {
        const CellLayout layout(columns, 7);
        const HexJumps jumps(layout, rings, set);
        for (std::int64_t row = 0; row < 7; ++row)
            for (std::int64_t column = 0; column < columns; ++column)
            {
                const HexCoord from = toCube({column, row});
                const CellIndex index = layout.index(from);
                ASSERT_EQ(jumps.parity(index), row % 2);
                const std::vector<Jump> &table = jumps.from(jumps.parity(index));
                ASSERT_EQ(table.size(), jumps.size());
                for (std::size_t k = 0; k < jumps.size(); ++k)
                {
                    const HexCoord to = from + jumps.offset(k).offset;
                    ASSERT_EQ(static_cast<CellIndex>(index + table[k].delta), layout.index(to));
                    ASSERT_EQ(jumps.predecessor(layout.index(to), k), index);
                    std::vector<HexCoord> touched;
                    for (std::uint16_t t = table[k].firstTouch; t < table[k].endTouch; ++t)
                        touched.push_back(layout.cell(static_cast<CellIndex>(index + jumps.touched()[t])));
                    ASSERT_EQ(touched, touchedBesides(from, to));
                }
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Rings, HexJumpsOfAllKinds,
                         ::testing::Combine(::testing::Values(1, 2, 3),
                                            ::testing::Values(JumpSet::Primitive, JumpSet::All)));

TEST(HexJumps, publishedCounts)
{
    const CellLayout layout(9, 8);
    const std::size_t all[] = {6, 18, 36};
    const std::size_t primitive[] = {6, 12, 24};
    for (const int rings : {1, 2, 3})
    {
        EXPECT_EQ(HexJumps(layout, rings, JumpSet::All).size(), all[rings - 1]);
        EXPECT_EQ(HexJumps(layout, rings, JumpSet::Primitive).size(), primitive[rings - 1]);
    }
}
