#include <seahex/world/ClearanceField.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// Distance from the cell's centre to the nearest blocked cell, by looking at each.
double clearanceByBruteForce(const HexOccupancy &occupancy, HexCoord cell)
{
    const HexOracle oracle(occupancy.lattice());
    const Point centre = occupancy.lattice().centre(cell);
    long double least = std::numeric_limits<long double>::infinity();
    forEachCell(occupancy.lattice(), 1,
                [&](HexCoord other)
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

TEST(ClearanceField, everyCellOfRandomWorlds)
{
    for (std::uint64_t seed = 1; seed <= 120; ++seed)
    {
        Random random(seed);
        const double pitch = std::pow(10.0, random.real(-2.0, 2.0));
        const HexLattice lattice(pitch * random.pointIn({Point(-9, -9), Point(9, 9)}), pitch,
                                 random.integer(1, random.chance(0.2) ? 80 : 14), random.integer(1, 14));
        const double density = random.chance(0.5) ? std::pow(10.0, random.real(-3.0, -1.0)) : random.real(-0.2, 1.2);
        const auto occupancy = randomOccupancy(random, lattice, density);
        SCOPED_TRACE(random.seedText() + toPicture(*occupancy));
        const double limit = random.real(0.3, 8.0) * pitch;
        const ClearanceField field(*occupancy);
        const ClearanceField limited(*occupancy, limit);
        forEachCell(lattice, 2,
                    [&](HexCoord cell)
                    {
                        const double expected =
                            occupancy->isBlocked(cell) ? 0.0 : clearanceByBruteForce(*occupancy, cell);
                        const double clearance = field.clearance(cell);
                        ASSERT_NEAR(clearance, expected, 2e-7 * expected + 1e-12 * pitch)
                            << "cell " << cell.q << ", " << cell.s;
                        ASSERT_LE(clearance, expected + 1e-12 * pitch) << "rounded down";
                        ASSERT_EQ(clearance, field.clearanceAt(occupancy->layout().index(cell)));
                        const double within = expected == 0.0 ? 0.0 : std::min(expected, limit);
                        ASSERT_NEAR(limited.clearance(cell), within, 2e-7 * within + 1e-12 * pitch);
                    });
    }
}
