#include <seahex/world/ClearanceField.h>

#include "support/AsciiWorld.h"
#include "support/LatticeKinds.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

template <class LatticeType>
class ClearanceFieldOn : public testing::Test
{
};
TYPED_TEST_SUITE(ClearanceFieldOn, LatticeKinds, LatticeKindNames);

/// Distance from the cell's centre to the nearest blocked cell, by looking at each.
template <class LatticeType>
double clearanceByBruteForce(const LatticeOccupancy<LatticeType> &occupancy, typename LatticeType::Cell cell)
{
    const CellOracle<LatticeType> oracle(occupancy.lattice());
    const Point centre = occupancy.lattice().centre(cell);
    long double least = std::numeric_limits<long double>::infinity();
    forEachCell(occupancy.lattice(), 1,
                [&](typename LatticeType::Cell other)
                {
                    if (occupancy.isBlocked(other))
                        least = std::min(least, oracle.distance(centre, other));
                });
    return static_cast<double>(least);
}

}  // namespace

TEST(ClearanceField, aSmallWorld)
{
    const AsciiWorld world(R"(
         . . . . . . . . .
        . . . . . . . . .
         . . . . A . . . .
        . . . . . . . . .
         . . . . # B . C .
        . . . . D . . . .
         . . . . . . . . .
        . . . . . . . . .
         . . . . . . . . .
    )",
                           2.0);
    const double side = world.lattice().side();
    const ClearanceField field(world.occupancy());
    // A: two rows above the rock, whose tip is nearest
    EXPECT_NEAR(field.clearance(world.cell('A')), 3.0 * side - side, 1e-6);
    EXPECT_NEAR(field.clearance(world.cell('B')), 1.0, 1e-6);
    // C: two sides from the corner of a cell beyond the rim, as odd rows end farther west
    EXPECT_NEAR(field.clearance(world.cell('C')), 2.0 * side, 1e-6);
    EXPECT_NEAR(field.clearance(world.cell('D')), 1.0, 1e-6);
    EXPECT_EQ(field.clearance(toCube({4, 4})), 0.0);
    EXPECT_EQ(field.clearance(toCube({-1, 4})), 0.0);
    EXPECT_EQ(field.clearance(toCube({1000, -1000})), 0.0);

    const ClearanceField near(world.occupancy(), 1.5);
    EXPECT_NEAR(near.clearance(world.cell('B')), 1.0, 1e-6);
    EXPECT_EQ(near.clearance(world.cell('A')), 1.5);
}

TEST(ClearanceField, aRockAmongSquares)
{
    const auto occupancy = occupancyWith(SquareLattice({3.0, 4.0}, 2.0, 11, 11), {{5, 5}});
    const ClearanceField field(*occupancy);
    const auto clearance = [&field](OffsetCoord cell)
    {
        return field.clearance(cell);
    };
    EXPECT_EQ(clearance({5, 5}), 0.0);
    EXPECT_EQ(clearance({6, 5}), 1.0);
    EXPECT_NEAR(clearance({6, 6}), std::sqrt(2.0), 1e-6);
    EXPECT_EQ(clearance({5, 7}), 3.0);
    EXPECT_NEAR(clearance({3, 4}), std::sqrt(9.0 + 1.0), 1e-6);
    EXPECT_EQ(clearance({0, 5}), 1.0) << "beside the rim";
    EXPECT_EQ(clearance({-1, 5}), 0.0);
}

TYPED_TEST(ClearanceFieldOn, everyCellOfRandomWorlds)
{
    for (std::uint64_t seed = 1; seed <= 120; ++seed)
    {
        Random random(seed);
        const double pitch = std::pow(10.0, random.real(-2.0, 2.0));
        const TypeParam lattice(pitch * random.pointIn({Point(-9, -9), Point(9, 9)}), pitch,
                                random.integer(1, random.chance(0.2) ? 80 : 14), random.integer(1, 14));
        const double density = random.chance(0.5) ? std::pow(10.0, random.real(-3.0, -1.0)) : random.real(-0.2, 1.2);
        const auto occupancy = randomOccupancy(random, lattice, density);
        SCOPED_TRACE(random.seedText() + toPicture(*occupancy));
        const double limit = random.real(0.3, 8.0) * pitch;
        const ClearanceField field(*occupancy);
        const ClearanceField limited(*occupancy, limit);
        forEachCell(lattice, 2,
                    [&](typename TypeParam::Cell cell)
                    {
                        const double expected =
                            occupancy->isBlocked(cell) ? 0.0 : clearanceByBruteForce<TypeParam>(*occupancy, cell);
                        const double clearance = field.clearance(cell);
                        ASSERT_NEAR(clearance, expected, 2e-7 * expected + 1e-12 * pitch)
                            << "cell " << toOffset(cell).column << ", " << toOffset(cell).row;
                        ASSERT_LE(clearance, expected + 1e-12 * pitch) << "rounded down";
                        ASSERT_EQ(clearance, field.clearanceAt(occupancy->layout().index(cell)));
                        const double within = expected == 0.0 ? 0.0 : std::min(expected, limit);
                        ASSERT_NEAR(limited.clearance(cell), within, 2e-7 * within + 1e-12 * pitch);
                    });
    }
}
