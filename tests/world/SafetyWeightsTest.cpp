#include <seahex/world/SafetyWeights.h>

#include "support/AsciiWorld.h"
#include "support/LatticeKinds.h"
#include "support/Random.h"

#include <type_traits>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// How far apart the centres of cells that touch are at most, in pitches.
constexpr double reachOf(const HexLattice *)
{
    return 1.0;
}
constexpr double reachOf(const SquareLattice *)
{
    return 1.4142136;
}

/// Blocked cells that touch a cell, counted by looking at every cell.
template <class LatticeType>
int blockedNeighbours(const LatticeOccupancy<LatticeType> &occupancy, typename LatticeType::Cell cell)
{
    const LatticeType &lattice = occupancy.lattice();
    int count = 0;
    forEachCell(lattice, 1,
                [&](typename LatticeType::Cell other)
                {
                    const double distance = (lattice.centre(other) - lattice.centre(cell)).norm() / lattice.pitch();
                    if (other != cell && distance < reachOf(&lattice) + 0.01 && occupancy.isBlocked(other))
                        ++count;
                });
    return count;
}

template <class LatticeType>
class SafetyWeightsOf : public ::testing::Test
{
};

TYPED_TEST_SUITE(SafetyWeightsOf, LatticeKinds, LatticeKindNames);

}  // namespace

TEST(SafetyWeights, thePublishedNumbers)
{
    EXPECT_EQ(SafetyWeights::ofBlocked(0), 1.0);
    EXPECT_EQ(SafetyWeights::ofBlocked(1), 1.5);
    EXPECT_EQ(SafetyWeights::ofBlocked(2), 2.0);
    EXPECT_EQ(SafetyWeights::ofBlocked(3), 3.0);
    EXPECT_EQ(SafetyWeights::ofBlocked(4), 5.0);
    EXPECT_EQ(SafetyWeights::ofBlocked(5), 9.0);
    EXPECT_EQ(SafetyWeights::ofBlocked(6), 17.0);
    EXPECT_EQ(SafetyWeights::ofBlocked(7), 33.0);
    EXPECT_EQ(SafetyWeights::ofBlocked(8), 65.0);
}

TEST(SafetyWeights, aSmallWorld)
{
    const AsciiWorld world(R"(
         . . . . . . .
        . A . # # # .
         . B # E # . .
        . . C # # . .
         . . . . D . .
        . . . . . . .
    )");
    const SafetyWeights weights(world.occupancy());
    EXPECT_EQ(weights.weight(world.cell('A')), 1.0);
    EXPECT_EQ(weights.weight(world.cell('B')), 1.5);
    EXPECT_EQ(weights.weight(world.cell('C')), 2.0);
    EXPECT_EQ(weights.weight(world.cell('D')), 1.5);
    EXPECT_EQ(weights.weight(world.cell('E')), 17.0);
    // the rim: outside is blocked
    EXPECT_EQ(weights.weight(toCube({3, 5})), 2.0);
    EXPECT_EQ(weights.weight(toCube({0, 1})), 3.0);
    EXPECT_EQ(weights.weight(toCube({0, 5})), 5.0);
    // blocked, and outside
    EXPECT_EQ(weights.weight(toCube({3, 1})), 17.0);
    EXPECT_EQ(weights.weight(toCube({-1, 2})), 17.0);
    EXPECT_EQ(weights.weight(toCube({1000, -1000})), 17.0);
}

TEST(SafetyWeights, aSmallWorldOfSquares)
{
    const SquareWorld world(R"(
        . . . . . . .
        . A . # # # .
        . . B # E # .
        . . C # # # .
        . . . D . . .
        . . . . . . .
    )");
    const SafetyWeights weights(world.occupancy());
    EXPECT_EQ(weights.weight(world.cell('A')), 1.0);
    EXPECT_EQ(weights.weight(world.cell('B')), 3.0) << "three rocks: one beside it, two over the corners";
    EXPECT_EQ(weights.weight(world.cell('C')), 2.0);
    EXPECT_EQ(weights.weight(world.cell('D')), 2.0);
    EXPECT_EQ(weights.weight(world.cell('E')), 65.0);
    // the rim: outside is blocked
    EXPECT_EQ(weights.weight(OffsetCoord{3, 5}), 3.0);
    EXPECT_EQ(weights.weight(OffsetCoord{0, 5}), 9.0);
    // blocked, and outside
    EXPECT_EQ(weights.weight(OffsetCoord{3, 1}), 65.0);
    EXPECT_EQ(weights.weight(OffsetCoord{-1, 2}), 65.0);
    EXPECT_EQ(weights.weight(OffsetCoord{1000, -1000}), 65.0);
}

TYPED_TEST(SafetyWeightsOf, everyCellOfRandomWorlds)
{
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
    {
        Random random(seed);
        const TypeParam lattice({random.real(-9, 9), random.real(-9, 9)}, random.real(0.1, 9.0),
                                random.integer(1, random.chance(0.2) ? 80 : 12), random.integer(1, 12));
        const auto occupancy = randomOccupancy(random, lattice, random.real(-0.2, 1.2));
        SCOPED_TRACE(random.seedText() + toPicture(*occupancy));
        const SafetyWeights weights(*occupancy);
        EXPECT_EQ(weights.lattice(), Lattice(lattice));
        const double ofBlocked = std::is_same_v<TypeParam, HexLattice> ? 17.0 : 65.0;
        forEachCell(lattice, 3,
                    [&](typename TypeParam::Cell cell)
                    {
                        const double expected = occupancy->isBlocked(cell)
                                                    ? ofBlocked
                                                    : SafetyWeights::ofBlocked(blockedNeighbours(*occupancy, cell));
                        ASSERT_EQ(weights.weight(cell), expected)
                            << "column " << toOffset(cell).column << ", row " << toOffset(cell).row;
                        ASSERT_EQ(weights.weightAt(occupancy->layout().index(cell)), expected);
                    });
    }
}
