#pragma once

#include "support/AsciiWorld.h"
#include "support/PlanningWorlds.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>

namespace seahex::test
{

/// A small chart with four places between which there is a way, for tests of how HexAStar behaves as a planner.
class ClosedBay : public ::testing::Test
{
protected:
    ClosedBay()
        : world(R"(
             A . . # . . . . .
            . . . # . . . # C
             . # . . . # . # #
            . # . . . # . . .
             . # # # . # D . .
            . . . . . # . . B
        )"),
          si(chartSpace(world.shared()))
    {
    }

    ompl::base::ProblemDefinitionPtr between(char start, char goal) const
    {
        return problemBetween(si, world.centre(start), world.centre(goal));
    }

    double costBetween(char start, char goal) const
    {
        const auto problem = between(start, goal);
        EXPECT_EQ(plannerFor(problem)->solve(5.0), ompl::base::PlannerStatus::EXACT_SOLUTION);
        return pathOf(problem)->length();
    }

    AsciiWorld world;
    ompl::base::SpaceInformationPtr si;
};

/// Wall time that the action takes.
inline double secondsOf(const std::function<void()> &action)
{
    const auto begin = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace seahex::test
