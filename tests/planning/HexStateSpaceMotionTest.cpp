#include <seahex/planning/HexStateSpace.h>

#include "planning/HexStates.h"
#include "support/HexOracle.h"
#include "support/Property.h"
#include "support/Random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <tuple>

namespace seahex::test
{
namespace
{

HexCoord between(const std::shared_ptr<HexStateSpace> &space, HexCoord a, HexCoord b, double t)
{
    CellState state(space);
    space->interpolate(stateOf(space, a).get(), stateOf(space, b).get(), t, state.get());
    return state->cell();
}

std::int64_t square(std::int64_t q, std::int64_t s)
{
    return q * q + q * s + s * s;
}

/// The rule about ties by brute force over all cells, in eighths of a cell: nearest, in the lattice, smallest.
HexCoord nearestInEighths(const HexLattice &lattice, HexCoord a, HexCoord b, std::int64_t eighths)
{
    const HexCoord point = 8 * a + eighths * (b - a);
    HexCoord best = a;
    const auto rank = [&](HexCoord cell)
    {
        return std::tuple(square(8 * cell.q - point.q, 8 * cell.s - point.s), !lattice.contains(cell), cell.s, cell.q);
    };
    forEachCell(lattice, 2,
                [&](HexCoord cell)
                {
                    if (rank(cell) < rank(best))
                        best = cell;
                });
    return best;
}

TEST(HexStateSpaceMotion, InterpolatesToTheNearestCentreAndItsTiesAreTheLattices)
{
    for (const auto &[columns, rows] : {std::pair{4, 5}, {3, 6}, {1, 7}, {6, 1}})
    {
        const auto space = spaceOf(columns, rows);
        int outside = 0;
        forEachCell(space->lattice(), 0,
                    [&](HexCoord a)
                    {
                        forEachCell(space->lattice(), 0,
                                    [&](HexCoord b)
                                    {
                                        for (int i = 0; i <= 8; ++i)
                                        {
                                            const HexCoord cell = between(space, a, b, i / 8.0);
                                            ASSERT_EQ(cell, nearestInEighths(space->lattice(), a, b, i));
                                            outside += space->lattice().contains(cell) ? 0 : 1;
                                        }
                                    });
                    });
        EXPECT_EQ(outside, 0);
    }
}

TEST(HexStateSpaceMotion, InterpolationIsTheSameFromBothEndsAndStaysInBounds)
{
    checkProperty(400,
                  [](std::uint64_t seed)
                  {
                      Random random(seed);
                      const std::int64_t most = random.chance(0.5) ? 9 : 5000000;
                      const std::int64_t columns = random.integer(1, most);
                      const auto space = spaceOf(columns, random.integer(1, most), random.real(1e-3, 300.0),
                                                 Point(random.real(-1e5, 1e5), random.real(-1e5, 1e5)));
                      const HexOracle oracle(space->lattice());
                      for (int i = 0; i < 40; ++i)
                      {
                          const HexCoord a = random.cellOf(space->lattice());
                          const HexCoord b = random.cellOf(space->lattice());
                          const double t =
                              random.chance(0.5) ? random.unit() : static_cast<double>(random.integer(0, 12)) / 12.0;
                          const HexCoord cell = between(space, a, b, t);
                          RC_ASSERT(cell == between(space, b, a, 1.0 - t));
                          RC_ASSERT(space->lattice().contains(cell));
                          const HexOracle::Vector from = oracle.centre(a);
                          const HexOracle::Vector to = oracle.centre(b);
                          const HexOracle::Vector found = oracle.centre(cell);
                          const long double off = std::hypot(from.x + t * (to.x - from.x) - found.x,
                                                             from.y + t * (to.y - from.y) - found.y);
                          RC_ASSERT(off <= space->lattice().pitch() / std::sqrt(3.0L) * (1 + 1e-6L));
                      }
                  });
}

TEST(HexStateSpaceMotion, InterpolationNeedsNoFractionOfTheLine)
{
    const auto space = spaceOf(9, 9);
    const HexCoord a = toCube({1, 2});
    const HexCoord b = toCube({7, 7});
    for (const double t : {-1.0, -1e300, -0.0, 1e-320, std::nan("")})
        EXPECT_EQ(between(space, a, b, t), a) << t;
    for (const double t : {1.0, 1.5, 1e300, std::numeric_limits<double>::infinity()})
        EXPECT_EQ(between(space, a, b, t), b) << t;
}

TEST(HexStateSpaceMotion, CellsFarOutDoNoHarm)
{
    const auto space = spaceOf(3, 4);
    constexpr std::int64_t farthest = std::int64_t{1} << 60;
    for (const HexCoord cell : {HexCoord{farthest, farthest}, HexCoord{-farthest, farthest},
                                HexCoord{farthest, -farthest}, HexCoord{-farthest, -farthest}})
    {
        const auto state = stateOf(space, cell);
        const auto origin = stateOf(space, HexCoord{});
        EXPECT_FALSE(space->satisfiesBounds(state.get()));
        EXPECT_GT(space->distance(state.get(), origin.get()), 1e18);
        EXPECT_EQ(space->validSegmentCount(state.get(), origin.get()),
                  static_cast<unsigned int>(std::numeric_limits<int>::max()));
        EXPECT_EQ(between(space, cell, HexCoord{}, 0.5), (HexCoord{cell.q / 2, cell.s / 2}));
        EXPECT_EQ(between(space, cell, -1 * cell, 0.5), HexCoord{});
        auto enforced = stateOf(space, cell);
        space->enforceBounds(enforced.get());
        EXPECT_TRUE(space->satisfiesBounds(enforced.get()));
    }
}

TEST(HexStateSpaceMotion, ItsExtentIsTheGreatestDistance)
{
    for (std::int64_t columns = 1; columns <= 9; ++columns)
        for (std::int64_t rows = 1; rows <= 9; ++rows)
        {
            const auto space = spaceOf(columns, rows, 2.5);
            std::int64_t most = 0;
            forEachCell(space->lattice(), 0,
                        [&](HexCoord a) {
                            forEachCell(space->lattice(), 0,
                                        [&](HexCoord b) { most = std::max(most, square(b.q - a.q, b.s - a.s)); });
                        });
            const double extent = 2.5 * (most == 0 ? 1.0 : std::sqrt(static_cast<double>(most)));
            EXPECT_NEAR(space->getMaximumExtent(), extent, 1e-9 * extent) << columns << " x " << rows;
        }
}

TEST(HexStateSpaceMotion, DistancesAreEuclideanToABillionthAndNeverMore)
{
    Random random(21);
    for (int i = 0; i < 300; ++i)
    {
        const std::int64_t most = random.chance(0.5) ? 12 : 700000;
        const auto space = spaceOf(most, most, random.chance(0.3) ? 1.0 : random.real(1e-4, 400.0));
        const HexOracle oracle(space->lattice());
        const HexCoord a = random.cellOf(space->lattice());
        const HexCoord b = random.cellOf(space->lattice());
        const HexOracle::Vector from = oracle.centre(a);
        const HexOracle::Vector to = oracle.centre(b);
        const long double euclidean = std::hypot(to.x - from.x, to.y - from.y);
        const long double distance = space->distance(stateOf(space, a).get(), stateOf(space, b).get());
        EXPECT_LE(distance, euclidean * (1 - 0x1p-32L));
        EXPECT_GE(distance, euclidean * (1 - 0x1p-29L));
    }
}

TEST(HexStateSpaceMotion, DistancesAddExactlyAndNoWayRoundIsShorter)
{
    checkProperty(200,
                  [](std::uint64_t seed)
                  {
                      Random random(seed);
                      const std::int64_t most = random.chance(0.5) ? 27 : 200000;
                      const auto space = spaceOf(most, most, random.chance(0.3) ? 1.0 : random.real(1e-4, 400.0));
                      const auto distance = [&space](HexCoord a, HexCoord b)
                      {
                          return space->distance(stateOf(space, a).get(), stateOf(space, b).get());
                      };
                      for (int i = 0; i < 300; ++i)
                      {
                          const HexCoord a = random.cellOf(space->lattice());
                          const HexCoord b = random.cellOf(space->lattice());
                          // a cell anywhere, or one on the very line, where there is no margin
                          const HexCoord step = random.cellOf(HexLattice(Point(0, 0), 1.0, most / 9, most / 9));
                          const HexCoord c =
                              random.chance(0.3) ? random.cellOf(space->lattice()) : a + random.integer(1, 5) * step;
                          const HexCoord end = random.chance(0.3) ? b : c + random.integer(1, 5) * step;
                          const double x = distance(a, c);
                          const double y = distance(c, end);
                          const double z = distance(a, b);
                          RC_ASSERT(distance(a, end) <= x + y);
                          RC_ASSERT((x + y) + z == x + (y + z));
                          RC_ASSERT((x + y) - y == x);
                      }
                  });
}

TEST(HexStateSpaceMotion, LooksAtAMotionOnceAStep)
{
    const auto space = spaceOf(120, 80, 3.0);
    space->setup();
    EXPECT_NEAR(space->getLongestValidSegmentLength(), 3.0, 1e-8);
    Random random(4);
    for (int i = 0; i < 200; ++i)
    {
        const HexCoord a = random.cellOf(space->lattice());
        const HexCoord b = random.chance(0.1) ? a : random.cellOf(space->lattice());
        for (const unsigned int factor : {1U, 3U})
        {
            space->setValidSegmentCountFactor(factor);
            const auto steps = static_cast<unsigned int>(hexDistance(a, b));
            EXPECT_EQ(space->validSegmentCount(stateOf(space, a).get(), stateOf(space, b).get()),
                      a == b ? 1U : factor * steps);
        }
        // one step a segment: neighbouring cells, none left out
        const std::int64_t steps = hexDistance(a, b);
        HexCoord last = a;
        for (std::int64_t step = 1; step <= steps; ++step)
        {
            const HexCoord cell = between(space, a, b, static_cast<double>(step) / static_cast<double>(steps));
            EXPECT_EQ(hexDistance(last, cell), 1);
            EXPECT_EQ(hexDistance(a, cell), step);
            last = cell;
        }
    }
}

}  // namespace
}  // namespace seahex::test
