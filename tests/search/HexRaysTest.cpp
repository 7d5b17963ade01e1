// HexRays against a walk from cell to cell.

#include <seahex/search/HexRays.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/Random.h"

#include <array>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// A sixth of a turn counter-clockwise: (q, r, s) becomes (-r, -s, -q).
HexCoord turned(HexCoord step)
{
    return {-step.r(), -step.q};
}

HexCoord turned(HexCoord step, int sixths)
{
    for (; sixths > 0; --sixths)
        step = turned(step);
    return step;
}

/// Has a ray just passed the end of an obstacle here?
bool isTurn(const HexOccupancy &occupancy, HexCoord cell, HexCoord step)
{
    const auto passes = [&](int ahead, int behind)
    {
        return occupancy.isFree(cell + turned(step, ahead)) && occupancy.isBlocked(cell + turned(step, behind));
    };
    return occupancy.isFree(cell) && (passes(1, 2) || passes(5, 4));
}

void expectRays(const HexOccupancy &occupancy)
{
    const HexRays rays(occupancy);
    forEachCell(occupancy.lattice(), 1,
                [&](HexCoord cell)
                {
                    for (unsigned int d = 0; d < HexRays::directions; ++d)
                    {
                        ASSERT_EQ(rays.isBlocked(d, rays.address(d, cell)), occupancy.isBlocked(cell));
                        for (int sixths = 0; sixths < 6; ++sixths)
                        {
                            const HexCoord step = turned({1, 0}, sixths);
                            ASSERT_EQ(rays.address(d, cell) + rays.delta(d, step), rays.address(d, cell + step));
                        }
                        if (occupancy.isBlocked(cell))
                            continue;
                        const HexCoord step = HexRays::steps[d];
                        std::int64_t distance = 1;
                        while (occupancy.isFree(cell + distance * step) &&
                               !isTurn(occupancy, cell + distance * step, step))
                            ++distance;
                        const HexRays::Stop stop = rays.firstStop(d, rays.address(d, cell));
                        ASSERT_EQ(stop.distance, distance) << "direction " << d;
                        ASSERT_EQ(stop.isTurn, occupancy.isFree(cell + distance * step)) << "direction " << d;
                    }
                });
}

}  // namespace

TEST(HexRays, GoEverySecondWay)
{
    EXPECT_EQ(HexRays::steps[1], turned(HexRays::steps[0], 2));
    EXPECT_EQ(HexRays::steps[2], turned(HexRays::steps[1], 2));
}

TEST(HexRays, EndWhereAWalkEnds)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const HexLattice lattice(Point::Zero(), 1.0, random.integer(1, 150), random.integer(1, 150));
                    const double density = random.chance(0.5) ? random.real(0.0, 0.02) : random.real(0.0, 1.0);
                    expectRays(*randomOccupancy(random, lattice, density));
                });
}

TEST(HexRays, EndAtTheEdgesOfLatticesOfAnySize)
{
    Random random(4);
    constexpr std::array<std::int64_t, 14> sizes = {1, 2, 3, 57, 58, 59, 60, 61, 62, 63, 64, 65, 127, 130};
    for (const std::int64_t size : sizes)
        for (const std::int64_t other : {1, 2, 7})
        {
            expectRays(*randomOccupancy(random, HexLattice(Point::Zero(), 1.0, size, other), 0.1));
            expectRays(*randomOccupancy(random, HexLattice(Point::Zero(), 1.0, other, size), 0.1));
            expectRays(*randomOccupancy(random, HexLattice(Point::Zero(), 1.0, size, other), 0.0));
            expectRays(*randomOccupancy(random, HexLattice(Point::Zero(), 1.0, other, size), 0.0));
        }
}
