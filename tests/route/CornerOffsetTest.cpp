#include "support/AsciiWorld.h"
#include "support/Random.h"

#include <seahex/geometry/SegmentSpans.h>
#include <seahex/route/CornerOffset.h>
#include <seahex/search/TautSearch.h>
#include <seahex/world/SegmentValidity.h>

#include <gtest/gtest.h>

namespace seahex::test
{
namespace
{

void expectFree(const Route &route, const HexOccupancy &occupancy)
{
    for (std::size_t i = 0; i < route.legCount(); ++i)
        EXPECT_TRUE(isFree(occupancy, route.leg(i).from, route.leg(i).to)) << "leg " << i;
}

TEST(CornerOffset, MovesACornerStraightAwayFromItsCell)
{
    const AsciiWorld world(R"(
         . . . . .
        . . # . .
         . . . . .
    )");
    const HexCoord blocked = toCube({2, 1});
    const Point centre = world.lattice().centre(blocked);
    for (const Point &corner : world.lattice().corners(blocked))
    {
        // along the tangent, there and back
        const Point away = (corner - centre).normalized();
        const Point along(-away.y(), away.x());
        const Route taut({corner - 0.5 * along, corner, corner + 0.5 * along});
        const auto route = offsetFromCorners(taut, world.occupancy());
        ASSERT_TRUE(route);
        ASSERT_EQ(route->waypoints().size(), 3U);
        const Point moved = route->waypoints()[1] - corner;
        EXPECT_NEAR(moved.norm(), 1e-6, 1e-12);
        EXPECT_NEAR(moved.dot(away), 1e-6, 1e-12);
        expectFree(*route, world.occupancy());
    }
}

TEST(CornerOffset, BendsAtCornersThatAreGrazedOnBothSides)
{
    // The upright line through the west sides of the left cells and the east sides of the right ones.
    const AsciiWorld world(R"(
         . . . . .
        . . # . .
         . . . . .
        . # . . .
         . . . . .
        . . # . .
         . . . . .
    )");
    const auto corners = world.lattice().corners(toCube({2, 1}));
    const Point top = corners[1] + Point(0.0, 1.0);
    const Point bottom = world.lattice().corners(toCube({2, 5}))[2] - Point(0.0, 1.0);
    ASSERT_NEAR(top.x(), bottom.x(), 1e-12);
    ASSERT_TRUE(isFree(world.occupancy(), top, top) && isFree(world.occupancy(), bottom, bottom));
    ASSERT_FALSE(isFree(world.occupancy(), top, bottom));
    const auto route = offsetFromCorners(Route({top, bottom}), world.occupancy());
    ASSERT_TRUE(route);
    EXPECT_GE(route->waypoints().size(), 5U);
    expectFree(*route, world.occupancy());
    EXPECT_NEAR(route->length(), (top - bottom).norm(), 1e-10);
}

TEST(CornerOffset, BendsAtCornersThatOnlyAMovedLegTouches)
{
    // The route touches the eastern cell's lower shoulder and passes the western cell's upper one at a fifth of a
    // millionth; moved off the first, it meets the second.
    const AsciiWorld world(R"(
         . . . . .
        . . # . .
         . . . . .
        . # . . .
         . . . . .
    )");
    const Point shoulder = world.lattice().corners(toCube({2, 1}))[2];
    const Point passed = world.lattice().corners(toCube({1, 3}))[5];
    ASSERT_NEAR(shoulder.x(), passed.x(), 1e-12);
    const Point down(2e-7 / (shoulder.y() - passed.y()), -1.0);
    const Point top = shoulder - 1.2 * down;
    const Point bottom = shoulder + 2.5 * down;
    ASSERT_FALSE(isFree(world.occupancy(), top, bottom));
    ASSERT_TRUE(isFree(world.occupancy(), shoulder + 0.1 * down, bottom));
    for (const Route &taut : {Route({top, bottom}), Route({bottom, top})})
    {
        const auto route = offsetFromCorners(taut, world.occupancy());
        ASSERT_TRUE(route);
        EXPECT_GE(route->waypoints().size(), 4U);
        expectFree(*route, world.occupancy());
    }
}

TEST(CornerOffset, LeavesAFreeRouteAlone)
{
    const AsciiWorld world(R"(
         A . #
        . . .
         . B .
    )");
    const Route free({world.centre('A'), world.centre('B')});
    const auto route = offsetFromCorners(free, world.occupancy());
    ASSERT_TRUE(route);
    EXPECT_EQ(route->waypoints(), free.waypoints());
    EXPECT_TRUE(offsetFromCorners(Route(), world.occupancy())->empty());
}

TEST(CornerOffset, RefusesARouteThroughABlockedCell)
{
    const AsciiWorld world(R"(
         A # B
        . # .
         . . .
    )");
    EXPECT_FALSE(
        offsetFromCorners(Route({world.centre('A'), world.lattice().centre(toCube({1, 0}))}), world.occupancy()));
}

TEST(CornerOffset, IsValidFarFromTheOrigin)
{
    // a thousand kilometres away, where positions are exact to a millimetre only
    forEachSeed(100,
                [](Random &random)
                {
                    const HexLattice lattice(Point(random.real(-1e6, 1e6), 1e6), 1.0, 12, 12);
                    const auto world = randomOccupancy(random, lattice, 0.3);
                    const auto freeCentre = [&]
                    {
                        while (true)
                        {
                            const HexCoord cell = random.cellOf(lattice);
                            if (world->isFree(cell))
                                return lattice.centre(cell);
                        }
                    };
                    TautSearch search(*world);
                    const Point start = freeCentre();
                    search.begin(start, freeCentre());
                    if (search.run([] { return false; }, 100) != SearchStatus::Found)
                        return;
                    const Route taut(search.path());
                    const auto route = offsetFromCorners(taut, *world);
                    ASSERT_TRUE(route);
                    expectFree(*route, *world);
                    const double offset = cornerOffset(*world, taut);
                    EXPECT_GE(offset, 4e-3);
                    EXPECT_LE(route->length(), taut.length() + offset * static_cast<double>(route->waypoints().size()));
                });
}

}  // namespace
}  // namespace seahex::test
