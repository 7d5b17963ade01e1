#include <seahex/world/Clearance.h>

#include "support/AsciiWorld.h"
#include "support/LatticeKinds.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// Distance to the nearest cell that is blocked, or free, by looking at each; the cells around the lattice are blocked.
template <class LatticeType>
double nearestByBruteForce(const LatticeOccupancy<LatticeType> &occupancy, const Point &p, bool blocked)
{
    const CellOracle<LatticeType> oracle(occupancy.lattice());
    long double least = std::numeric_limits<long double>::infinity();
    forEachCell(occupancy.lattice(), 1,
                [&](typename LatticeType::Cell cell)
                {
                    if (occupancy.isBlocked(cell) == blocked)
                        least = std::min(least, oracle.distance(p, cell));
                });
    return static_cast<double>(least);
}

template <class LatticeType>
LatticeType anyLattice(Random &random)
{
    const double pitch = std::pow(10.0, random.real(-2.0, 2.0));
    // wider than one word of bits, now and then
    return {pitch * random.pointIn({Point(-9, -9), Point(9, 9)}), pitch,
            random.integer(1, random.chance(0.2) ? 150 : 20), random.integer(1, 20)};
}

/// Empty, full, and all between.
double anyDensity(Random &random)
{
    return random.chance(0.3) ? std::pow(10.0, random.real(-3.0, -1.0)) : random.real(-0.2, 1.2);
}

template <class LatticeType>
class ClearanceOf : public ::testing::Test
{
};

TYPED_TEST_SUITE(ClearanceOf, LatticeKinds, LatticeKindNames);

}  // namespace

TYPED_TEST(ClearanceOf, nearestBlockedEqualsBruteForce)
{
    for (std::uint64_t seed = 1; seed <= 800; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const auto occupancy = randomOccupancy(random, anyLattice<TypeParam>(random), anyDensity(random));
        const TypeParam &lattice = occupancy->lattice();
        for (int i = 0; i < 10; ++i)
        {
            const Point p = random.pointOf(lattice, random.cellOf(lattice));
            const CellDistance nearest = nearestBlocked(*occupancy, p);
            const double expected = nearestByBruteForce(*occupancy, p, true);
            ASSERT_NEAR(nearest.distance, expected, 1e-9 * 200 * lattice.pitch())
                << p.transpose() << toPicture(*occupancy);
            ASSERT_TRUE(occupancy->isBlocked(TypeParam::cell(nearest.cell)));
            ASSERT_NEAR(lattice.distance(p, TypeParam::cell(nearest.cell)), nearest.distance,
                        1e-9 * 200 * lattice.pitch());
        }
    }
}

TYPED_TEST(ClearanceOf, nearestFreeEqualsBruteForce)
{
    for (std::uint64_t seed = 1; seed <= 800; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const auto occupancy = randomOccupancy(random, anyLattice<TypeParam>(random), anyDensity(random));
        const TypeParam &lattice = occupancy->lattice();
        const Point margin(30.0 * lattice.pitch(), 30.0 * lattice.pitch());
        for (int i = 0; i < 10; ++i)
        {
            // in the lattice, and on all sides of it
            const Point p = i < 5 ? random.pointOf(lattice, random.cellOf(lattice))
                                  : random.pointIn({lattice.bounds().min - margin, lattice.bounds().max + margin});
            const std::optional<CellDistance> nearest = nearestFree(*occupancy, p);
            const double expected = nearestByBruteForce(*occupancy, p, false);
            ASSERT_EQ(nearest.has_value(), std::isfinite(expected));
            if (!nearest)
                continue;
            ASSERT_NEAR(nearest->distance, expected, 1e-9 * 200 * lattice.pitch())
                << p.transpose() << toPicture(*occupancy);
            ASSERT_TRUE(occupancy->isFree(TypeParam::cell(nearest->cell)));
            ASSERT_NEAR(lattice.distance(p, TypeParam::cell(nearest->cell)), nearest->distance,
                        1e-9 * 200 * lattice.pitch());
        }
    }
}

