#include "seahex/io/ScaleBar.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace seahex
{

TEST(ScaleBar, IsTheLongestRoundLengthThatFits)
{
    EXPECT_EQ(metricScaleBar(4999.0).length, 2.0);
    EXPECT_EQ(metricScaleBar(4999.0).unit, "km");
    EXPECT_EQ(metricScaleBar(999.0).length, 500.0);
    EXPECT_EQ(metricScaleBar(999.0).unit, "m");
    EXPECT_EQ(nauticalScaleBar(1852.0 * 1.5).length, 1.0);
    EXPECT_DOUBLE_EQ(nauticalScaleBar(1852.0 * 1.5).lengthM, 1852.0);
}

RC_GTEST_PROP(ScaleBar, FillsAtLeastTwoFifthsOfTheRoom, ())
{
    const double available = std::pow(10.0, 0.001 * *rc::gen::inRange(-1000, 7000));
    for (const ScaleBar &bar : {metricScaleBar(available), nauticalScaleBar(available)})
    {
        RC_ASSERT(bar.lengthM <= available * (1.0 + 1e-9));
        RC_ASSERT(bar.lengthM >= 0.399 * available);
        RC_ASSERT(bar.parts == 4 || bar.parts == 5);
    }
}

TEST(ScaleBar, DegreesHaveTheirPublishedLengths)
{
    // Lengths of one degree on WGS-84 at the equator, 45 degrees and the pole.
    EXPECT_NEAR(metresPerDegreeOfLongitude(0.0), 111319.5, 0.1);
    EXPECT_NEAR(metresPerDegreeOfLatitude(0.0), 110574.3, 0.1);
    EXPECT_NEAR(metresPerDegreeOfLongitude(45.0), 78846.8, 0.1);
    EXPECT_NEAR(metresPerDegreeOfLatitude(45.0), 111131.8, 0.1);
    EXPECT_NEAR(metresPerDegreeOfLongitude(90.0), 0.0, 1e-6);
    EXPECT_NEAR(metresPerDegreeOfLatitude(90.0), 111693.9, 0.1);
}

TEST(ScaleBar, NumbersCarryNoIdleZeros)
{
    EXPECT_EQ(plainNumber(10.0, 3), "10");
    EXPECT_EQ(plainNumber(0.5, 3), "0.5");
    EXPECT_EQ(plainNumber(0.0005, 9), "0.0005");
    EXPECT_EQ(plainNumber(-0.0001, 2), "0");
    EXPECT_EQ(plainNumber(100.0, 0), "100");
}

}  // namespace seahex
