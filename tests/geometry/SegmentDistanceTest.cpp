#include "seahex/geometry/SegmentDistance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seahex
{
namespace
{

TEST(SegmentDistance, isThatOfTheNearestPoint)
{
    const Point a(1, 1);
    const Point b(5, 1);
    EXPECT_DOUBLE_EQ(distanceToSegment(Point(3, 4), a, b), 3.0) << "beside";
    EXPECT_DOUBLE_EQ(distanceToSegment(Point(-2, -3), a, b), 5.0) << "before";
    EXPECT_DOUBLE_EQ(distanceToSegment(Point(6, 2), a, b), std::sqrt(2.0)) << "beyond";
    EXPECT_EQ(distanceToSegment(Point(2, 1), a, b), 0.0) << "on it";
    EXPECT_DOUBLE_EQ(distanceToSegment(Point(4, 5), a, a), 5.0) << "no length";
}

}  // namespace
}  // namespace seahex
