#include <seahex/search/LengthWeight.h>

#include <seahex/geometry/HexNorm.h>

#include <gtest/gtest.h>

using namespace seahex;

namespace
{

const HexLattice lattice({500.0, 900.0}, 20.0, 30, 30);
const HexCoord startCell = toCube({2, 3});
const HexCoord goalCell = toCube({25, 20});

LengthWeight weightOf(const HexJumps &jumps, LengthMetric metric, Guidance guidance)
{
    return {lattice, jumps, metric, guidance, lattice.centre(startCell), lattice.centre(goalCell)};
}

}  // namespace

TEST(LengthWeight, costsAreLengthsInPitchesOrSteps)
{
    const HexJumps jumps(CellLayout(30, 30), 3, JumpSet::All);
    const LengthWeight euclidean = weightOf(jumps, LengthMetric::Euclidean, Guidance::None);
    const LengthWeight steps = weightOf(jumps, LengthMetric::Lattice, Guidance::None);
    for (std::size_t k = 0; k < jumps.size(); ++k)
    {
        const HexCoord offset = jumps.offset(k).offset;
        const double length = (lattice.centre(offset) - lattice.centre({0, 0})).norm() / lattice.pitch();
        EXPECT_NEAR(euclidean.jumpCost(0, 0, k, 255), length, 1e-12);
        EXPECT_EQ(steps.jumpCost(0, 0, k, 255), static_cast<double>(hexNorm(offset)));
    }
}

TEST(LengthWeight, boundsByGuidance)
{
    for (const int rings : {1, 2, 3})
    {
        const HexJumps jumps(CellLayout(30, 30), rings, JumpSet::Primitive);
        for (const LengthMetric metric : {LengthMetric::Euclidean, LengthMetric::Lattice})
        {
            const LengthWeight none = weightOf(jumps, metric, Guidance::None);
            const LengthWeight distance = weightOf(jumps, metric, Guidance::Distance);
            const LengthWeight tieBreak = weightOf(jumps, metric, Guidance::TieBreak);
            const LengthWeight cheng = weightOf(jumps, metric, Guidance::Cheng);
            for (std::int64_t row = 0; row < 30; ++row)
                for (std::int64_t column = 0; column < 30; ++column)
                {
                    const HexCoord cell = toCube({column, row});
                    const GoalCell goal{goalCell, 0.25};
                    const auto steps = static_cast<double>(hexDistance(cell, goalCell));
                    const double exact = metric == LengthMetric::Lattice ? steps : ringNorm(goalCell - cell, rings);
                    ASSERT_EQ(none.bound(toOffset(cell), goal), 0.0);
                    ASSERT_EQ(distance.bound(toOffset(cell), goal), exact + 0.25);
                    ASSERT_EQ(tieBreak.bound(toOffset(cell), goal), exact + 0.25);
                    // [Cheng2020] eq. 10: D(i, E) p(i)
                    const double p =
                        pilotQuantity(lattice.centre(startCell), lattice.centre(goalCell), lattice.centre(cell));
                    ASSERT_NEAR(cheng.bound(toOffset(cell), goal), steps * p + 0.25, 1e-12);
                    ASSERT_LE(cheng.bound(toOffset(cell), goal), steps + 0.25 + 1e-12) << "never above D";
                }
        }
    }
}

TEST(LengthWeight, distanceIsConsistent)
{
    // no jump lowers the bound by more than it costs: nothing needs to be expanded twice
    for (const int rings : {1, 2, 3})
    {
        const HexJumps jumps(CellLayout(30, 30), rings, JumpSet::All);
        for (const LengthMetric metric : {LengthMetric::Euclidean, LengthMetric::Lattice})
        {
            const LengthWeight weight = weightOf(jumps, metric, Guidance::Distance);
            for (std::int64_t row = 0; row < 30; ++row)
                for (std::int64_t column = 0; column < 30; ++column)
                    for (std::size_t k = 0; k < jumps.size(); ++k)
                    {
                        const HexCoord from = toCube({column, row});
                        const HexCoord to = from + jumps.offset(k).offset;
                        const GoalCell goal{goalCell, 0.0};
                        ASSERT_LE(weight.bound(toOffset(from), goal),
                                  weight.jumpCost(0, 0, k, 255) + weight.bound(toOffset(to), goal) + 1e-12);
                    }
        }
    }
}

TEST(LengthWeight, tiesGoToTheLineOrToTheGoal)
{
    const HexJumps jumps(CellLayout(30, 30), 1, JumpSet::Primitive);
    const LengthWeight distance = weightOf(jumps, LengthMetric::Euclidean, Guidance::Distance);
    const LengthWeight tieBreak = weightOf(jumps, LengthMetric::Euclidean, Guidance::TieBreak);
    const HexCoord cell = toCube({9, 17});
    EXPECT_EQ(distance.tie(toOffset(cell), 12.5), 12.5);
    EXPECT_EQ(tieBreak.tie(toOffset(cell), 12.5),
              distanceFromLine(lattice.centre(startCell), lattice.centre(goalCell), lattice.centre(cell)));
    EXPECT_EQ(tieBreak.tie(toOffset(startCell), 12.5), 0.0);
}
