#include <seahex/search/Guidance.h>

#include "support/Random.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

TEST(Guidance, namesAreReadAsTheyAreWritten)
{
    std::string all;
    for (const Guidance guidance : {Guidance::Automatic, Guidance::None, Guidance::Distance, Guidance::Euclidean,
                                    Guidance::Cheng, Guidance::Wang, Guidance::TieBreak, Guidance::Relaxed})
    {
        EXPECT_EQ(guidanceFromString(toString(guidance)), guidance);
        all += (all.empty() ? "" : ",") + std::string(toString(guidance));
    }
    EXPECT_EQ(guidanceNames(), all);
    EXPECT_EQ(guidanceFromString("wang"), Guidance::Wang);
    EXPECT_EQ(guidanceFromString("tie_break"), Guidance::TieBreak);
    EXPECT_EQ(guidanceFromString("relaxed"), Guidance::Relaxed);
    EXPECT_FALSE(guidanceFromString("").has_value());
    EXPECT_FALSE(guidanceFromString("Distance").has_value());
    EXPECT_FALSE(guidanceFromString("manhattan").has_value());
}

TEST(Guidance, pilotQuantityIsThatOfTheAngleAtTheGoal)
{
    // [Cheng2020] eq. 7 and 8: p = 3 / (4 - sin theta)
    const Point goal(10.0, -4.0);
    const Point start = goal + 7.0 * Point(std::cos(0.3), std::sin(0.3));
    for (int degrees = -360; degrees <= 360; ++degrees)
    {
        const double theta = degrees * M_PI / 180.0;
        const Point i = goal + 2.5 * Point(std::cos(0.3 + theta), std::sin(0.3 + theta));
        EXPECT_NEAR(pilotQuantity(start, goal, i), 3.0 / (4.0 - std::abs(std::sin(theta))), 1e-12) << degrees;
    }
    EXPECT_DOUBLE_EQ(pilotQuantity(start, goal, start), 0.75);
    EXPECT_DOUBLE_EQ(pilotQuantity({1, 0}, {0, 0}, {0, 5}), 1.0);
}

TEST(Guidance, pilotQuantityLiesBetweenThreeQuartersAndOne)
{
    Random random(1);
    SCOPED_TRACE(random.seedText());
    for (int n = 0; n < 20000; ++n)
    {
        const double size = std::pow(10.0, random.real(-9.0, 9.0));
        const Box box{Point(-size, -size), Point(size, size)};
        const Point start = random.pointIn(box);
        const Point goal = random.pointIn(box);
        Point i = random.pointIn(box);
        if (n % 3 == 0)
            i = start + random.real(-1.0, 2.0) * (goal - start);  // on the line, where rounding could slip below
        if (n % 3 == 1)
            i = goal + Point(start.y() - goal.y(), goal.x() - start.x());  // square to it
        const double p = pilotQuantity(start, goal, i);
        ASSERT_GE(p, 0.75);
        ASSERT_LE(p, 1.0);
    }
}

TEST(Guidance, pilotQuantityIsOneWhereTheAngleIsUndefined)
{
    const Point a(3.0, 4.0);
    const Point b(7.0, -1.0);
    EXPECT_EQ(pilotQuantity(a, a, b), 1.0);
    EXPECT_EQ(pilotQuantity(a, b, b), 1.0);
    EXPECT_EQ(pilotQuantity(a, a, a), 1.0);
}

TEST(Guidance, distanceFromLine)
{
    EXPECT_DOUBLE_EQ(distanceFromLine({0, 0}, {10, 0}, {3, 4}), 4.0);
    EXPECT_DOUBLE_EQ(distanceFromLine({0, 0}, {10, 0}, {-50, -4}), 4.0);  // the line has no ends
    EXPECT_DOUBLE_EQ(distanceFromLine({0, 0}, {3, 4}, {6, 8}), 0.0);
    EXPECT_DOUBLE_EQ(distanceFromLine({5, 5}, {5, 5}, {6, 8}), 0.0);
}
