#include <seahex/search/GoalCells.h>
#include <seahex/search/LengthAlgebra.h>

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

using namespace seahex;

namespace
{

/// Steps between neighbours.
struct StepWeight : LengthAlgebra
{
    static double bound(OffsetCoord cell, const GoalCell &goal)
    {
        return static_cast<double>(hexDistance(toCube(cell), toCube(goal.cell))) + goal.finish;
    }
    static double tie(OffsetCoord cell, double bound) { return bound + static_cast<double>(toCube(cell).q); }
};

}  // namespace

TEST(GoalCells, boundIsThatOfTheBestGoal)
{
    const CellLayout layout(20, 10);
    const HexCoord near = toCube({3, 3});
    const HexCoord far = toCube({15, 8});
    const GoalCells<StepWeight> goals(layout, {{near, 9.0}, {far, 0.5}}, {});
    EXPECT_EQ(goals.size(), layout.size());
    for (std::int64_t row = 0; row < 10; ++row)
        for (std::int64_t column = 0; column < 20; ++column)
        {
            const HexCoord cell = toCube({column, row});
            const double toNear = static_cast<double>(hexDistance(cell, near)) + 9.0;
            const double toFar = static_cast<double>(hexDistance(cell, far)) + 0.5;
            EXPECT_EQ(goals.bound(layout.index(cell)), std::min(toNear, toFar));
        }
    EXPECT_EQ(goals.tie(layout.index(near), 4.0), 4.0 + static_cast<double>(near.q));
}

TEST(GoalCells, finishIsThatOfTheCellAndElseTheWorst)
{
    const CellLayout layout(20, 10);
    const HexCoord goal = toCube({3, 3});
    const double worst = std::numeric_limits<double>::infinity();
    // the same cell twice, as two goal states in one cell make it: the cheaper one counts
    GoalCells<StepWeight> goals(layout, {{goal, 0.7}, {goal, 0.2}}, {});
    EXPECT_EQ(goals.finish(layout.index(goal)), 0.2);
    EXPECT_EQ(goals.finish(layout.index(toCube({4, 3}))), worst);
    goals.setGoals({{toCube({4, 3}), 0.0}});
    EXPECT_EQ(goals.finish(layout.index(goal)), worst);
    EXPECT_EQ(goals.finish(layout.index(toCube({4, 3}))), 0.0);
    EXPECT_EQ(goals.bound(layout.index(goal)), 1.0);
    goals.setGoals({});
    EXPECT_EQ(goals.bound(layout.index(goal)), worst);
}
