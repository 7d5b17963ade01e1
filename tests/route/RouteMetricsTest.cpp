#include "seahex/route/RouteMetrics.h"

#include "support/AsciiWorld.h"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace seahex
