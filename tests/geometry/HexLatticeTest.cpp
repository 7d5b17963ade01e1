#include <seahex/geometry/HexLattice.h>

#include "support/CellOutline.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>

#include <boost/geometry/geometry.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

TEST(HexLattice, publishedScenario)
{
    // [Cheng2020] section 3: cell width root 3 * 0.002 degrees, 143 x 159 cells south-east of 21.98 N 112.50 E
    const HexLattice lattice({112.50, 21.98}, std::sqrt(3.0) * 0.002, 143, 159);
    EXPECT_EQ(toOffset(lattice.cellAt({112.521, 21.635})), (OffsetCoord{5, 114}));
    EXPECT_EQ(toOffset(lattice.cellAt({112.901, 21.669})), (OffsetCoord{115, 103}));
    EXPECT_NEAR(lattice.side(), 0.002, 1e-15);
    EXPECT_EQ(lattice.cellCount(), 143 * 159);
}

TEST(HexLattice, cellsLieAsDrawn)
{
    const HexLattice lattice({10.0, 20.0}, 2.0, 4, 3);
    const double side = 2.0 / std::sqrt(3.0);
    // row 0 is the northernmost and shifted east; row 1 begins at the western edge
    EXPECT_NEAR((lattice.centre(toCube({0, 0})) - Point(12.0, 20.0 - side)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((lattice.centre(toCube({0, 1})) - Point(11.0, 20.0 - 2.5 * side)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((lattice.centre(toCube({3, 2})) - Point(18.0, 20.0 - 4.0 * side)).norm(), 0.0, 1e-12);
    EXPECT_TRUE(lattice.contains(toCube({3, 2})));
    EXPECT_FALSE(lattice.contains(toCube({4, 2})));
    EXPECT_FALSE(lattice.contains(toCube({3, 3})));
    EXPECT_FALSE(lattice.contains(toCube({-1, 1})));
    EXPECT_FALSE(lattice.contains(toCube({0, -1})));
}

TEST(HexLattice, cornersAreARegularHexagonCounterClockwiseFromNorth)
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double reach = std::pow(10.0, random.real(0.0, 9.0));
        const double pitch = std::max(std::pow(10.0, random.real(-3.0, 3.0)), 1e-7 * reach);
        const HexLattice lattice(random.pointIn({Point(-reach, -reach), Point(reach, reach)}), pitch, 50, 50);
        const HexCoord cell = random.cellOf(lattice);
        const auto corners = lattice.corners(cell);
        const double rounding = 1e-14 * (reach + 100.0 * pitch);
        EXPECT_NEAR((corners[0] - lattice.centre(cell) - Point(0.0, lattice.side())).norm(), 0.0, rounding);
        for (std::size_t i = 0; i < 6; ++i)
        {
            EXPECT_NEAR((corners[i] - lattice.centre(cell)).norm(), lattice.side(), rounding);
            EXPECT_NEAR((corners[i] - corners[(i + 1) % 6]).norm(), lattice.side(), rounding);
        }
        const double area = boost::geometry::area(outline(lattice, cell));
        const double expected = 0.5 * std::sqrt(3.0) * lattice.pitch() * lattice.pitch();
        EXPECT_NEAR(area, expected, 1e-3 * expected);  // positive: counter-clockwise
    }
}

TEST(HexLattice, neighboursShareTheirEdges)
{
    const HexLattice lattice({3.0, 4.0}, 1.5, 10, 10);
    for (const HexCoord step : {HexCoord{1, 0}, HexCoord{1, -1}, HexCoord{0, -1}})
    {
        int shared = 0;
        for (const Point &corner : lattice.corners({2, 5}))
            for (const Point &other : lattice.corners(HexCoord{2, 5} + step))
                shared += (corner - other).norm() < 1e-12 ? 1 : 0;
        EXPECT_EQ(shared, 2);
    }
}
