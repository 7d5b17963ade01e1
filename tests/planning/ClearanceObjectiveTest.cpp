#include <seahex/planning/ClearanceObjective.h>

#include "planning/MotionCosts.h"
#include "support/AsciiWorld.h"
#include "support/LatticeKinds.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

class ClearanceObjectiveAtARock : public ::testing::Test
{
protected:
    const AsciiWorld world{R"(
         . . . . . . . . . . . . .
        . . . . . . . . . . . . .
         . . . . . . . . . . . . .
        . . . . . . . . . . . . .
         . . . A . C . . . B . . .
        . . . . . . # . . . . . .
         . . . . . . . . . . . . .
        . . . . . . . . . . . . .
         . . . . . . . . . . . . .
        . . . . . . . . . . . . .
    )",
                           2.0, Point(100.0, -50.0)};
    const ob::SpaceInformationPtr si = chartSpace(world.shared());
    const double pitch = world.lattice().pitch();
    const double side = world.lattice().side();
};

TEST_F(ClearanceObjectiveAtARock, EveryCellIsChargedForItsPart)
{
    // Past the rock, in whole cells: open water; at a corner of the rock, two sides away; beside it, half a pitch away;
    // and the same again.
    const ClearanceObjective objective(si, world.occupancy(), 4.0, 3.0);
    const double beside = 1.0 + 3.0 * (1.0 - 0.5 * pitch / 4.0);
    const double near = 1.0 + 3.0 * (1.0 - 2.0 * side / 4.0);
    EXPECT_NEAR(motionCost(objective, world.centre('A'), world.centre('B')), pitch * (2.0 + 2.0 * near + 2.0 * beside),
                1e-5);
    EXPECT_NEAR(objective.stateCost(stateAt(si, world.centre('C')).get()).value(), beside, 1e-6);
    EXPECT_EQ(objective.stateCost(stateAt(si, world.centre('A')).get()).value(), 1.0) << "as open as wanted";
    EXPECT_NEAR(objective.stateCost(stateAt(si, world.lattice().centre(toCube({6, 5}))).get()).value(), 4.0, 1e-12);
}

TEST_F(ClearanceObjectiveAtARock, OpenWaterCostsItsLengthWhateverTheNumberWanted)
{
    for (int tenths = 1; tenths <= 41; ++tenths)
    {
        const double wanted = 0.1 * tenths;
        const ClearanceObjective objective(si, world.occupancy(), wanted, 3.0);
        EXPECT_EQ(objective.stateCost(stateAt(si, world.centre('A')).get()).value(), 1.0) << wanted;
    }
}

TEST_F(ClearanceObjectiveAtARock, WithNothingWantedItIsTheLength)
{
    const double length = (world.centre('B') - world.centre('A')).norm();
    for (const auto &[wanted, strength] : {std::pair{0.0, 5.0}, std::pair{4.0, 0.0}})
        EXPECT_NEAR(motionCost(ClearanceObjective(si, world.occupancy(), wanted, strength), world.centre('A'),
                               world.centre('B')),
                    length, 1e-12);
}

TEST_F(ClearanceObjectiveAtARock, OutsideTheLatticeCostsAsMuchAsBlocked)
{
    const ClearanceObjective objective(si, world.occupancy(), 4.0, 3.0);
    const Point inside = world.centre('A');
    for (const Point &outside : {Point(0.0, 0.0), Point(1e15, -50.0)})
    {
        EXPECT_NEAR(motionCost(objective, inside, outside) / (4.0 * (outside - inside).norm()), 1.0, 1e-12);
        EXPECT_EQ(motionCost(objective, inside, outside), motionCost(objective, outside, inside));
    }
}

