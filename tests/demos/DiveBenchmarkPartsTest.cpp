// The parts of benchmark_planners that know dives, and what a dive is judged by: deep water, pairs, the judge that
// shares nothing with the planners' checkers, the roster.

#include "benchmark_planners/DiveJudge.h"
#include "benchmark_planners/DiveRoster.h"
#include "benchmark_planners/DiveWorld.h"
#include "benchmark_planners/RunJudge.h"
#include "common/DeepWater.h"
#include "common/DivePairs.h"
#include "common/Failure.h"
#include "common/RasterSeabed.h"
#include "support/DiveJudge.h"
#include "support/Random.h"
#include "support/Seabeds.h"
#include "support/TestCharts.h"
#include "support/TestRasters.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/StateValidityChecker.h>
#include <seahex/planning/DiveStates.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <unistd.h>

using namespace seahex;
using namespace seahex::test;
using benchmark_planners::diveRosterNames;
using benchmark_planners::DiveVerdict;
using benchmark_planners::DiveWorld;
using benchmark_planners::RunJudge;
using demos::DeepWater;
using demos::DivePair;
using demos::drawDivePairs;

using Judge = benchmark_planners::DiveJudge;

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{

/// 41 x 31 nodes 100 m apart: 100 m of water, across it from south to north a ridge that rises to 20 m below the
/// surface along column 20, 40 m steep to either side.
std::shared_ptr<const Bathymetry> ridge()
{
    const NodeGrid grid(Point(0.0, 0.0), Point(100.0, 100.0), 41, 31);
    std::vector<float> depths;
    for (int row = 0; row < 31; ++row)
        for (int column = 0; column < 41; ++column)
            depths.push_back(std::min(100.0f, 20.0f + 40.0f * static_cast<float>(std::abs(column - 20))));
    return std::make_shared<const Bathymetry>(grid, depths);
}

TEST(DiveJudge, catchesWhatDoesNotKeepTheLimits)
{
    const auto seabed = ridge();
    const Judge judge(*seabed, {5.0, 3.0, 80.0});
    const Point3 west(500.0, 1500.0, 60.0);
    const Point3 top(2000.0, 1500.0, 14.0);
    const Point3 east(3500.0, 1500.0, 60.0);
    const DiveVerdict over = judge.judge({west, top, east});
    EXPECT_TRUE(over.isSafe);
    EXPECT_NEAR(over.leastWaterM, 6.0, 1e-9);

    const DiveVerdict through = judge.judge({west, east});
    EXPECT_FALSE(through.isSafe) << "both ends are free, the ridge lies between";
    EXPECT_NEAR(through.leastWaterM, -40.0, 1e-9);
    EXPECT_FALSE(judge.judge({west, Point3(2000.0, 1500.0, 15.5), east}).isSafe) << "4.5 m above the top";
    EXPECT_FALSE(judge.judge({west, Point3(2000.0, 1500.0, 2.9), east}).isSafe) << "above the ceiling";
    EXPECT_FALSE(judge.judge({west, Point3(700.0, 1500.0, 81.0)}).isSafe) << "below the greatest depth";
    EXPECT_FALSE(judge.judge({west, Point3(-1.0, 1500.0, 60.0)}).isSafe) << "west of the nodes";
    EXPECT_FALSE(judge.judge({west, Point3(500.0, 3001.0, 60.0)}).isSafe) << "north of the nodes";
    EXPECT_FALSE(judge.judge({west, Point3(500.0, std::nan(""), 60.0)}).isSafe);
    EXPECT_TRUE(judge.judge({Point3(0.0, 0.0, 60.0), Point3(0.0, 3000.0, 60.0)}).isSafe) << "along the last nodes";
    EXPECT_FALSE(judge.judge({Point3(500.0, 1500.0, 79.0), Point3(500.0, 1500.0, 81.0)}).isSafe) << "straight down";
}

TEST(DiveJudge, unknownSeabedIsNotSafe)
{
    const NodeGrid grid(Point(0.0, 0.0), Point(1.0, 1.0), 9, 3);
    std::vector<float> depths(27, 50.0f);
    depths[13] = Bathymetry::unknownDepth;  // in the middle
    const Bathymetry seabed(grid, depths);
    const Judge judge(seabed, {5.0, 0.0});
    EXPECT_TRUE(judge.judge({Point3(0.5, 0.5, 10.0), Point3(2.9, 1.5, 10.0)}).isSafe);
    EXPECT_FALSE(judge.judge({Point3(0.5, 0.5, 10.0), Point3(7.5, 0.5, 10.0)}).isSafe);
}

// The exact least water and the sampled one come by different ways; between samples the surface and the dive can fall
// by so much only.
TEST(DiveJudge, seesTheExactLeastWaterToATenthOfACell)
{
    forEachSeed(40,
                [](Random &random)
                {
                    const auto seabed = randomSeabed(random, 12, 9, 0.0);
                    const DiveArena arena(seabed, {2.0, 0.0});
                    const Judge judge(*seabed, arena.limits());
                    constexpr double mostBetweenNodes = 75.0;  // see randomSeabed
                    for (int i = 0; i < 50; ++i)
                    {
                        const Point3 a = anyPosition(random, arena);
                        const Point3 b = anyPosition(random, arena);
                        const double exact = seabed->leastWaterBelow(a, b);
                        const double seen = judge.judge({a, b}).leastWaterM;
                        EXPECT_GE(seen, exact - 1e-6);
                        const Point cells = horizontal(b - a).cwiseQuotient(seabed->grid().spacing());
                        const double slack = 0.1 * mostBetweenNodes + std::abs(b.z() - a.z()) / (10.0 * cells.norm());
                        EXPECT_LE(seen, exact + slack) << a.transpose() << " to " << b.transpose();
                        EXPECT_TRUE(!arena.isFree(a, b) || judge.judge({a, b}).isSafe)
                            << a.transpose() << " to " << b.transpose();
                    }
                });
}

// The same dives over the same raster, once with the library's reader and frame, once with neither.
TEST(DiveJudge, agreesWithTheRasterAsGdalReadsIt)
{
    const TemporaryFolder folder;
    Random random(11);
    SCOPED_TRACE(random.seedText());
    TestRaster raster;
    raster.columns = 40;
    raster.rows = 30;
    raster.epsg = 4326;
    raster.transform = {10.0, 0.002, 0.0, 45.0, 0.0, -0.001};
    for (int i = 0; i < raster.columns * raster.rows; ++i)
        raster.values.push_back(-random.real(30.0, 60.0));
    writeRaster(folder / "seabed.tif", raster);
    demos::DiveOptions options;
    options.bathymetry = (folder / "seabed.tif").string();
    const auto seabed = demos::readRaster(options).depths;
    const DiveArena arena(seabed, {5.0, 1.0});
    const Judge judge(*seabed, arena.limits());
    const seahex::test::DiveJudge other(folder / "seabed.tif");
    int safe = 0;
    int unsafe = 0;
    for (int i = 0; i < 300; ++i)
    {
        const Point3 a = anyPosition(random, arena);
        EXPECT_NEAR(judge.judge({a}).leastWaterM, other.waterBelow(a), 1e-4) << a.transpose();
        Point3 b = a + 0.2 * (anyPosition(random, arena) - a);
        const DiveVerdict verdict = judge.judge({a, b});
        if (std::abs(verdict.leastWaterM - 5.0) < 0.5)
            continue;  // their samples lie elsewhere
        EXPECT_EQ(verdict.isSafe, other.fault({a, b}, 5.0, 1.0).empty()) << a.transpose() << " to " << b.transpose();
        ++(verdict.isSafe ? safe : unsafe);
    }
    EXPECT_GT(safe, 50);
    EXPECT_GT(unsafe, 50);
}

/// Numbers of cells that hang together, by joining neighbours until nothing changes: 0 where a node is too shallow.
std::vector<int> joined(const Bathymetry &seabed, double leastDepthM)
{
    const int columns = static_cast<int>(seabed.grid().columns()) - 1;
    const int rows = static_cast<int>(seabed.grid().rows()) - 1;
    std::vector<int> number(static_cast<std::size_t>(columns * rows));
    const auto at = [&](int c, int r) -> int &
    {
        return number[static_cast<std::size_t>(r * columns + c)];
    };
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
        {
            // a little less than the cell: its sides may touch cells without depth
            const Point inner = 1e-6 * seabed.grid().spacing();
            const Box cell{seabed.grid().node(c, r) + inner, seabed.grid().node(c + 1, r + 1) - inner};
            const double shallowest = seabed.leastDepth(cell);
            at(c, r) = shallowest >= leastDepthM ? r * columns + c + 1 : 0;
        }
    for (bool changes = true; changes;)
    {
        changes = false;
        const auto join = [&](int &a, int &b)
        {
            if (a == 0 || b == 0 || a == b)
                return;
            a = b = std::min(a, b);
            changes = true;
        };
        for (int r = 0; r < rows; ++r)
            for (int c = 0; c < columns; ++c)
            {
                if (c + 1 < columns)
                    join(at(c, r), at(c + 1, r));
                if (r + 1 < rows)
                    join(at(c, r), at(c, r + 1));
            }
    }
    return number;
}

TEST(DeepWater, isTheLargestThatHangsTogether)
{
    forEachSeed(60,
                [](Random &random)
                {
                    const auto seabed = randomSeabed(random, 14, 11, 0.02);
                    const double leastDepthM = random.real(0.0, 30.0);
                    const DeepWater water(*seabed, leastDepthM);
                    const std::vector<int> numbers = joined(*seabed, leastDepthM);
                    std::int64_t largest = 0;
                    for (const int number : std::set<int>(numbers.begin(), numbers.end()))
                        largest = std::max<std::int64_t>(
                            largest, number == 0 ? 0 : std::count(numbers.begin(), numbers.end(), number));
                    EXPECT_EQ(water.cellCount(), largest);
                    std::set<int> contained;
                    std::int64_t count = 0;
                    for (int row = 0; row < 10; ++row)
                        for (int column = 0; column < 13; ++column)
                        {
                            const Point middle =
                                0.5 * (seabed->grid().node(column, row) + seabed->grid().node(column + 1, row + 1));
                            if (!water.contains(middle))
                                continue;
                            contained.insert(numbers[static_cast<std::size_t>(row * 13 + column)]);
                            ++count;
                        }
                    EXPECT_EQ(count, largest);
                    EXPECT_LE(contained.size(), 1u) << "waters that don't hang together";
                    EXPECT_EQ(contained.count(0), 0u) << "shallow cells";
                });
}

TEST(DivePairs, lieInFreeWaterInAllHeadings)
{
    const auto seabed = ridge();
    const DiveArena arena(seabed, {5.0, 3.0, 90.0});
    const demos::PairRules rules{12, 0.3, 7};
    const std::vector<DivePair> pairs = drawDivePairs(arena, rules);
    ASSERT_EQ(pairs.size(), 12u);
    for (std::size_t k = 0; k < pairs.size(); ++k)
    {
        const DivePair &pair = pairs[k];
        EXPECT_EQ(pair.number, k + 1);
        EXPECT_TRUE(arena.isFree(pair.start)) << k;
        EXPECT_TRUE(arena.isFree(pair.goal)) << k;
        EXPECT_EQ(pair.isSeabedInTheWay, !arena.isFree(pair.start, pair.goal)) << k;
        EXPECT_GE(pair.onChart().courseDeg(), 30.0 * static_cast<double>(k));
        EXPECT_LE(pair.onChart().courseDeg(), 30.0 * static_cast<double>(k + 1));
        EXPECT_GE(pair.onChart().distance(), 0.3 * 5000.0);
    }
    const auto inTheWay =
        std::count_if(pairs.begin(), pairs.end(), [](const DivePair &p) { return p.isSeabedInTheWay; });
    EXPECT_GT(inTheWay, 6);
    const std::vector<DivePair> again = drawDivePairs(arena, rules);
    const std::vector<DivePair> others = drawDivePairs(arena, {12, 0.3, 8});
    EXPECT_EQ(again.back().goal, pairs.back().goal);
    EXPECT_NE(others.back().goal, pairs.back().goal);
}

TEST(DivePairs, areDrawnOverAnEvenSeabedToo)
{
    const NodeGrid grid(Point(0.0, 0.0), Point(100.0, 100.0), 5, 5);
    const DiveArena deep(std::make_shared<const Bathymetry>(grid, std::vector<float>(25, 50.0f)), {5.0, 0.0});
    for (const DivePair &pair : drawDivePairs(deep, {4, 0.3, 1}))
        EXPECT_FALSE(pair.isSeabedInTheWay);
    EXPECT_THROW(drawDivePairs(deep, {4, 0.99, 1}), demos::Failure) << "no pair is so far apart in all headings";
}

TEST(DivePairs, lieInOneWater)
{
    // Land along column 12; the water to its east is the smaller one.
    const NodeGrid grid(Point(0.0, 0.0), Point(100.0, 100.0), 21, 21);
    std::vector<float> depths;
    for (int row = 0; row < 21; ++row)
        for (int column = 0; column < 21; ++column)
            depths.push_back(column == 12 ? -5.0f : 50.0f);
    const DiveArena arena(std::make_shared<const Bathymetry>(grid, depths), {5.0, 0.0});
    for (const DivePair &pair : drawDivePairs(arena, {8, 0.1, 1}))
    {
        EXPECT_LT(pair.start.x(), 1200.0);
        EXPECT_LT(pair.goal.x(), 1200.0);
    }
}

/// A checker that finds no fault with anything.
class Blind : public ob::StateValidityChecker
{
public:
    using ob::StateValidityChecker::StateValidityChecker;
    bool isValid(const ob::State *) const override { return true; }
};

class BlindMotions : public ob::MotionValidator
{
public:
    using ob::MotionValidator::MotionValidator;
    bool checkMotion(const ob::State *, const ob::State *) const override { return true; }
    bool checkMotion(const ob::State *, const ob::State *, std::pair<ob::State *, double> &) const override
    {
        return true;
    }
};

/// A problem across the ridge, and paths that were made up.
class DiveRunJudge : public testing::Test
{
protected:
    DiveRunJudge() { setup_->getSpaceInformation()->setup(); }

    std::optional<double> judge(const std::vector<Point3> &points)
    {
        const auto path = std::make_shared<og::PathGeometric>(setup_->getSpaceInformation());
        for (const Point3 &p : points)
        {
            ob::ScopedState<> state(setup_->getStateSpace());
            placeInWater(state.get(), p);
            path->append(state.get());
        }
        setup_->getProblemDefinition()->clearSolutionPaths();
        setup_->getProblemDefinition()->addSolutionPath(path);
        run_.clear();
        return RunJudge(world_, *setup_).judge(run_);
    }

    Point3 start_{500.0, 1500.0, 60.0};
    Point3 goal_{3500.0, 1500.0, 60.0};
    std::shared_ptr<const DiveArena> arena_ = std::make_shared<const DiveArena>(ridge(), DiveLimits{5.0, 3.0});
    DiveWorld world_{"ridge",
                     arena_,
                     Projection::localEquirectangular(GeoPoint::fromLatLon(45.0, 10.0)),
                     {{1, start_, goal_, true}}};
    std::unique_ptr<og::SimpleSetup> setup_ = world_.makeSetup(1);
    ompl::tools::Benchmark::RunProperties run_;
};

TEST_F(DiveRunJudge, measuresTheDiveItself)
{
    const Point3 top(2000.0, 1500.0, 10.0);
    const double length = 2.0 * std::hypot(1500.0, 50.0);
    ASSERT_NEAR(judge({start_, top, goal_}).value_or(0.0), length, 1e-6);
    EXPECT_EQ(run_.at("valid BOOLEAN"), "1");
    EXPECT_EQ(run_.at("unsafe BOOLEAN"), "0");
    EXPECT_NEAR(std::stod(run_.at("length REAL")), length, 1e-4);
    EXPECT_EQ(run_.at("legs INTEGER"), "2");
    EXPECT_EQ(run_.at("turns INTEGER"), "1");
    EXPECT_NEAR(std::stod(run_.at("turn angle REAL")), 2.0 * std::atan2(50.0, 1500.0) * 180.0 / M_PI, 1e-6);
    EXPECT_NEAR(std::stod(run_.at("least clearance REAL")), 10.0, 1e-6);
}

TEST_F(DiveRunJudge, aDiveThroughTheSeabedIsUnsafeWhateverTheProblemsCheckersSay)
{
    const ompl::tools::Benchmark::RunProperties unsafe = {{"valid BOOLEAN", "0"}, {"unsafe BOOLEAN", "1"}};
    EXPECT_FALSE(judge({start_, goal_}));
    EXPECT_EQ(run_, unsafe);

    const ob::SpaceInformationPtr &si = setup_->getSpaceInformation();
    si->setStateValidityChecker(std::make_shared<Blind>(si));
    si->setMotionValidator(std::make_shared<BlindMotions>(si));
    EXPECT_FALSE(judge({start_, goal_}));
    EXPECT_EQ(run_, unsafe);
    EXPECT_TRUE(judge({start_, Point3(2000.0, 1500.0, 10.0), goal_}));
}

TEST_F(DiveRunJudge, aDiveToElsewhereIsNotValid)
{
    for (const std::vector<Point3> &dive :
         {std::vector<Point3>{start_, Point3(600.0, 1500.0, 60.0)}, {Point3(3400.0, 1500.0, 60.0), goal_}, {start_}})
    {
        EXPECT_FALSE(judge(dive));
        EXPECT_EQ(run_, (ompl::tools::Benchmark::RunProperties{{"valid BOOLEAN", "0"}}));
    }
}

TEST_F(DiveRunJudge, everyPlannerOfTheRosterDivesUnderItsOwnName)
{
    const std::vector<std::string> names = diveRosterNames();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    ASSERT_GE(names.size(), 9u);
    const ob::SpaceInformationPtr &si = setup_->getSpaceInformation();
    EXPECT_THROW(world_.makePlanner("HexAStar", 1, 1, si), std::out_of_range);
    setup_->getProblemDefinition()->getOptimizationObjective()->setCostThreshold(ob::Cost(INFINITY));
    for (const std::string &name : names)
    {
        SCOPED_TRACE(name);
        const auto planner = world_.makePlanner(name, 1, 1, si);
        EXPECT_EQ(planner->getName(), name);
        planner->setProblemDefinition(setup_->getProblemDefinition());
        planner->setTimeLimit(20.0);
        // In a process of its own, as in a campaign: some of OMPL's planners leak states.
        EXPECT_EXIT(
            {
                setup_->setPlanner(planner);
                const bool isSolved = planner->solve(30.0) == ob::PlannerStatus::EXACT_SOLUTION;
                _exit(isSolved && RunJudge(world_, *setup_).judge(run_) ? 0 : 1);
            },
            testing::ExitedWithCode(0), "");
    }
}

}  // namespace
