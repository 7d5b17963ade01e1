#include "curves/CostCurve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace seahex::contest
{
namespace
{

constexpr double never = std::numeric_limits<double>::infinity();

/// Two queries, the best costs 10 and 100; ours is late, the other early and never good.
std::vector<PlannerRun> lateAndEarly()
{
    return {{0, "late", {{1.0, 11.0}, {2.0, 10.0}}},
            {1, "late", {{1.0, 120.0}, {2.0, 100.0}}},
            {0, "early", {{0.5, 12.0}}},
            {1, "early", {{0.5, 120.0}}},
            {0, "lost", {}},
            {1, "lost", {}}};
}

TEST(CostCurve, HasTenMomentsADecade)
{
    const std::vector<double> moments = timeGrid(10.0);
    ASSERT_EQ(moments.size(), 51U);
    EXPECT_DOUBLE_EQ(moments.front(), 1e-4);
    EXPECT_DOUBLE_EQ(moments[10], 1e-3);
    EXPECT_NEAR(moments.back(), 10.0, 1e-9);
}

TEST(CostCurve, IsTheMedianRatioToTheBestOfTheSameQuery)
{
    const auto curves = medianCurves(lateAndEarly(), {0.4, 0.5, 1.0, 2.0});
    EXPECT_EQ(curves.at("lost"), std::vector<double>(4, never));
    const std::vector<double> &early = curves.at("early");
    EXPECT_EQ(early[0], never);
    EXPECT_DOUBLE_EQ(early[1], 1.2);
    EXPECT_DOUBLE_EQ(early[3], 1.2);
    const std::vector<double> &late = curves.at("late");
    EXPECT_EQ(late[1], never);
    EXPECT_DOUBLE_EQ(late[2], 0.5 * (1.1 + 1.2));
    EXPECT_DOUBLE_EQ(late[3], 1.0);
}

TEST(CostCurve, CountsTheMomentsAtWhichAnotherIsAhead)
{
    const auto curves = medianCurves(lateAndEarly(), {0.4, 0.5, 1.0, 2.0});
    EXPECT_EQ(momentsBehind(curves, "late"), 1U);
    EXPECT_EQ(momentsBehind(curves, "early"), 2U);
    EXPECT_EQ(momentsBehind(curves, "lost"), 3U);
}

TEST(CostCurve, TellsWhenARatioWasReached)
{
    const std::vector<PlannerRun> runs = lateAndEarly();
    EXPECT_DOUBLE_EQ(medianTimeTo(runs, "early", never), 0.5);
    EXPECT_DOUBLE_EQ(medianTimeTo(runs, "late", never), 1.0);
    EXPECT_DOUBLE_EQ(medianTimeTo(runs, "late", 1.1), 1.5);
    EXPECT_DOUBLE_EQ(medianTimeTo(runs, "late", 1.0), 2.0);
    EXPECT_EQ(medianTimeTo(runs, "early", 1.1), never);
    EXPECT_EQ(medianTimeTo(runs, "lost", never), never);
}

}  // namespace
}  // namespace seahex::contest
