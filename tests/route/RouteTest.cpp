#include "seahex/route/Route.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seahex
{
namespace
{

TEST(Route, hasNoLegBelowTwoWaypoints)
{
    EXPECT_EQ(Route().legCount(), 0u);
    EXPECT_TRUE(Route().empty());
    EXPECT_EQ(Route({Point(3, 4)}).legCount(), 0u);
    EXPECT_EQ(Route({Point(3, 4)}).length(), 0.0);
}

TEST(Route, addsUpItsLegs)
{
    const Route route({Point(0, 0), Point(3, 4), Point(3, -6)});
    ASSERT_EQ(route.legCount(), 2u);
    EXPECT_DOUBLE_EQ(route.leg(0).length(), 5.0);
    EXPECT_DOUBLE_EQ(route.length(), 15.0);
}

TEST(Leg, headsMathematically)
{
    EXPECT_DOUBLE_EQ((Leg{Point(1, 1), Point(2, 1)}.heading()), 0.0);
    EXPECT_DOUBLE_EQ((Leg{Point(1, 1), Point(1, 3)}.heading()), std::acos(0.0));
    EXPECT_DOUBLE_EQ((Leg{Point(1, 1), Point(0, 1)}.heading()), 2.0 * std::acos(0.0));
}

}  // namespace
}  // namespace seahex
