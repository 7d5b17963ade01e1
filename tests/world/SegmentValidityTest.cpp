#include <seahex/world/SegmentValidity.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
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

/// Distance from a segment to the nearest cell that is not free, those around the lattice included.
long double distanceToBlocked(const HexOccupancy &occupancy, const Point &a, const Point &b)
{
    const HexOracle oracle(occupancy.lattice());
    long double least = std::numeric_limits<long double>::infinity();
    forEachCell(occupancy.lattice(), 1,
                [&](HexCoord cell)
                {
                    if (occupancy.isBlocked(cell))
                        least = std::min(least, oracle.distance(a, b, cell));
                });
    return least;
}

double toleranceOf(const HexLattice &lattice, const Point &a, const Point &b)
{
    return 1e-9 * std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), lattice.northWest().cwiseAbs().maxCoeff(),
                            lattice.pitch()});
}

HexLattice anyLattice(Random &random)
{
    const double pitch = std::pow(10.0, random.real(-2.0, 2.0));
    return {pitch * random.pointIn({Point(-9, -9), Point(9, 9)}), pitch, random.integer(1, 20), random.integer(1, 12)};
}

}  // namespace

TEST(SegmentValidity, freeMeansThatNoBlockedCellIsTouched)
{
    int free = 0;
    int blocked = 0;
    for (std::uint64_t seed = 1; seed <= 1500; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const auto occupancy = randomOccupancy(random, anyLattice(random), random.real(0.0, 0.3));
        const HexLattice &lattice = occupancy->lattice();
        for (int i = 0; i < 10; ++i)
        {
            const Point a = random.pointOf(lattice, random.cellOf(lattice));
            Point b = random.pointOf(lattice, random.cellOf(lattice));
            if (i == 0)
                b = a;
            if (i == 1)
                b = a + lattice.pitch() * random.pointIn({Point(-30, -30), Point(30, 30)});  // perhaps outside
            const bool answer = isFree(*occupancy, a, b);
            const long double distance = distanceToBlocked(*occupancy, a, b);
            if (answer)
                ASSERT_GT(distance, 0.0L) << a.transpose() << " to " << b.transpose() << toPicture(*occupancy);
            else
                ASSERT_LE(distance, toleranceOf(lattice, a, b))
                    << a.transpose() << " to " << b.transpose() << toPicture(*occupancy);
            ASSERT_EQ(isFree(*occupancy, b, a), answer) << "backwards";
            (answer ? free : blocked) += 1;
        }
    }
    EXPECT_GT(free, 1000) << "the test saw too few free segments to mean something";
    EXPECT_GT(blocked, 1000);
}

TEST(SegmentValidity, cornersAreNotCut)
{
    // From A to B the straight line runs along the edge between two cells, to C through a corner of a rock.
    const AsciiWorld open(R"(
         . A . .
        . . . .
         . B . .
    )");
    const AsciiWorld oneSide(R"(
         . A . .
        . # . .
         . B . .
    )");
    const AsciiWorld corner(R"(
         . A . # .
        . . . . .
         . . . C .
    )");
    EXPECT_TRUE(isFree(open.occupancy(), open.centre('A'), open.centre('B')));
    EXPECT_FALSE(isFree(oneSide.occupancy(), oneSide.centre('A'), oneSide.centre('B')));
    EXPECT_TRUE(isFree(corner.occupancy(), corner.centre('A'), corner.centre('C')));
    // due east past the southern tip of the rock: touching it, and a hair's breadth off
    const Point tip = corner.lattice().corners(toCube({3, 0}))[3];
    EXPECT_FALSE(isFree(corner.occupancy(), tip - Point(0.5, 0.0), tip + Point(0.5, 0.0)));
    EXPECT_TRUE(isFree(corner.occupancy(), tip - Point(0.5, 1e-6), tip + Point(0.5, -1e-6)));
}

TEST(SegmentValidity, aPointOnAnEdgeNeedsBothCells)
{
    const AsciiWorld world(R"(
         . A # .
        . . . .
    )");
    const auto corners = world.lattice().corners(world.cell('A'));
    const Point east = 0.5 * (corners[4] + corners[5]);
    const Point southWest = 0.5 * (corners[2] + corners[3]);
    EXPECT_FALSE(isFree(world.occupancy(), east, east));
    EXPECT_TRUE(isFree(world.occupancy(), southWest, southWest));
    EXPECT_TRUE(isFree(world.occupancy(), world.centre('A'), world.centre('A')));
    EXPECT_FALSE(isFree(world.occupancy(), corners[0], corners[0])) << "the border of the lattice touches the outside";
}

TEST(SegmentValidity, whatIsNoPositionIsNotFree)
{
    const auto occupancy = occupancyWith(HexLattice(Point::Zero(), 1.0, 9, 9), {});
    const Point inside(4.0, -4.0);
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    ASSERT_TRUE(isFree(*occupancy, inside, inside));
    for (const Point &p :
         {Point(notANumber, -4.0), Point(4.0, notANumber), Point(infinity, -4.0), Point(4.0, -infinity),
          Point(1e300, -4.0), Point(-4.0, 1e300), Point(1e19, 1e19), Point(1e9, -1e9)})
    {
        EXPECT_FALSE(isFree(*occupancy, p, p)) << p.transpose();
        EXPECT_FALSE(isFree(*occupancy, inside, p)) << p.transpose();
        EXPECT_FALSE(isFree(*occupancy, p, inside)) << p.transpose();
        EXPECT_FALSE(lastFree(*occupancy, p, inside).has_value()) << p.transpose();
    }
}

TEST(SegmentValidity, lastFreeGoesAsFarAsItCan)
{
    int stopped = 0;
    for (std::uint64_t seed = 1; seed <= 1500; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const auto occupancy = randomOccupancy(random, anyLattice(random), random.real(0.0, 0.3));
        const HexLattice &lattice = occupancy->lattice();
        for (int i = 0; i < 4; ++i)
        {
            const Point a = random.pointOf(lattice, random.cellOf(lattice));
            const Point b = i > 0 ? random.pointOf(lattice, random.cellOf(lattice))
                                  : Point(a + lattice.pitch() * random.pointIn({Point(-40, -40), Point(40, 40)}));
            const std::optional<double> last = lastFree(*occupancy, a, b);
            ASSERT_EQ(last.has_value(), isFree(*occupancy, a, a));
            if (!last)
                continue;
            ASSERT_GE(*last, 0.0);
            ASSERT_LE(*last, 1.0);
            ASSERT_EQ(*last == 1.0, isFree(*occupancy, a, b));
            const Point end = a + *last * (b - a);
            ASSERT_TRUE(isFree(*occupancy, a, end)) << "the prefix is free";
            ASSERT_GT(distanceToBlocked(*occupancy, a, end), 0.0L);
            if (*last == 1.0)
                continue;
            ++stopped;
            const Point beyond = a + std::min(1.0, *last + std::ldexp(1.0, -39)) * (b - a);
            ASSERT_LE(distanceToBlocked(*occupancy, a, beyond), toleranceOf(lattice, a, b))
                << "a little farther it is not";
        }
    }
    EXPECT_GT(stopped, 500);
}