TYPED_TEST(ClearanceOf, outsideOfTheLatticeIsBlocked)
{
    const auto occupancy = occupancyWith(TypeParam(Point::Zero(), 1.0, 20, 20), {});
    for (const Point &p : {Point(-5, -5), Point(50, -5), Point(8, 5), Point(8, -90), Point(0.1, -0.1)})
    {
        if (occupancy->lattice().contains(occupancy->lattice().cellAt(p)))
            continue;  // the last one lies in a notch of hexagons, where squares have none
        EXPECT_EQ(nearestBlocked(*occupancy, p).distance, 0.0) << p.transpose();
        EXPECT_TRUE(occupancy->isBlocked(TypeParam::cell(nearestBlocked(*occupancy, p).cell))) << p.transpose();
        EXPECT_LE(signedClearance(*occupancy, p), 0.0) << p.transpose();
        EXPECT_NEAR(signedClearance(*occupancy, p), -nearestByBruteForce(*occupancy, p, false), 1e-9) << p.transpose();
    }
}

TEST(Clearance, signTellsFreeFromBlocked)
{
    const AsciiWorld world(R"(
         . . . . . .
        . . . A . .
         . . . . . .
        . # B # . .
         . . # . . .
        . . . . . .
    )");
    const HexOccupancy &occupancy = world.occupancy();
    // A: two rows above the rock in row 3, whose tip is the nearest point of it
    EXPECT_NEAR(signedClearance(occupancy, world.centre('A')), 3.0 / std::sqrt(3.0) - 1.0 / std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(signedClearance(occupancy, world.centre('B')), 0.5, 1e-12);
    // the middle of a rock is half a cell from free water
    EXPECT_NEAR(signedClearance(occupancy, world.lattice().centre(toCube({1, 3}))), -0.5, 1e-12);
    EXPECT_NEAR(signedClearance(occupancy, world.lattice().centre(toCube({2, 4}))), -0.5, 1e-12);
}

TYPED_TEST(ClearanceOf, signedClearanceEqualsBruteForce)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const auto some = randomOccupancy(random, anyLattice<TypeParam>(random), random.real(0.1, 0.9));
        const TypeParam &lattice = some->lattice();
        for (int i = 0; i < 10; ++i)
        {
            const Point p = random.pointOf(lattice, random.cellOf(lattice));
            const bool free = some->isFree(lattice.cellAt(p));
            const double expected = free ? nearestByBruteForce(*some, p, true) : -nearestByBruteForce(*some, p, false);
            const double clearance = signedClearance(*some, p);
            if (std::isfinite(expected))
                ASSERT_NEAR(clearance, expected, 1e-9 * 200 * lattice.pitch()) << p.transpose();
            else
                ASSERT_EQ(clearance, expected) << p.transpose();
        }
    }
}

TYPED_TEST(ClearanceOf, withoutAFreeCell)
{
    const auto full =
        occupancyWith(TypeParam(Point::Zero(), 1.0, 2, 1), {TypeParam::cell({0, 0}), TypeParam::cell({1, 0})});
    EXPECT_FALSE(nearestFree(*full, {1.0, -0.5}).has_value());
    EXPECT_EQ(signedClearance(*full, {1.0, -0.5}), -std::numeric_limits<double>::infinity());
}

TYPED_TEST(ClearanceOf, positionsFarAway)
{
    const auto occupancy = occupancyWith(TypeParam(Point::Zero(), 1.0, 20, 20), {});
    for (const Point &p : {Point(1e9, 0), Point(0, 1e9), Point(-1e15, -1e15), Point(1e100, 0), Point(0, -1e100)})
    {
        EXPECT_EQ(nearestBlocked(*occupancy, p).distance, 0.0) << p.transpose();
        ASSERT_TRUE(nearestFree(*occupancy, p).has_value()) << p.transpose();
        EXPECT_NEAR(nearestFree(*occupancy, p)->distance / p.norm(), 1.0, 1e-6) << p.transpose();
        EXPECT_LT(signedClearance(*occupancy, p), -1e8) << p.transpose();
    }
}
