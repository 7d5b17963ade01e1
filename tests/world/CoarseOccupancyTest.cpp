// Large cells against the geometry of the fine ones.

#include <seahex/geometry/HexTraversal.h>
#include <seahex/world/CoarseOccupancy.h>

#include "support/CellOracle.h"
#include "support/Random.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// Do two closed convex polygons touch? By the separating axes of hexagons of one orientation, in the plane.
bool touch(const HexLattice &large, HexCoord a, const HexLattice &small, HexCoord b)
{
    const Point between = small.centre(b) - large.centre(a);
    const double reach = 0.5 * (large.pitch() + small.pitch());
    for (const Point &axis : {Point(1.0, 0.0), Point(0.5, std::sqrt(0.75)), Point(-0.5, std::sqrt(0.75))})
        if (std::abs(between.dot(axis)) > reach + 1e-9)
            return false;
    return true;
}

}  // namespace

TEST(CoarseOccupancy, isFreeWhereAllFineCellsThatTouchAreFree)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const HexLattice lattice(Point(3.0, -2.0), 0.5, random.integer(1, 90), random.integer(1, 40));
                    const auto fine =
                        randomOccupancy(random, lattice, random.chance(0.3) ? 0.0 : random.real(0.0, 0.1));
                    const CoarseOccupancy coarse(*fine, random.integer(2, 6));
                    const HexLattice &large = coarse.cells().lattice();
                    // the large cells, and one more around them, hold every fine cell
                    forEachCell(large, 1,
                                [&](HexCoord cell)
                                {
                                    bool isFree = true;
                                    const HexCoord middle = coarse.middle(cell);
                                    EXPECT_NEAR((large.centre(cell) - lattice.centre(middle)).norm(), 0.0, 1e-9);
                                    const std::int64_t reach = coarse.factor() + 2;
                                    for (std::int64_t q = -reach; q <= reach; ++q)
                                        for (std::int64_t s = -reach; s <= reach; ++s)
                                        {
                                            const HexCoord other = middle + HexCoord{q, s};
                                            if (touch(large, cell, lattice, other) && fine->isBlocked(other))
                                                isFree = false;
                                        }
                                    EXPECT_EQ(coarse.cells().isFree(cell), isFree);
                                });
                });
}

TEST(CoarseOccupancy, holdsEveryFineCentre)
{
    Random random(4);
    const HexLattice lattice(Point(3.0, -2.0), 0.5, 40, 40);
    const auto fine = randomOccupancy(random, lattice, 0.0);
    for (std::int64_t factor = 2; factor <= 9; ++factor)
    {
        const CoarseOccupancy coarse(*fine, factor);
        forEachCell(
            lattice, 0,
            [&](HexCoord cell)
            { EXPECT_NEAR(coarse.cells().lattice().distance(lattice.centre(cell), coarse.holding(cell)), 0.0, 1e-9); });
    }
}

TEST(CoarseOccupancy, levelsGrowUntilFewCellsAreLeft)
{
    Random random(4);
    const auto small = randomOccupancy(random, HexLattice(Point::Zero(), 1.0, 100, 100), 0.1);
    EXPECT_TRUE(coarseOccupancies(*small).empty());
    const auto wide = randomOccupancy(random, HexLattice(Point::Zero(), 1.0, 1400, 1100), 0.001);
    const auto levels = coarseOccupancies(*wide);
    ASSERT_EQ(levels.size(), 2U);
    EXPECT_EQ(levels[0]->factor(), 8);
    EXPECT_EQ(levels[1]->factor(), 16);
}
