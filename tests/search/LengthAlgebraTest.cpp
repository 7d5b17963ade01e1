#include <seahex/search/LengthAlgebra.h>

#include <cmath>

#include <gtest/gtest.h>

using namespace seahex;

TEST(LengthAlgebra, lengthsAddUpAndLessIsBetter)
{
    EXPECT_EQ(LengthAlgebra::combine(1.5, 2.0), 3.5);
    EXPECT_TRUE(LengthAlgebra::better(1.0, 2.0));
    EXPECT_FALSE(LengthAlgebra::better(2.0, 2.0));
    EXPECT_TRUE(LengthAlgebra::better(1e300, LengthAlgebra::worst()));
    EXPECT_FALSE(LengthAlgebra::better(LengthAlgebra::worst(), LengthAlgebra::worst()));
}

TEST(LengthAlgebra, roundingIsNoImprovement)
{
    // the same jumps in another order
    double one = 0.0;
    double other = 0.0;
    for (int i = 0; i < 100; ++i)
        one += std::sqrt(7.0);
    for (int i = 0; i < 200; ++i)
        one += std::sqrt(3.0);
    for (int i = 0; i < 200; ++i)
        other += std::sqrt(3.0);
    for (int i = 0; i < 100; ++i)
        other += std::sqrt(7.0);
    ASSERT_NE(one, other) << "the example shows nothing";
    EXPECT_FALSE(LengthAlgebra::improves(one, other));
    EXPECT_FALSE(LengthAlgebra::improves(other, one));
    EXPECT_EQ(LengthAlgebra::key(one), LengthAlgebra::key(other));
    EXPECT_TRUE(LengthAlgebra::improves(one - 1e-6, one));
}

TEST(LengthAlgebra, keyIsNeverMoreThanTheEstimateAndHardlyLess)
{
    for (const double estimate : {0.0, 1.0, std::sqrt(3.0), 115.0, 1e5 * std::sqrt(7.0), 1e6 + 0.1})
    {
        EXPECT_LE(LengthAlgebra::key(estimate), estimate);
        EXPECT_GT(LengthAlgebra::key(estimate), estimate - std::ldexp(1.0, -29));
    }
    EXPECT_EQ(LengthAlgebra::key(LengthAlgebra::worst()), LengthAlgebra::worst());
}
