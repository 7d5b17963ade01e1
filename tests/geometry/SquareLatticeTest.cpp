#include <seahex/geometry/SquareLattice.h>

#include "support/CellOutline.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>

#include <boost/geometry/geometry.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

TEST(SquareLattice, publishedScenario)
{
    // [Cheng2020] section 3: squares as wide as the hexagons, root 3 * 0.002 degrees, south-east of 21.98 N 112.50 E
    const SquareLattice lattice = SquareLattice::covering({{112.50, 21.50}, {113.00, 21.98}}, std::sqrt(3.0) * 0.002);
    EXPECT_EQ(lattice.cellAt({112.521, 21.635}), (OffsetCoord{6, 99}));
    EXPECT_EQ(lattice.cellAt({112.901, 21.669}), (OffsetCoord{115, 89}));
    EXPECT_EQ(lattice.columns(), 145);
    EXPECT_EQ(lattice.rows(), 139);
    EXPECT_EQ(lattice.cellCount(), 145 * 139);
}

TEST(SquareLattice, cellsLieAsDrawn)
{
    const SquareLattice lattice({10.0, 20.0}, 2.0, 4, 3);
    // row 0 is the northernmost, column 0 the westernmost
    EXPECT_EQ(lattice.centre({0, 0}), Point(11.0, 19.0));
    EXPECT_EQ(lattice.centre({0, 1}), Point(11.0, 17.0));
    EXPECT_EQ(lattice.centre({3, 2}), Point(17.0, 15.0));
    EXPECT_TRUE(lattice.contains({0, 0}));
    EXPECT_TRUE(lattice.contains({3, 2}));
    EXPECT_FALSE(lattice.contains({4, 2}));
    EXPECT_FALSE(lattice.contains({3, 3}));
    EXPECT_FALSE(lattice.contains({-1, 1}));
    EXPECT_FALSE(lattice.contains({0, -1}));
}

TEST(SquareLattice, cornersAreASquareCounterClockwiseFromTheNorthWest)
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double reach = std::pow(10.0, random.real(0.0, 9.0));
        const double pitch = std::max(std::pow(10.0, random.real(-3.0, 3.0)), 1e-7 * reach);
        const SquareLattice lattice(random.pointIn({Point(-reach, -reach), Point(reach, reach)}), pitch, 50, 50);
        const OffsetCoord cell = random.cellOf(lattice);
        const auto corners = lattice.corners(cell);
        const double rounding = 1e-14 * (reach + 100.0 * pitch);
        EXPECT_NEAR((corners[0] - lattice.centre(cell) - 0.5 * pitch * Point(-1.0, 1.0)).norm(), 0.0, rounding);
        for (std::size_t i = 0; i < 4; ++i)
        {
            EXPECT_NEAR((corners[i] - lattice.centre(cell)).norm(), std::sqrt(0.5) * pitch, rounding);
            EXPECT_NEAR((corners[i] - corners[(i + 1) % 4]).norm(), pitch, rounding);
        }
        const double area = boost::geometry::area(outline(lattice, cell));
        EXPECT_NEAR(area, pitch * pitch, 1e-3 * pitch * pitch);  // positive: counter-clockwise
    }
}
