#pragma once

#include "support/AsciiWorld.h"
#include "support/PlanningWorlds.h"

#include <gtest/gtest.h>

namespace seahex::test
{

/// A small chart of squares with three places between which there is a way, and D, joined to them over a corner between
/// two rocks only.
class SquareBay : public ::testing::Test
{
protected:
    SquareBay()
        : world(R"(
            A . . # . . . . .
            . . . # . . . # C
            . # . . . # # . .
            . # . . . # . . .
            . # # # . # . # .
            . . . . . . # D #
            . . . . # . . # B
            . . . . . . . . .
        )"),
          si(chartSpace(world.shared()))
    {
    }

    ompl::base::ProblemDefinitionPtr between(char start, char goal) const
    {
        return problemBetween(si, world.centre(start), world.centre(goal));
    }

    SquareWorld world;
    ompl::base::SpaceInformationPtr si;
};

}  // namespace seahex::test
