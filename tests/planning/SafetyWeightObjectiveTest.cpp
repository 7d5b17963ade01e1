#include <seahex/planning/SafetyWeightObjective.h>

#include "planning/MotionCosts.h"
#include "support/AsciiWorld.h"
#include "support/LatticeKinds.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

/// A rock in open water: the cells around it weigh 1.5, the water 1, the rim more.
class SafetyWeightObjectiveAtARock : public ::testing::Test
{
protected:
    const AsciiWorld world{R"(
         . . . . . . . . .
        . . . . . . . . .
         . A C D . . . B .
        . . . . # . . . .
         . . . . E . . . .
        . . . . . . . . .
         . . . . . . . . .
    )",
                           2.0, Point(100.0, -50.0)};
    const ob::SpaceInformationPtr si = chartSpace(world.shared());
    const SafetyWeightObjective onArrival{si, world.occupancy(), SafetyCharge::OnArrival};
    const SafetyWeightObjective alongLine{si, world.occupancy()};
    const double pitch = world.lattice().pitch();
};

TEST_F(SafetyWeightObjectiveAtARock, AStepOnArrivalCostsItsLengthTimesTheWeightOfItsEnd)
{
    EXPECT_NEAR(motionCost(onArrival, world.centre('C'), world.centre('D')), pitch * 1.5, 1e-12);
    EXPECT_NEAR(motionCost(onArrival, world.centre('D'), world.centre('C')), pitch * 1.0, 1e-12);
    // a jump is charged as a whole, whatever it passes
    EXPECT_NEAR(motionCost(onArrival, world.centre('A'), world.centre('D')), 2.0 * pitch * 1.5, 1e-12);
    EXPECT_NEAR(motionCost(onArrival, world.centre('A'), world.centre('B')), 6.0 * pitch * 1.0, 1e-12);
}

TEST_F(SafetyWeightObjectiveAtARock, AlongTheLineEveryCellIsChargedForItsPart)
{
    // half a step in either cell
    EXPECT_NEAR(motionCost(alongLine, world.centre('C'), world.centre('D')), 0.5 * pitch * (1.0 + 1.5), 1e-12);
    // six steps, two of them beside the rock
    EXPECT_NEAR(motionCost(alongLine, world.centre('A'), world.centre('B')), pitch * (4.0 + 2.0 * 1.5), 1e-12);
    // south along the rock's edge: a side in either end, and one that the rock, which weighs 17, and its neighbour
    // share
    const Point north = world.lattice().centre(toCube({4, 2}));
    const double side = world.lattice().side();
    EXPECT_NEAR(motionCost(alongLine, north, world.centre('E')), side * (1.5 + 1.5 + 0.5 * (17.0 + 1.5)), 1e-12);
}

TEST_F(SafetyWeightObjectiveAtARock, AStateCostsTheWeightOfItsCell)
{
    EXPECT_EQ(alongLine.stateCost(stateAt(si, world.centre('D')).get()).value(), 1.5);
    EXPECT_EQ(alongLine.stateCost(stateAt(si, world.centre('C') + Point(0.2, 0.3)).get()).value(), 1.0);
    EXPECT_EQ(alongLine.stateCost(stateAt(si, world.lattice().centre(toCube({4, 3}))).get()).value(), 17.0);
}

TEST_F(SafetyWeightObjectiveAtARock, OutsideTheLatticeCostsAsMuchAsBlocked)
{
    const Point inside = world.centre('A');
    for (const Point &outside : {Point(0.0, 0.0), Point(1e15, -50.0)})
    {
        const double length = (outside - inside).norm();
        EXPECT_NEAR(motionCost(alongLine, inside, outside) / (17.0 * length), 1.0, 1e-12);
        EXPECT_EQ(motionCost(alongLine, inside, outside), motionCost(alongLine, outside, inside));
        EXPECT_NEAR(motionCost(onArrival, inside, outside) / (17.0 * length), 1.0, 1e-12);
    }
}

TEST_F(SafetyWeightObjectiveAtARock, SaysWhatItIs)
{
    EXPECT_FALSE(onArrival.isSymmetric());
    EXPECT_TRUE(alongLine.isSymmetric());
    EXPECT_EQ(onArrival.charge(), SafetyCharge::OnArrival);
    EXPECT_EQ(alongLine.charge(), SafetyCharge::AlongLine);
    EXPECT_EQ(alongLine.weights().weight(world.cell('D')), 1.5);
    const auto line = std::make_shared<ob::SpaceInformation>(std::make_shared<ob::RealVectorStateSpace>(3));
    EXPECT_THROW(SafetyWeightObjective(line, world.occupancy()), ompl::Exception);
}