TEST_F(ClearanceObjectiveAtARock, SaysWhatItIs)
{
    const ClearanceObjective objective(si, world.occupancy(), 4.0, 3.0);
    EXPECT_TRUE(objective.isSymmetric());
    EXPECT_EQ(objective.wantedClearance(), 4.0);
    EXPECT_EQ(objective.strength(), 3.0);
    EXPECT_NEAR(objective.clearances().clearance(world.cell('C')), 1.0, 1e-6);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {-1.0, nan, infinity})
    {
        EXPECT_THROW(ClearanceObjective(si, world.occupancy(), bad, 1.0), ompl::Exception);
        EXPECT_THROW(ClearanceObjective(si, world.occupancy(), 1.0, bad), ompl::Exception);
    }
    const auto solid = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(3));
    EXPECT_THROW(ClearanceObjective(solid, world.occupancy(), 1.0, 1.0), ompl::Exception);
}

TEST_F(ClearanceObjectiveAtARock, TwoThreadsMayAsk)
{
    expectSameFromTwoThreads(ClearanceObjective(si, world.occupancy(), 5.0, 2.0), world.lattice());
}

TEST(ClearanceObjective, OnSquaresEveryCellIsChargedForItsPart)
{
    const SquareLattice lattice(Point(100.0, -50.0), 2.0, 15, 15);
    const auto occupancy = occupancyWith(lattice, {{7, 7}});
    const ClearanceObjective objective(chartSpace(occupancy), *occupancy, 3.0, 6.0);
    const auto at = [&lattice](std::int64_t column, std::int64_t row)
    {
        return lattice.centre({column, row});
    };
    // past the rock: open water, at its corner, beside it, and the same again
    const double corner = 1.0 + 6.0 * (1.0 - std::sqrt(2.0) / 3.0);
    const double beside = 1.0 + 6.0 * (1.0 - 1.0 / 3.0);
    EXPECT_NEAR(motionCost(objective, at(5, 8), at(9, 8)), 2.0 * (1.0 + 2.0 * corner + beside), 1e-5);
    EXPECT_EQ(objective.clearances().clearance(OffsetCoord{7, 8}), 1.0);
}

template <class LatticeType>
class ClearanceObjectiveOn : public testing::Test
{
};
TYPED_TEST_SUITE(ClearanceObjectiveOn, LatticeKinds, LatticeKindNames);

TYPED_TEST(ClearanceObjectiveOn, SymmetricAddsUpAndIsBounded)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice(Point(random.real(-50, 50), random.real(-50, 50)), random.real(0.3, 3.0),
                                random.integer(4, 12), random.integer(4, 12));
        const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.4));
        const auto si = chartSpace(occupancy, random.chance(0.5) ? SpaceKind::Plane : SpaceKind::Pose);
        const double wanted = random.real(0.0, 6.0) * lattice.pitch();
        const double strength = random.real(0.0, 9.0);
        const ClearanceObjective objective(si, *occupancy, wanted, strength);
        const ClearanceObjective wider(si, *occupancy, 1.5 * wanted, strength);
        const ClearanceObjective stronger(si, *occupancy, wanted, 1.5 * strength);
        for (int i = 0; i < 10; ++i)
        {
            const Point a = random.pointOf(lattice, random.cellOf(lattice));
            const Point b = random.pointOf(lattice, random.cellOf(lattice));
            const Point cut = a + random.unit() * (b - a);
            const double whole = motionCost(objective, a, b);
            EXPECT_EQ(motionCost(objective, b, a), whole);
            if (lattice.contains(lattice.cellAt(a)) && lattice.contains(lattice.cellAt(b)) &&
                lattice.contains(lattice.cellAt(cut)))
            {
                EXPECT_NEAR(motionCost(objective, a, cut) + motionCost(objective, cut, b), whole, 1e-9 * whole);
            }
            EXPECT_GE(whole, (b - a).norm() * (1.0 - 1e-12));
            EXPECT_LE(whole, (1.0 + strength) * (b - a).norm() * (1.0 + 1e-12));
            EXPECT_LE(heuristic(objective, a, b), whole);
            EXPECT_GE(heuristic(objective, a, b), (b - a).norm() * (1.0 - 1e-8));
            EXPECT_GE(motionCost(wider, a, b), whole * (1.0 - 1e-6));
            EXPECT_GE(motionCost(stronger, a, b), whole * (1.0 - 1e-12));
        }
        ASSERT_FALSE(::testing::Test::HasFailure());
    }
}

}  // namespace
}  // namespace seahex::test
