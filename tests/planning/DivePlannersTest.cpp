#include <seahex/io/BathymetryReader.h>
#include <seahex/planning/DiveSetup.h>
#include <seahex/planning/DiveStates.h>
#include <seahex/planning/PrismAStar.h>

#include "support/DiveJudge.h"
#include "support/Seabeds.h"
#include "support/TestData.h"

#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <gtest/gtest.h>

#include <functional>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

using Maker = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr &)>;

template <class PlannerType>
Maker maker()
{
    return [](const ob::SpaceInformationPtr &si)
    {
        return std::make_shared<PlannerType>(si);
    };
}

const std::vector<Maker> makers = {maker<og::RRTstar>(), maker<og::PRMstar>(), maker<og::BITstar>(),
                                   maker<PrismAStar>()};

struct Voyage
{
    const char *file;
    Point start;  // longitude, latitude
    Point goal;
    double startDepthM;
    double goalDepthM;
    DiveLimits limits;
};

std::vector<Point3> positionsOf(const og::PathGeometric &path)
{
    std::vector<Point3> positions;
    for (std::size_t i = 0; i < path.getStateCount(); ++i)
        positions.push_back(positionInWater(path.getState(static_cast<unsigned int>(i))));
    return positions;
}

/// Every planner's path, as found and simplified, before the independent judge.
void diveOn(const std::filesystem::path &folder, const Voyage &voyage)
{
    SCOPED_TRACE(voyage.file);
    BathymetryOptions options;
    options.coordinates = RasterCoordinates::Degrees;
    const BathymetryRaster raster = readBathymetry(folder / voyage.file, options);
    const DiveJudge judge(folder / voyage.file);
    const auto arena = std::make_shared<const DiveArena>(raster.seabed, voyage.limits);
    const auto inWater = [&](const Point &lonLat, double depthM)
    {
        const Point p = raster.projection->forward(GeoPoint::fromLonLat(lonLat.x(), lonLat.y()));
        return Point3(p.x(), p.y(), depthM);
    };
    const Point3 start = inWater(voyage.start, voyage.startDepthM);
    const Point3 goal = inWater(voyage.goal, voyage.goalDepthM);
    ASSERT_TRUE(arena->isFree(start));
    ASSERT_TRUE(arena->isFree(goal));
    ASSERT_FALSE(arena->isFree(start, goal)) << "a voyage that needs no planner";
    for (const Maker &make : makers)
    {
        og::SimpleSetup setup(diveSpace(*arena));
        useDiveArena(setup, arena);
        setStartAndGoal(setup, start, goal);
        setup.setPlanner(make(setup.getSpaceInformation()));
        SCOPED_TRACE(setup.getPlanner()->getName());
        // the first path will do
        setup.getOptimizationObjective()->setCostThreshold(setup.getOptimizationObjective()->infiniteCost());
        ASSERT_EQ(setup.solve(30.0), ob::PlannerStatus::EXACT_SOLUTION);
        og::PathGeometric path = setup.getSolutionPath();
        EXPECT_TRUE(path.check());
        const std::vector<Point3> found = positionsOf(path);
        EXPECT_EQ(found.front(), start);
        EXPECT_EQ(found.back(), goal);
        EXPECT_EQ(judge.fault(found, voyage.limits.clearanceM, voyage.limits.ceilingM), "");
        og::PathSimplifier(setup.getSpaceInformation(), setup.getGoal(), setup.getOptimizationObjective())
            .simplify(path, 0.2);
        EXPECT_EQ(judge.fault(positionsOf(path), voyage.limits.clearanceM, voyage.limits.ceilingM), "");
        EXPECT_LE(path.length(), setup.getSolutionPath().length() * (1.0 + 1e-9));
    }
}

TEST(DivePlanners, passTheJudgeOfRealSeabeds)
{
    SEAHEX_TEST_DATA_OR_SKIP(folder, "bathymetry");
    // From the Balearics to the Tyrrhenian, past Sardinia: more than 1,000 cells.
    diveOn(folder, {"52north_tests_depth_data.nc", Point(3.5, 38.5), Point(12.5, 39.5), 300.0, 1500.0, {50.0, 10.0}});
    // Past Iceland.
    diveOn(folder, {"gmt_Iceland.nc", Point(-25.5, 64.5), Point(-12.5, 64.5), 100.0, 60.0, {20.0, 5.0}});
    // From the open sea into Kahului's harbour, behind its breakwaters.
    diveOn(folder,
           {"geoclaw_kahului_1s.asc", Point(-156.4674, 20.9027), Point(-156.4668, 20.8970), 5.0, 4.0, {1.5, 1.0}});
}

TEST(DiveJudge, findsWhatIsWrong)
{
    SEAHEX_TEST_DATA_OR_SKIP(folder, "bathymetry");
    const auto file = folder / "gmt_Iceland.nc";
    const BathymetryRaster raster = readBathymetry(file);
    const DiveJudge judge(file);
    Random random(11);
    const DiveArena arena(raster.seabed, {20.0, 5.0});
    int faults = 0;
    for (int i = 0; i < 300; ++i)
    {
        const Point3 a = freePosition(random, arena);
        const Point3 b = freePosition(random, arena);
        const bool free = arena.isFree(a, b);
        const std::string fault = judge.fault({a, b}, 20.0, 5.0);
        if (free)
        {
            EXPECT_EQ(fault, "");
        }
        faults += fault.empty() ? 0 : 1;
        EXPECT_NEAR(judge.waterBelow(a), raster.seabed->depthAt(horizontal(a)) - a.z(), 1e-4);
    }
    EXPECT_GT(faults, 100);
    EXPECT_NE(judge.fault({Point3(0, 0, 10), Point3(1, 0, 10)}, 0.0, 0.0), "") << "in the middle of Iceland";
}

// On random seabeds of our own, judged by the surface itself at a tenth of a cell.
TEST(DivePlanners, keepTheClearanceOnRandomSeabeds)
{
    int dives = 0;
    forEachSeed(4,
                [&](Random &random)
                {
                    const auto seabed = randomSeabed(random, 30, 25, 0.01);
                    const auto arena = std::make_shared<const DiveArena>(seabed, DiveLimits{3.0, 1.0});
                    const Point3 start = freePosition(random, *arena);
                    const Point3 goal = freePosition(random, *arena);
                    for (const Maker &make : makers)
                    {
                        og::SimpleSetup setup(diveSpace(*arena));
                        useDiveArena(setup, arena);
                        setStartAndGoal(setup, start, goal);
                        setup.setPlanner(make(setup.getSpaceInformation()));
                        if (setup.solve(0.1) != ob::PlannerStatus::EXACT_SOLUTION)
                            continue;
                        ++dives;
                        const std::vector<Point3> dive = positionsOf(setup.getSolutionPath());
                        for (std::size_t leg = 1; leg < dive.size(); ++leg)
                            for (int i = 0; i <= 1000; ++i)
                            {
                                const Point3 p = dive[leg - 1] + (dive[leg] - dive[leg - 1]) * (i / 1000.0);
                                ASSERT_GE(seabed->depthAt(horizontal(p)) - p.z(), 3.0) << setup.getPlanner()->getName();
                                ASSERT_GE(p.z(), 1.0 - 1e-12);
                            }
                    }
                });
    EXPECT_GT(dives, 0);
}

}  // namespace
}  // namespace seahex::test
