#include <seahex/world/CellBits.h>
#include <seahex/world/Occupancy.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/Random.h"

#include <stdexcept>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

TEST(HexOccupancy, isWhatThePictureShows)
{
    const AsciiWorld world(R"(
         A . #
        # . .
         . . B
    )");
    const HexOccupancy &occupancy = world.occupancy();
    EXPECT_EQ(occupancy.lattice().columns(), 3);
    EXPECT_EQ(occupancy.lattice().rows(), 3);
    EXPECT_EQ(world.cell('A'), toCube({0, 0}));
    EXPECT_EQ(world.cell('B'), toCube({2, 2}));
    EXPECT_TRUE(occupancy.isBlocked(toCube({2, 0})));
    EXPECT_TRUE(occupancy.isBlocked(toCube({0, 1})));
    EXPECT_TRUE(occupancy.isFree(toCube({1, 1})));
    EXPECT_TRUE(occupancy.isFree(world.cell('A')));
    EXPECT_EQ(occupancy.blockedCount(), 2);
    EXPECT_EQ(toPicture(occupancy), "\n . . #\n# . .\n . . .\n");
    // the picture's slant is real: the cell below A and to the west of it is drawn so, and a neighbour
    EXPECT_LT(occupancy.lattice().centre(toCube({0, 1})).x(), world.centre('A').x());
    EXPECT_EQ(hexDistance(toCube({0, 1}), world.cell('A')), 1);
}

TEST(HexOccupancy, everythingOutsideIsBlocked)
{
    for (const std::int64_t columns : {1, 6, 58, 64, 70})
    {
        const auto occupancy = occupancyWith(HexLattice(Point::Zero(), 1.0, columns, 4), {});
        EXPECT_EQ(occupancy->blockedCount(), 0);
        forEachCell(occupancy->lattice(), 5,
                    [&](HexCoord cell) { ASSERT_EQ(occupancy->isFree(cell), occupancy->lattice().contains(cell)); });
        forEachCell(occupancy->lattice(), CellLayout::frame,
                    [&](HexCoord cell) {
                        ASSERT_EQ(occupancy->isBlockedAt(occupancy->layout().index(cell)), occupancy->isBlocked(cell));
                    });
        EXPECT_TRUE(occupancy->isBlocked({std::int64_t{1} << 60, -(std::int64_t{1} << 60)}));
    }
}

TEST(HexOccupancy, countsTheBlockedCellsOfTheRectangle)
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice(Point::Zero(), 1.0, random.integer(1, 150), random.integer(1, 20));
        const auto occupancy = randomOccupancy(random, lattice, random.unit());
        std::int64_t blocked = 0;
        forEachCell(lattice, 0, [&](HexCoord cell) { blocked += occupancy->isBlocked(cell) ? 1 : 0; });
        EXPECT_EQ(occupancy->blockedCount(), blocked);
    }
}

TEST(HexOccupancy, refusesBitsOfAnotherLattice)
{
    const HexLattice lattice(Point::Zero(), 1.0, 10, 10);
    const CellLayout layout(10, 10);
    const CellLayout wider(11, 10);
    EXPECT_NO_THROW(HexOccupancy(lattice, layout, CellBits(layout).words()));
    EXPECT_THROW(HexOccupancy(lattice, layout, {}), std::length_error);
    EXPECT_THROW(HexOccupancy(lattice, wider, CellBits(wider).words()), std::length_error);
    EXPECT_THROW(HexOccupancy(lattice, layout, std::vector<std::uint64_t>(layout.wordCount() + 1)), std::length_error);
}
