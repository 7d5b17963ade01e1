#include <seahex/planning/HexAStar.h>
#include <seahex/planning/Setup.h>

#include "support/PlanningWorlds.h"

#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/tools/benchmark/Benchmark.h>

#include <gtest/gtest.h>

#include <functional>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

/// An archipelago of 30 x 30 cells and two places that a path joins.
class Archipelago : public ::testing::Test
{
protected:
    Archipelago() : random(31), occupancy(randomOccupancy(random, HexLattice(Point(100, 50), 2.0, 30, 30), 0.15))
    {
        const Box box = occupancy->lattice().bounds();
        do
        {
            start = freePoint(random, *occupancy);
            goal = freePoint(random, *occupancy);
        } while ((goal - start).norm() < 0.6 * (box.max - box.min).norm() || !isJoined());
    }

    bool isJoined() const
    {
        const auto problem = problemBetween(chartSpace(occupancy), start, goal);
        return plannerFor(problem)->solve(5.0) == ob::PlannerStatus::EXACT_SOLUTION;
    }

    og::SimpleSetup setup() const
    {
        og::SimpleSetup setup(planarSpace(*occupancy));
        useOccupancy(setup, occupancy);
        setStartAndGoal(setup, start, goal);
        return setup;
    }

    Random random;
    std::shared_ptr<const HexOccupancy> occupancy;
    Point start;
    Point goal;
};

TEST_F(Archipelago, ExactPathsOfOmplsPlannersTouchNoBlockedCell)
{
    const std::vector<std::function<ob::PlannerPtr(const ob::SpaceInformationPtr &)>> planners = {
        [](const auto &si) { return std::make_shared<HexAStar>(si); },
        [](const auto &si) { return std::make_shared<og::RRTConnect>(si); },
        [](const auto &si) { return std::make_shared<og::RRTstar>(si); },
        [](const auto &si) { return std::make_shared<og::InformedRRTstar>(si); },
        [](const auto &si) { return std::make_shared<og::PRMstar>(si); },
        [](const auto &si) { return std::make_shared<og::BITstar>(si); },
    };
    int exact = 0;
    for (const auto &makePlanner : planners)
    {
        og::SimpleSetup problem = setup();
        problem.setPlanner(makePlanner(problem.getSpaceInformation()));
        SCOPED_TRACE(problem.getPlanner()->getName());
        if (problem.solve(0.7) != ob::PlannerStatus::EXACT_SOLUTION)
            continue;
        ++exact;
        og::PathGeometric &path = problem.getSolutionPath();
        EXPECT_TRUE(path.check());
        EXPECT_EQ(positionOf(problem.getSpaceInformation(), path.getState(0)), start);
        for (std::size_t i = 1; i < path.getStateCount(); ++i)
            EXPECT_GT(distanceToBlocked(*occupancy, positionOf(problem.getSpaceInformation(), path.getStates()[i - 1]),
                                        positionOf(problem.getSpaceInformation(), path.getStates()[i])),
                      0.0L);
    }
    EXPECT_GE(exact, 4) << "most planners find a path in this time";
}

TEST_F(Archipelago, BenchmarkRunsHexAStarNextToRrtConnect)
{
    og::SimpleSetup problem = setup();
    problem.setPlanner(std::make_shared<HexAStar>(problem.getSpaceInformation()));
    ompl::tools::Benchmark benchmark(problem, "archipelago");
    benchmark.addPlanner(std::make_shared<HexAStar>(problem.getSpaceInformation()));
    benchmark.addPlanner(std::make_shared<og::RRTConnect>(problem.getSpaceInformation()));
    const ompl::tools::Benchmark::Request request(1.0, 2000.0, 2, 0.05, false, false, false);
    benchmark.benchmark(request);
    const auto &results = benchmark.getRecordedExperimentData();
    ASSERT_EQ(results.planners.size(), 2u);
    EXPECT_EQ(results.planners[0].name, "geometric_HexAStar");
    ASSERT_EQ(results.planners[0].runs.size(), 2u);
    for (const auto &run : results.planners[0].runs)
    {
        EXPECT_EQ(run.at("solved BOOLEAN"), "1");
        EXPECT_EQ(run.at("correct solution BOOLEAN"), "1");
        EXPECT_EQ(run.at("correct solution strict BOOLEAN"), "1");
        EXPECT_EQ(run.at("solution length REAL"), results.planners[0].runs[0].at("solution length REAL"));
    }
    EXPECT_EQ(results.planners[0].common.at("rings"), "3");
    EXPECT_EQ(results.planners[1].runs.size(), 2u);
}

}  // namespace
}  // namespace seahex::test
