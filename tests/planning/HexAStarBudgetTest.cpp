#include <seahex/planning/HexAStar.h>

#include "planning/ClosedBay.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

/// A sea of free cells, 60 x 60, in which a search without guidance expands all.
std::shared_ptr<const HexOccupancy> openSea()
{
    return occupancyWith(HexLattice(Point(0, 0), 1.0, 60, 60), {});
}

TEST(HexAStarBudget, LittleTimeIsContinuedToTheSameCost)
{
    const auto si = chartSpace(openSea());
    const auto whole = problemBetween(si, Point(2.0, -3.0), Point(55.0, -50.0));
    const auto uninterrupted = plannerFor(whole);
    uninterrupted->setGuidance(Guidance::None);
    ASSERT_EQ(uninterrupted->solve(10.0), ob::PlannerStatus::EXACT_SOLUTION);

    const auto problem = problemBetween(si, Point(2.0, -3.0), Point(55.0, -50.0));
    const auto planner = plannerFor(problem);
    planner->setGuidance(Guidance::None);
    Watch watch([](int look) { return look % 2 == 0; });
    int calls = 1;
    for (; planner->solve(watch.condition()) != ob::PlannerStatus::EXACT_SOLUTION; ++calls)
    {
        ASSERT_EQ(planner->outcome(), PlanningOutcome::OutOfTime);
        ASSERT_FALSE(problem->hasSolution());
        ASSERT_LT(calls, 1000);
    }
    EXPECT_GE(calls, 5);
    EXPECT_EQ(pathOf(problem)->length(), pathOf(whole)->length());
    EXPECT_EQ(planner->counters().expanded, uninterrupted->counters().expanded) << "no work is lost or done twice";
}

TEST(HexAStarBudget, LooksEvery500Expansions)
{
    const auto si = chartSpace(openSea());
    const auto problem = problemBetween(si, Point(2.0, -3.0), Point(55.0, -50.0));
    const auto planner = plannerFor(problem);
    planner->setGuidance(Guidance::None);
    Watch watch([](int) { return false; });
    ASSERT_EQ(planner->solve(watch.condition()), ob::PlannerStatus::EXACT_SOLUTION);
    EXPECT_GE(static_cast<std::uint64_t>(watch.looks()), planner->counters().expanded / 500);
}

TEST(HexAStarBudget, NoTimeAtAllReturnsAtOnce)
{
    const auto si = chartSpace(openSea());
    const auto problem = problemBetween(si, Point(2.0, -3.0), Point(55.0, -50.0));
    const auto planner = plannerFor(problem);
    EXPECT_LT(
        secondsOf([&]
                  { EXPECT_EQ(planner->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT); }),
        0.5);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::OutOfTime);
    EXPECT_EQ(planner->counters().expanded, 0u);
    EXPECT_EQ(planner->solve(5.0), ob::PlannerStatus::EXACT_SOLUTION);
    problem->clearSolutionPaths();
    EXPECT_EQ(planner->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::EXACT_SOLUTION)
        << "what is known is told again";
}

TEST(HexAStarBudget, ATerminatedConditionStopsFromAnotherThread)
{
    const auto si = chartSpace(occupancyWith(HexLattice(Point(0, 0), 1.0, 3000, 3000), {}));
    const auto planner = plannerFor(problemBetween(si, Point(2.0, -3.0), Point(2990.0, -2500.0)));
    planner->setGuidance(Guidance::None);
    const ob::PlannerTerminationCondition condition = ob::plannerNonTerminatingCondition();
    std::thread other(
        [&]
        {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            condition.terminate();
        });
    const ob::PlannerStatus status = planner->solve(condition);
    other.join();
    EXPECT_EQ(status, ob::PlannerStatus::TIMEOUT);
    EXPECT_EQ(planner->outcome(), PlanningOutcome::OutOfTime);
}

}  // namespace
}  // namespace seahex::test
