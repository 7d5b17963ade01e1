#include <seahex/world/DiveArena.h>

#include "support/AsciiWorld.h"
#include "support/Seabeds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// 30 m of water everywhere, 10 by 10 m.
std::shared_ptr<const Bathymetry> basin()
{
    return std::make_shared<const Bathymetry>(NodeGrid(Point(0, 0), Point(5, 5), 3, 3), std::vector<float>(9, 30.0F));
}

DiveLimits limits(double clearanceM, double ceilingM, double deepestM = INFINITY)
{
    DiveLimits limits;
    limits.clearanceM = clearanceM;
    limits.ceilingM = ceilingM;
    limits.deepestM = deepestM;
    return limits;
}

}  // namespace

TEST(DiveArena, liesBetweenCeilingAndClearance)
{
    const DiveArena arena(basin(), limits(4.0, 2.0));
    EXPECT_FALSE(arena.isFree(Point3(5, 5, 1.9)));
    EXPECT_TRUE(arena.isFree(Point3(5, 5, 2.0)));
    EXPECT_TRUE(arena.isFree(Point3(5, 5, 26.0 - 2.0 * DiveArena::roundingM)));
    EXPECT_FALSE(arena.isFree(Point3(5, 5, 26.0))) << "the rounding is kept in hand";
    EXPECT_FALSE(arena.isFree(Point3(11, 5, 10.0)));
    EXPECT_FALSE(arena.isFree(Point3(5, 5, std::nan(""))));
    EXPECT_FALSE(arena.isFree(Point3(std::nan(""), 5, 5)));
    EXPECT_TRUE(arena.isFree(Point3(0, 0, 3), Point3(10, 10, 25)));
    EXPECT_FALSE(arena.isFree(Point3(0, 0, 1), Point3(10, 10, 25))) << "begins above the ceiling";
    EXPECT_FALSE(arena.isFree(Point3(0, 0, 3), Point3(10, 10, 27))) << "ends below the clearance";
    EXPECT_NEAR(arena.room(Point3(5, 5, 4)), 2.0, 1e-9);
    EXPECT_NEAR(arena.room(Point3(5, 5, 24)), 2.0 - DiveArena::roundingM, 1e-9);
    EXPECT_EQ(arena.lowest(), Point3(0, 0, 2));
    EXPECT_NEAR(arena.highest().z(), 26.0, 1e-3);
}

TEST(DiveArena, aVehicleBearsSoMuchDepth)
{
    const DiveArena arena(basin(), limits(4.0, 2.0, 12.0));
    EXPECT_TRUE(arena.isFree(Point3(5, 5, 12)));
    EXPECT_FALSE(arena.isFree(Point3(5, 5, 12.1)));
    EXPECT_FALSE(arena.isFree(Point3(0, 0, 3), Point3(10, 10, 12.1)));
    EXPECT_NEAR(arena.room(Point3(5, 5, 11)), 1.0, 1e-9);
    EXPECT_EQ(arena.highest(), Point3(10, 10, 12));
}

TEST(DiveArena, aColumnIsKeptOutOfAtEveryDepth)
{
    const AsciiWorld world(R"(
         . . . . .
        . . # . .
         . . . . .
        . . . . .
    )",
                           2.0, Point(0, 8));
    const DiveArena arena(basin(), limits(4.0, 0.0), world.shared());
    const Point wreck = world.lattice().centre(toCube({2, 1}));
    for (const double z : {0.0, 10.0, 25.0})
    {
        EXPECT_FALSE(arena.isFree(Point3(wreck.x(), wreck.y(), z)));
        EXPECT_FALSE(arena.isFree(Point3(wreck.x() - 3, wreck.y(), z), Point3(wreck.x() + 3, wreck.y(), 25.0 - z)));
        EXPECT_TRUE(arena.isFree(Point3(wreck.x() - 3, wreck.y() - 3, z), Point3(wreck.x() + 3, wreck.y() - 3, z)));
    }
    EXPECT_FALSE(arena.isFree(Point3(9.9, 9.9, 5))) << "outside the columns' lattice";
}

TEST(DiveArena, refusesWhatIsNoArena)
{
    EXPECT_THROW(DiveArena(basin(), limits(-1, 0)), std::domain_error);
    EXPECT_THROW(DiveArena(basin(), limits(1, -1)), std::domain_error);
    EXPECT_THROW(DiveArena(basin(), limits(1, std::nan(""))), std::domain_error);
    EXPECT_THROW(DiveArena(basin(), limits(1, 1, std::nan(""))), std::domain_error);
    EXPECT_THROW(DiveArena(basin(), limits(20, 15)), std::runtime_error);
    EXPECT_THROW(DiveArena(basin(), limits(5, 15, 10)), std::runtime_error);
    const auto unknown =
        std::make_shared<const Bathymetry>(NodeGrid(Point(0, 0), Point(1, 1), 2, 2), std::vector<float>(4, NAN));
    EXPECT_THROW(DiveArena(unknown, limits(1, 1)), std::runtime_error);
}

// A free line has free points only, however densely one looks; one that is not has a point that is not.
TEST(DiveArena, freeLinesEqualDenseSampling)
{
    int free = 0;
    int blocked = 0;
    forEachSeed(80,
                [&](Random &random)
                {
                    const auto seabed = randomSeabed(random, 12, 9, random.chance(0.5) ? 0.0 : 0.03);
                    const DiveLimits limit = limits(random.real(0.0, 6.0), random.real(0.0, 6.0));
                    const Box box = seabed->grid().bounds();
                    const HexLattice lattice(Point(box.min.x(), box.max.y()), (box.max - box.min).minCoeff() / 8.0, 30,
                                             30);
                    const auto columns = random.chance(0.5) ? randomOccupancy(random, lattice, 0.05) : nullptr;
                    const DiveArena arena(seabed, limit, columns);
                    for (int i = 0; i < 20; ++i)
                    {
                        const Point3 a = freePosition(random, arena);
                        const Point3 b = freePosition(random, arena);
                        const bool answer = arena.isFree(a, b);
                        ASSERT_EQ(arena.isFree(b, a), answer);
                        (answer ? free : blocked) += 1;
                        bool allFree = true;
                        for (int k = 0; k <= 3000; ++k)
                        {
                            const Point3 p = a + (b - a) * (k / 3000.0);
                            const double water = seabed->depthAt(horizontal(p)) - p.z();
                            allFree = allFree && arena.isFree(p);
                            if (answer)
                            {
                                ASSERT_GE(water, limit.clearanceM) << p.transpose();
                            }
                        }
                        // A crossing between two samples is no deeper than this below them.
                        if (!answer && allFree && columns == nullptr)
                        {
                            EXPECT_GT(seabed->leastWaterBelow(a, b), limit.clearanceM - 0.5);
                        }
                    }
                });
    EXPECT_GT(free, 200);
    EXPECT_GT(blocked, 200);
}
