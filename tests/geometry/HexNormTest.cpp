#include <seahex/geometry/HexNorm.h>
#include <seahex/geometry/HexRing.h>

#include "support/OpenWindow.h"
#include "support/Random.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

double euclideanLength(HexCoord d)
{
    const auto q = static_cast<double>(d.q);
    const auto s = static_cast<double>(d.s);
    return std::sqrt(q * q + q * s + s * s);
}

/// Least costs where no cell is blocked, jump by jump.
OpenWindow openWindow(int rings)
{
    std::vector<OpenWindow::Jump> jumps;
    for (const RingOffset &jump : ringOffsets(rings))
        jumps.push_back({jump.offset.q, jump.offset.s, euclideanLength(jump.offset)});
    return OpenWindow(jumps);
}

}  // namespace

TEST(HexNorm, ringNormIsTheCostOfTheCheapestChainOfJumps)
{
    for (const int rings : {1, 2, 3})
    {
        const OpenWindow window = openWindow(rings);
        for (std::int64_t q = -16; q <= 16; ++q)
            for (std::int64_t s = -16; s <= 16; ++s)
                ASSERT_NEAR(ringNorm(HexCoord{q, s}, rings), window.costTo(q, s), 1e-9)
                    << "rings " << rings << ", difference " << q << ", " << s;
    }
}

TEST(HexNorm, ringNormIsANorm)
{
    // With the triangle inequality, and no jump shorter than its norm, no chain of jumps beats it, however long.
    Random random(1);
    SCOPED_TRACE(random.seedText());
    for (const int rings : {1, 2, 3})
    {
        for (const RingOffset &jump : ringOffsets(rings))
            EXPECT_NEAR(ringNorm(jump.offset, rings), euclideanLength(jump.offset), 1e-12);
        for (int i = 0; i < 20000; ++i)
        {
            const std::int64_t size = i % 2 == 0 ? 5 : 1000000;
            const HexCoord u{random.integer(-size, size), random.integer(-size, size)};
            const HexCoord v{random.integer(-size, size), random.integer(-size, size)};
            const double sum = ringNorm(u, rings) + ringNorm(v, rings);
            ASSERT_LE(ringNorm(u + v, rings), sum * (1.0 + 1e-14)) << u.q << "," << u.s << " " << v.q << "," << v.s;
            ASSERT_NEAR(ringNorm(7 * u, rings), 7 * ringNorm(u, rings), 1e-9 * sum);
            ASSERT_EQ(ringNorm(-1 * u, rings), ringNorm(u, rings));
        }
    }
}

TEST(HexNorm, moreRingsComeCloserToTheStraightLine)
{
    Random random(2);
    SCOPED_TRACE(random.seedText());
    for (int i = 0; i < 1000; ++i)
    {
        const HexCoord d{random.integer(-50, 50), random.integer(-50, 50)};
        EXPECT_LE(ringNorm(d, 2), ringNorm(d, 1) + 1e-12);
        EXPECT_LE(ringNorm(d, 3), ringNorm(d, 2) + 1e-12);
        EXPECT_LE(euclideanLength(d), ringNorm(d, 3) + 1e-12);
        EXPECT_EQ(ringNorm(d, 1), static_cast<double>(hexNorm(d)));
    }
}

TEST(HexNorm, hexNormExtendsTheDistanceOfCells)
{
    const HexLattice lattice({300.0, -70.0}, 2.5, 10, 10);
    for (std::int64_t q = -12; q <= 12; ++q)
        for (std::int64_t s = -12; s <= 12; ++s)
        {
            const Point vector = lattice.centre({q + 4, s - 9}) - lattice.centre({4, -9});
            ASSERT_NEAR(hexNorm(vector, lattice), static_cast<double>(hexNorm(HexCoord{q, s})), 1e-9);
        }
}

TEST(HexNorm, hexNormIsANormOfThePlane)
{
    const HexLattice lattice({300.0, -70.0}, 2.5, 10, 10);
    Random random(3);
    SCOPED_TRACE(random.seedText());
    const Box box{Point(-90.0, -90.0), Point(90.0, 90.0)};
    for (int i = 0; i < 5000; ++i)
    {
        const Point u = random.pointIn(box);
        const Point v = random.pointIn(box);
        const double scale = random.real(-3.0, 3.0);
        ASSERT_LE(hexNorm(Point(u + v), lattice), hexNorm(u, lattice) + hexNorm(v, lattice) + 1e-12);
        ASSERT_NEAR(hexNorm(Point(scale * u), lattice), std::abs(scale) * hexNorm(u, lattice), 1e-9);
        // the unit ball is a hexagon between the circles of radius 1 and root 3 / 2 pitches
        ASSERT_GE(hexNorm(u, lattice), u.norm() / lattice.pitch() - 1e-12);
        ASSERT_LE(hexNorm(u, lattice), u.norm() / lattice.pitch() * 2.0 / std::sqrt(3.0) + 1e-12);
    }
}

TEST(HexNorm, vectorRingNormIsThatOfTheCellsBetween)
{
    const HexLattice lattice(Point(0, 0), 1.0, 1, 1);
    for (const int rings : {1, 2, 3})
        for (std::int64_t q = -12; q <= 12; ++q)
            for (std::int64_t s = -12; s <= 12; ++s)
            {
                const Point vector = lattice.centre({q, s}) - lattice.centre({0, 0});
                EXPECT_NEAR(vectorRingNorm(vector, rings), ringNorm(HexCoord{q, s}, rings), 1e-12);
                EXPECT_NEAR(vectorRingNorm(Point(0.37 * vector), rings), 0.37 * ringNorm(HexCoord{q, s}, rings), 1e-12);
            }
}