TEST_F(SafetyWeightObjectiveAtARock, TwoThreadsMayAsk)
{
    expectSameFromTwoThreads(onArrival, world.lattice());
    expectSameFromTwoThreads(alongLine, world.lattice());
}

/// Squares: the cells around a rock weigh 1.5, those around two 2, the water 1.
TEST(SafetyWeightObjective, OnSquaresBothChargeWhatTheyShould)
{
    const SquareLattice lattice(Point(100.0, -50.0), 2.0, 11, 11);
    const auto occupancy = occupancyWith(lattice, {{5, 5}, {5, 6}});
    const ob::SpaceInformationPtr si = chartSpace(occupancy);
    const SafetyWeightObjective onArrival(si, *occupancy, SafetyCharge::OnArrival);
    const SafetyWeightObjective alongLine(si, *occupancy);
    const auto at = [&lattice](std::int64_t column, std::int64_t row)
    {
        return lattice.centre({column, row});
    };
    EXPECT_NEAR(motionCost(onArrival, at(5, 3), at(5, 4)), 2.0 * 1.5, 1e-12);
    EXPECT_NEAR(motionCost(onArrival, at(5, 3), at(6, 4)), std::sqrt(8.0) * 1.5, 1e-12);
    EXPECT_NEAR(motionCost(alongLine, at(5, 3), at(6, 4)), std::sqrt(8.0) * 0.5 * (1.0 + 1.5), 1e-12);
    // past both rocks: water, 1.5, 2, 2, 1.5, water
    EXPECT_NEAR(motionCost(alongLine, at(6, 3), at(6, 8)), 2.0 * (0.5 + 1.5 + 2.0 + 2.0 + 1.5 + 0.5), 1e-12);
    EXPECT_NEAR(motionCost(onArrival, at(6, 3), at(6, 8)), 10.0, 1e-12) << "charged as a whole";
    // along the edge between two columns, shared by them
    const Point aside(1.0, 0.0);
    EXPECT_NEAR(motionCost(alongLine, at(6, 5) + aside, at(6, 6) + aside), 2.0 * 0.5 * (2.0 + 1.0), 1e-12);
    // outside
    const double length = (at(5, 3) - Point(0.0, 0.0)).norm();
    EXPECT_NEAR(motionCost(alongLine, at(5, 3), Point(0.0, 0.0)) / (65.0 * length), 1.0, 1e-12);
    expectSameFromTwoThreads(alongLine, lattice);
}

template <class LatticeType>
class SafetyWeightObjectiveOn : public testing::Test
{
};
TYPED_TEST_SUITE(SafetyWeightObjectiveOn, LatticeKinds, LatticeKindNames);

template <class LatticeType>
constexpr double weightOfBlocked = std::is_same_v<LatticeType, HexLattice> ? 17.0 : 65.0;

/// The neighbours that share an edge with a cell.
std::vector<OffsetCoord> sides(const Lattice &lattice, OffsetCoord cell)
{
    if (lattice.hexagons() != nullptr)
        return lattice.neighbours(cell);
    return {{cell.column + 1, cell.row},
            {cell.column, cell.row - 1},
            {cell.column - 1, cell.row},
            {cell.column, cell.row + 1}};
}

/// A random world, in R^2 or SE(2), with both objectives.
template <class LatticeType>
struct RandomSea
{
    explicit RandomSea(Random &random)
        : occupancy(randomOccupancy(random,
                                    LatticeType(Point(random.real(-50, 50), random.real(-50, 50)),
                                                random.real(0.3, 3.0), random.integer(4, 12), random.integer(4, 12)),
                                    random.real(0.0, 0.5))),
          si(chartSpace(occupancy, random.chance(0.5) ? SpaceKind::Plane : SpaceKind::Pose)),
          onArrival(si, *occupancy, SafetyCharge::OnArrival), alongLine(si, *occupancy, SafetyCharge::AlongLine)
    {
    }

    std::shared_ptr<const LatticeOccupancy<LatticeType>> occupancy;
    ob::SpaceInformationPtr si;
    SafetyWeightObjective onArrival;
    SafetyWeightObjective alongLine;
};

