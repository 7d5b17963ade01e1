#include <seahex/world/SafetyWeights.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/Random.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// Blocked cells at a distance of one pitch from the cell, counted by looking at every cell.
int blockedNeighbours(const HexOccupancy &occupancy, HexCoord cell)
{
    const HexLattice &lattice = occupancy.lattice();
    int count = 0;
    forEachCell(lattice, 1,
                [&](HexCoord other)
                {
                    const double distance = (lattice.centre(other) - lattice.centre(cell)).norm();
                    if (std::abs(distance - lattice.pitch()) < 0.01 * lattice.pitch() && occupancy.isBlocked(other))
                        ++count;
                });
    return count;
}

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

TEST(SafetyWeights, everyCellOfRandomWorlds)
{
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
    {
        Random random(seed);
        const HexLattice lattice({random.real(-9, 9), random.real(-9, 9)}, random.real(0.1, 9.0),
                                 random.integer(1, random.chance(0.2) ? 80 : 12), random.integer(1, 12));
        const auto occupancy = randomOccupancy(random, lattice, random.real(-0.2, 1.2));
        SCOPED_TRACE(random.seedText() + toPicture(*occupancy));
        const SafetyWeights weights(*occupancy);
        forEachCell(lattice, 3,
                    [&](HexCoord cell)
                    {
                        const double expected = occupancy->isBlocked(cell)
                                                    ? 17.0
                                                    : SafetyWeights::ofBlocked(blockedNeighbours(*occupancy, cell));
                        ASSERT_EQ(weights.weight(cell), expected) << "cell " << cell.q << ", " << cell.s;
                        ASSERT_EQ(weights.weightAt(occupancy->layout().index(cell)), expected);
                    });
    }
}
