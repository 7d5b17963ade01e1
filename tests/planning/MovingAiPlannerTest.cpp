// SquareAStar, as a planner of OMPL's, against the published optima of the MovingAI benchmark.

#include <seahex/planning/Setup.h>
#include <seahex/planning/SquareAStar.h>

#include "support/MovingAiMap.h"
#include "support/TestData.h"

#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>

#include <memory>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{

/// Lengths in the files are rounded to two digits and more.
constexpr double rounding = 0.01;

/// A map as a problem in R^2 whose paths are the lattice's own.
class MapProblem
{
public:
    explicit MapProblem(const MovingAiMap &map)
        : lattice_(map.occupancy()->lattice()), setup_(planarSpace(*map.occupancy())),
          planner_(std::make_shared<SquareAStar>(setup_.getSpaceInformation()))
    {
        useOccupancy(setup_, map.occupancy());
        planner_->setSmoothing(false);
        setup_.setPlanner(planner_);
        ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    }

    ob::PlannerStatus solve(const MovingAiScenario &scenario)
    {
        setup_.clear();
        setStartAndGoal(setup_, lattice_.centre(scenario.start), lattice_.centre(scenario.goal));
        return setup_.solve(ob::plannerNonTerminatingCondition());
    }

    SquareAStar &planner() { return *planner_; }
    og::PathGeometric &path() { return setup_.getSolutionPath(); }

private:
    SquareLattice lattice_;
    og::SimpleSetup setup_;
    std::shared_ptr<SquareAStar> planner_;
};

}  // namespace

TEST(MovingAiPlanner, pathsHaveThePublishedLengths)
{
    SEAHEX_TEST_DATA_OR_SKIP(folder, "movingai");
    int solved = 0;
    for (const std::filesystem::path &path : movingAiMapsIn(folder))
    {
        SCOPED_TRACE(path.filename().string());
        const MovingAiMap map = MovingAiMap::read(path);
        MapProblem problem(map);
        const std::vector<MovingAiScenario> scenarios = readMovingAiScenarios(scenariosOf(path), map);
        for (std::size_t i = 0; i < scenarios.size(); i += 5, ++solved)
        {
            const MovingAiScenario &scenario = scenarios[i];
            SCOPED_TRACE("scenario " + std::to_string(i));
            ASSERT_EQ(problem.solve(scenario), ob::PlannerStatus::EXACT_SOLUTION);
            ASSERT_EQ(problem.planner().outcome(), PlanningOutcome::Found);
            ASSERT_NEAR(problem.path().length(), scenario.optimalLength, rounding);
            ASSERT_TRUE(problem.path().check());
        }
    }
    EXPECT_GT(solved, 500);
}

TEST(MovingAiPlanner, cutCornersAndFewerNeighboursTellInTheLength)
{
    SEAHEX_TEST_DATA_OR_SKIP(folder, "movingai");
    const MovingAiMap map = MovingAiMap::read(folder / "den312d.map");
    MapProblem problem(map);
    int shorter = 0;
    int longer = 0;
    const std::vector<MovingAiScenario> scenarios = readMovingAiScenarios(folder / "den312d.map.scen", map);
    for (std::size_t i = 0; i < scenarios.size(); i += 10)
    {
        const MovingAiScenario &scenario = scenarios[i];
        SCOPED_TRACE("scenario " + std::to_string(i));
        problem.planner().setCornerCutting(true);
        ASSERT_EQ(problem.solve(scenario), ob::PlannerStatus::EXACT_SOLUTION);
        const double cutting = problem.path().length();
        ASSERT_LE(cutting, scenario.optimalLength + rounding);
        shorter += cutting < scenario.optimalLength - rounding ? 1 : 0;
        problem.planner().setCornerCutting(false);
        problem.planner().setNeighbours(4);
        ASSERT_EQ(problem.solve(scenario), ob::PlannerStatus::EXACT_SOLUTION);
        const double upright = problem.path().length();
        ASSERT_GE(upright, scenario.optimalLength - rounding);
        longer += upright > scenario.optimalLength + rounding ? 1 : 0;
        problem.planner().setNeighbours(8);
    }
    EXPECT_GT(shorter, 0);
    EXPECT_GT(longer, 0);
}