TYPED_TEST(SafetyWeightObjectiveOn, AlongTheLineItIsSymmetricAndAddsUp)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const RandomSea<TypeParam> sea(random);
        for (int i = 0; i < 10; ++i)
        {
            const Point a = anyPoint(random, sea.occupancy->lattice());
            const Point b = anyPoint(random, sea.occupancy->lattice());
            const double whole = motionCost(sea.alongLine, a, b);
            EXPECT_EQ(motionCost(sea.alongLine, b, a), whole);
            const Point cut = a + random.unit() * (b - a);
            if (!sea.occupancy->lattice().contains(sea.occupancy->lattice().cellAt(a)) ||
                !sea.occupancy->lattice().contains(sea.occupancy->lattice().cellAt(b)) ||
                !sea.occupancy->lattice().contains(sea.occupancy->lattice().cellAt(cut)))
                continue;
            EXPECT_NEAR(motionCost(sea.alongLine, a, cut) + motionCost(sea.alongLine, cut, b), whole, 1e-9 * whole);
        }
        ASSERT_FALSE(::testing::Test::HasFailure());
    }
}

TYPED_TEST(SafetyWeightObjectiveOn, NoMotionCostsLessThanItsLengthOrItsHeuristic)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const RandomSea<TypeParam> sea(random);
        for (int i = 0; i < 10; ++i)
        {
            const Point a = anyPoint(random, sea.occupancy->lattice());
            const Point b = anyPoint(random, sea.occupancy->lattice());
            for (const SafetyWeightObjective *objective : {&sea.onArrival, &sea.alongLine})
            {
                const double cost = motionCost(*objective, a, b);
                EXPECT_GE(cost, (b - a).norm() * (1.0 - 1e-12));
                EXPECT_LE(cost, weightOfBlocked<TypeParam> * (b - a).norm() * (1.0 + 1e-12));
                EXPECT_LE(heuristic(*objective, a, b), cost);
                EXPECT_GE(heuristic(*objective, a, b), (b - a).norm() * (1.0 - 1e-8));
            }
        }
        ASSERT_FALSE(::testing::Test::HasFailure());
    }
}

TYPED_TEST(SafetyWeightObjectiveOn, MoreRocksNeverMakeAMotionCheaper)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice(Point(0, 0), 1.0, 8, 8);
        std::vector<typename TypeParam::Cell> blocked;
        double cost = 0.0;
        double onArrivalCost = 0.0;
        const Point a = anyPoint(random, lattice);
        const Point b = anyPoint(random, lattice);
        for (int rocks = 0; rocks < 12; ++rocks)
        {
            const auto occupancy = occupancyWith(lattice, blocked);
            const auto si = chartSpace(occupancy);
            const double dearer = motionCost(SafetyWeightObjective(si, *occupancy), a, b);
            const double dearerOnArrival =
                motionCost(SafetyWeightObjective(si, *occupancy, SafetyCharge::OnArrival), a, b);
            EXPECT_GE(dearer, cost * (1.0 - 1e-12));
            EXPECT_GE(dearerOnArrival, onArrivalCost);
            cost = dearer;
            onArrivalCost = dearerOnArrival;
            blocked.push_back(random.cellOf(lattice));
        }
        ASSERT_FALSE(::testing::Test::HasFailure());
    }
}

TYPED_TEST(SafetyWeightObjectiveOn, OnPathsOfStepsTheTwoDifferByAConstantOfTheEnds)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const RandomSea<TypeParam> sea(random);
        const TypeParam &lattice = sea.occupancy->lattice();
        const OffsetCoord first = toOffset(random.cellOf(lattice));
        OffsetCoord cell = first;
        double published = 0.0;
        double integral = 0.0;
        for (std::int64_t i = random.integer(1, 30); i > 0; --i)
        {
            const std::vector<OffsetCoord> neighbours = sides(lattice, cell);
            const OffsetCoord next = neighbours[static_cast<std::size_t>(random.integer(0, 100)) % neighbours.size()];
            if (!Lattice(lattice).contains(next))
                continue;
            const Point from = Lattice(lattice).centre(cell);
            const Point to = Lattice(lattice).centre(next);
            const double step = motionCost(sea.onArrival, from, to);
            EXPECT_NEAR(step, lattice.pitch() * sea.onArrival.weights().weight(next), 1e-9) << "[Wang2017] eq. 1";
            published += step;
            integral += motionCost(sea.alongLine, from, to);
            cell = next;
        }
        const SafetyWeights &weights = sea.alongLine.weights();
        EXPECT_NEAR(integral - published, 0.5 * lattice.pitch() * (weights.weight(first) - weights.weight(cell)), 1e-9);
        ASSERT_FALSE(::testing::Test::HasFailure());
    }
}

}  // namespace
}  // namespace seahex::test
