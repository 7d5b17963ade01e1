#include <seahex/geometry/SquareNorm.h>

#include "support/OpenWindow.h"
#include "support/Random.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

OpenWindow openWindow(int neighbours)
{
    std::vector<OpenWindow::Jump> steps = {{1, 0, 1.0}, {0, 1, 1.0}, {-1, 0, 1.0}, {0, -1, 1.0}};
    if (neighbours == 8)
        for (const std::int64_t columns : {-1, 1})
            for (const std::int64_t rows : {-1, 1})
                steps.push_back({columns, rows, std::sqrt(2.0)});
    return OpenWindow(steps);
}

}  // namespace

TEST(SquareNorm, isTheCostOfTheCheapestChainOfSteps)
{
    for (const int neighbours : {4, 8})
    {
        const OpenWindow window = openWindow(neighbours);
        for (std::int64_t columns = -20; columns <= 20; ++columns)
            for (std::int64_t rows = -20; rows <= 20; ++rows)
                ASSERT_NEAR(squareNorm({columns, rows}, neighbours), window.costTo(columns, rows), 1e-9)
                    << neighbours << " neighbours, " << columns << " columns, " << rows << " rows";
    }
}

TEST(SquareNorm, isANorm)
{
    // With the triangle inequality, and no step shorter than its norm, no chain of steps beats it, however long.
    Random random(1);
    SCOPED_TRACE(random.seedText());
    EXPECT_EQ(squareNorm({0, -1}, 4), 1.0);
    EXPECT_EQ(squareNorm({-1, 0}, 8), 1.0);
    EXPECT_EQ(squareNorm({-1, 1}, 8), std::sqrt(2.0));
    for (const int neighbours : {4, 8})
        for (int i = 0; i < 20000; ++i)
        {
            const std::int64_t size = i % 2 == 0 ? 5 : 1000000;
            const OffsetCoord u{random.integer(-size, size), random.integer(-size, size)};
            const OffsetCoord v{random.integer(-size, size), random.integer(-size, size)};
            const double sum = squareNorm(u, neighbours) + squareNorm(v, neighbours);
            ASSERT_LE(squareNorm({u.column + v.column, u.row + v.row}, neighbours), sum * (1.0 + 1e-14))
                << u.column << "," << u.row << " " << v.column << "," << v.row;
            ASSERT_NEAR(squareNorm({7 * u.column, 7 * u.row}, neighbours), 7 * squareNorm(u, neighbours), 1e-9 * sum);
            ASSERT_EQ(squareNorm({-u.column, -u.row}, neighbours), squareNorm(u, neighbours));
        }
}

TEST(SquareNorm, octileNormExtendsTheDistanceOfCells)
{
    for (std::int64_t columns = -12; columns <= 12; ++columns)
        for (std::int64_t rows = -12; rows <= 12; ++rows)
        {
            const Point vector(2.5 * static_cast<double>(columns), -2.5 * static_cast<double>(rows));
            ASSERT_NEAR(octileNorm(vector, 2.5), squareNorm({columns, rows}, 8), 1e-12);
        }
}

TEST(SquareNorm, octileNormIsANormOfThePlane)
{
    constexpr double pitch = 2.5;
    Random random(3);
    SCOPED_TRACE(random.seedText());
    const Box box{Point(-90.0, -90.0), Point(90.0, 90.0)};
    for (int i = 0; i < 5000; ++i)
    {
        const Point u = random.pointIn(box);
        const Point v = random.pointIn(box);
        const double scale = random.real(-3.0, 3.0);
        ASSERT_LE(octileNorm(u + v, pitch), octileNorm(u, pitch) + octileNorm(v, pitch) + 1e-12);
        ASSERT_NEAR(octileNorm(scale * u, pitch), std::abs(scale) * octileNorm(u, pitch), 1e-9);
        // the unit ball is an octagon between the circles of radius 1 and cos(pi / 8) pitches
        ASSERT_GE(octileNorm(u, pitch), u.norm() / pitch - 1e-12);
        ASSERT_LE(octileNorm(u, pitch), u.norm() / pitch / std::cos(M_PI / 8.0) + 1e-12);
    }
}
