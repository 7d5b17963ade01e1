#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/HexRing.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

using namespace seahex;

TEST(HexRing, holdsEveryCellWithinReachOnce)
{
    for (const int rings : {1, 2, 3})
    {
        std::set<HexCoord> expected;
        for (std::int64_t q = -4; q <= 4; ++q)
            for (std::int64_t s = -4; s <= 4; ++s)
                if (hexNorm({q, s}) >= 1 && hexNorm({q, s}) <= rings)
                    expected.insert({q, s});
        std::set<HexCoord> found;
        for (const RingOffset &jump : ringOffsets(rings))
        {
            EXPECT_TRUE(found.insert(jump.offset).second) << "twice: " << jump.offset.q << ", " << jump.offset.s;
            EXPECT_EQ(jump.ring, hexNorm(jump.offset));
        }
        EXPECT_EQ(found, expected);
        EXPECT_EQ(ringOffsets(rings).size(), static_cast<std::size_t>(3 * rings * (rings + 1)));
    }
}

TEST(HexRing, primitiveJumpsPassNoCentre)
{
    const std::size_t expectedCount[] = {6, 12, 24};
    for (const int rings : {1, 2, 3})
    {
        std::size_t primitive = 0;
        for (const RingOffset &jump : ringOffsets(rings))
        {
            // a centre on the way divides the jump into 2 or 3 equal parts
            const bool halved = jump.offset.q % 2 == 0 && jump.offset.s % 2 == 0;
            const bool inThirds = jump.offset.q % 3 == 0 && jump.offset.s % 3 == 0;
            EXPECT_EQ(jump.primitive, !halved && !inThirds) << jump.offset.q << ", " << jump.offset.s;
            primitive += jump.primitive ? 1 : 0;
        }
        EXPECT_EQ(primitive, expectedCount[rings - 1]);
    }
}

TEST(HexRing, sortedByRingThenCounterClockwiseFromEast)
{
    const HexLattice lattice(Point::Zero(), 1.0, 1, 1);
    int ring = 0;
    double angle = 0.0;
    for (const RingOffset &jump : ringOffsets(3))
    {
        const Point along = lattice.centre(jump.offset) - lattice.centre({0, 0});
        // rounded, so that due east is 0 and not almost a full turn
        const double turned = std::fmod(std::atan2(along.y(), along.x()) + 2 * M_PI + 1e-9, 2 * M_PI);
        if (jump.ring != ring)
        {
            EXPECT_EQ(jump.ring, ring + 1);
            EXPECT_LT(turned, 1e-6) << "a ring begins in the east";
        }
        else
            EXPECT_GT(turned, angle) << jump.offset.q << ", " << jump.offset.s;
        ring = jump.ring;
        angle = turned;
    }
    EXPECT_EQ(ring, 3);
}

TEST(HexRing, refusesOtherCounts)
{
    EXPECT_THROW(ringOffsets(0), std::domain_error);
    EXPECT_THROW(ringOffsets(4), std::domain_error);
    EXPECT_THROW(ringOffsets(-1), std::domain_error);
}
