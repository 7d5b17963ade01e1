#include "seahex/route/RouteMetrics.h"

#include "support/AsciiWorld.h"
#include "support/LatticeKinds.h"
#include "support/Random.h"

#include <seahex/geometry/LatticeNorm.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace seahex
{
namespace
{

using test::AsciiWorld;

const AsciiWorld &openWater()
{
    static const AsciiWorld world(R"(
         . . . . . . . .
        . . . . . . . .
         . . . . . . . .
        . . . . . . . .
         . . . . . . . .
    )",
                                  10.0);
    return world;
}

Point centre(std::int64_t column, std::int64_t row)
{
    return openWater().lattice().centre(toCube({column, row}));
}

TEST(RouteMetrics, countsLengthInCellsAndSteps)
{
    // three steps east, two steps to the south-east
    const Route route({centre(0, 0), centre(3, 0), centre(4, 2)});
    const RouteMetrics metrics = measureRoute(route, openWater().occupancy(), CountedLegs::All);
    EXPECT_NEAR(metrics.lengthCells, 5.0, 1e-12);
    EXPECT_NEAR(metrics.lengthLattice, 5.0, 1e-12);
    EXPECT_EQ(metrics.turns, 1);
    EXPECT_NEAR(metrics.turnAngleDeg(), 60.0, 1e-9);
    EXPECT_EQ(metrics.potentialHazards, 0);
}

TEST(RouteMetrics, leavesTheLegsToStartAndGoalOut)
{
    const Route route({centre(0, 0) + Point(3, 4), centre(0, 0), centre(3, 0), centre(3, 0) + Point(1, -4)});
    const RouteMetrics metrics = measureRoute(route, openWater().occupancy(), CountedLegs::BetweenCentres);
    EXPECT_EQ(metrics.turns, 0);
    EXPECT_NEAR(metrics.lengthLattice, 3.0, 1e-12);
    EXPECT_NEAR(metrics.lengthCells, (30.0 + 5.0 + std::sqrt(17.0)) / 10.0, 1e-12);
    EXPECT_EQ(measureRoute(route, openWater().occupancy(), CountedLegs::All).turns, 2);
}

TEST(RouteMetrics, mergesCollinearLegsAndSkipsEmptyOnes)
{
    const Route route({centre(0, 0), centre(1, 0), centre(1, 0), centre(3, 0), centre(5, 0)});
    EXPECT_EQ(measureRoute(route, openWater().occupancy(), CountedLegs::All).turns, 0);
}

TEST(RouteMetrics, seesASlowBend)
{
    // a hundred turns, each below the least one that counts: together they are a turn
    std::vector<Point> points = {Point(100, -100)};
    double heading = 0.0;
    for (int i = 0; i < 100; ++i, heading += 5e-7)
        points.push_back(points.back() + 0.01 * Point(std::cos(heading), std::sin(heading)));
    const RouteMetrics metrics = measureRoute(Route(points), openWater().occupancy(), CountedLegs::All);
    EXPECT_GT(metrics.turns, 0);
    EXPECT_NEAR(metrics.turnAngleRad, 99 * 5e-7, 2e-6);
}

TEST(RouteMetrics, takesAboutTurnAsHalfACircle)
{
    const Route route({centre(0, 0), centre(3, 0), centre(1, 0)});
    const RouteMetrics metrics = measureRoute(route, openWater().occupancy(), CountedLegs::All);
    EXPECT_EQ(metrics.turns, 1);
    EXPECT_NEAR(metrics.turnAngleDeg(), 180.0, 1e-9);
}

TEST(RouteMetrics, countsEachPotentialHazardOnce)
{
    const AsciiWorld world(R"(
         . # # . . #
        A . . . B .
         . . # . . .
        # . . . . .
    )");
    const Route route({world.centre('A'), world.centre('B')});
    // the two of the first row, and the one below; the others are not next to a cell that the route touches
    EXPECT_EQ(measureRoute(route, world.occupancy(), CountedLegs::All).potentialHazards, 3);
    const Route again({world.centre('A'), world.centre('B'), world.centre('A')});
    EXPECT_EQ(measureRoute(again, world.occupancy(), CountedLegs::All).potentialHazards, 3);
}

TEST(RouteMetrics, isEmptyForAnEmptyRoute)
{
    const RouteMetrics metrics = measureRoute(Route(), openWater().occupancy(), CountedLegs::BetweenCentres);
    EXPECT_EQ(metrics.turns, 0);
    EXPECT_EQ(metrics.lengthCells, 0.0);
    EXPECT_EQ(metrics.lengthLattice, 0.0);
}

TEST(RouteMetrics, countsOctileStepsOnSquares)
{
    const test::SquareWorld world(R"(
        A . . B . . .
        . . . . . . .
        . . . . . C .
        . . . . . D .
        . . . . . . .
    )",
                                  10.0, Point(-30.0, 70.0));
    const Route route({world.centre('A'), world.centre('B'), world.centre('C'), world.centre('D')});
    const double length = 3.0 + 2.0 * std::sqrt(2.0) + 1.0;
    const RouteMetrics all = measureRoute(route, world.occupancy(), CountedLegs::All);
    EXPECT_NEAR(all.lengthCells, length, 1e-12);
    EXPECT_NEAR(all.lengthLattice, length, 1e-12);
    EXPECT_EQ(all.turns, 2);
    EXPECT_NEAR(all.turnAngleDeg(), 90.0, 1e-9);
    const RouteMetrics inner = measureRoute(route, world.occupancy(), CountedLegs::BetweenCentres);
    EXPECT_NEAR(inner.lengthLattice, 2.0 * std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(inner.lengthCells, length, 1e-12);
    EXPECT_EQ(inner.turns, 0);
    // a leg that is no step: 5 columns and 2 rows are 3 level and 2 diagonal steps
    const Route straight({world.centre('A'), world.centre('C')});
    EXPECT_NEAR(measureRoute(straight, world.occupancy(), CountedLegs::All).lengthLattice, 3.0 + 2.0 * std::sqrt(2.0),
                1e-12);
    EXPECT_NEAR(measureRoute(straight, world.occupancy(), CountedLegs::All).lengthCells, std::sqrt(29.0), 1e-12);
}

TEST(RouteMetrics, potentialHazardsOfSquaresAreTheEightAround)
{
    const test::SquareWorld world(R"(
        # . # . . #
        . A B . # .
        # . . C . .
        . # . . . #
    )");
    const auto hazards = [&world](const std::vector<Point> &points)
    {
        return measureRoute(Route(points), world.occupancy(), CountedLegs::All).potentialHazards;
    };
    // two over A's corners to the north-west and south-west, the third beside B
    EXPECT_EQ(hazards({world.centre('A'), world.centre('B')}), 3);
    // the diagonal step touches the two cells beside it; of their neighbours (4, 1) is one, and the one below (2, 2)
    EXPECT_EQ(hazards({world.centre('B'), world.centre('C')}), 3);
    EXPECT_EQ(hazards({world.centre('A'), world.centre('B'), world.centre('C')}), 5);
}

template <class LatticeType>
class RouteMetricsOf : public ::testing::Test
{
};

TYPED_TEST_SUITE(RouteMetricsOf, test::LatticeKinds, test::LatticeKindNames);

TYPED_TEST(RouteMetricsOf, equalBruteForceOnRoutesOfCentres)
{
    using Cell = typename TypeParam::Cell;
    // the farthest that centres of cells that touch are apart, in pitches, and a little more
    const double reach = test::cellsAtCorner<TypeParam> == 3 ? 1.01 : 1.42;
    test::forEachSeed(
        300,
        [&](test::Random &random)
        {
            const TypeParam lattice(Point(random.real(-50, 50), random.real(-50, 50)), random.real(0.2, 20.0),
                                    random.integer(2, 14), random.integer(2, 14));
            const auto occupancy = test::randomOccupancy(random, lattice, random.real(0.0, 0.6));
            std::vector<Cell> cells = {random.cellOf(lattice)};
            for (std::int64_t legs = random.integer(1, 4); legs > 0;)
            {
                const Cell next = random.cellOf(lattice);
                if (next == cells.back())
                    continue;
                cells.push_back(next);
                --legs;
            }
            std::vector<Point> points;
            for (const Cell cell : cells)
                points.push_back(lattice.centre(cell));
            const RouteMetrics metrics = measureRoute(Route(points), *occupancy, CountedLegs::All);

            std::int64_t hazards = 0;
            test::forEachCell(lattice, 0,
                              [&](Cell rock)
                              {
                                  bool isBeside = false;
                                  test::forEachCell(lattice, 0,
                                                    [&](Cell cell)
                                                    {
                                                        const double apart =
                                                            (lattice.centre(cell) - lattice.centre(rock)).norm();
                                                        if (cell == rock || apart > reach * lattice.pitch())
                                                            return;
                                                        for (std::size_t i = 1; i < cells.size(); ++i)
                                                            isBeside = isBeside || test::touchesExactly<std::int64_t>(
                                                                                       cells[i - 1], cells[i], cell);
                                                    });
                                  hazards += occupancy->isBlocked(rock) && isBeside ? 1 : 0;
                              });
            ASSERT_EQ(metrics.potentialHazards, hazards) << test::toPicture(*occupancy, cells);

            double length = 0.0;
            double steps = 0.0;
            int turns = 0;
            double angle = 0.0;
            for (std::size_t i = 1; i < points.size(); ++i)
            {
                const Point leg = points[i] - points[i - 1];
                length += leg.norm();
                steps += latticeDistance(toOffset(cells[i - 1]), toOffset(cells[i]), lattice);
                if (i == 1)
                    continue;
                const Point before = points[i - 1] - points[i - 2];
                const double turn = std::acos(std::clamp(leg.dot(before) / (leg.norm() * before.norm()), -1.0, 1.0));
                turns += turn > 1e-5 ? 1 : 0;
                angle += turn > 1e-5 ? turn : 0.0;
            }
            ASSERT_NEAR(metrics.lengthCells, length / lattice.pitch(), 1e-9);
            ASSERT_NEAR(metrics.lengthLattice, steps, 1e-9);
            ASSERT_EQ(metrics.turns, turns);
            ASSERT_NEAR(metrics.turnAngleRad, angle, 1e-6);
        });
}

}  // namespace
}  // namespace seahex
