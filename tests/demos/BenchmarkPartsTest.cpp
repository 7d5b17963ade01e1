// The parts of benchmark_planners that can be looked at without running planners for seconds: which water, which pairs,
// how costs are noted, what a recorded planner makes of a planner that misbehaves.

#include "benchmark_planners/ChartWorld.h"
#include "benchmark_planners/Cores.h"
#include "benchmark_planners/CostHistory.h"
#include "benchmark_planners/RecordedPlanner.h"
#include "benchmark_planners/Roster.h"
#include "benchmark_planners/RunJudge.h"
#include "common/Arena.h"
#include "common/Failure.h"
#include "common/Pairs.h"
#include "common/Waters.h"
#include "support/AsciiWorld.h"

#include "support/HexOracle.h"
#include "support/PlanningWorlds.h"
#include "support/Random.h"

#include <ompl/base/PlannerData.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>
#include <seahex/planning/Setup.h>
#include <seahex/world/SegmentValidity.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <thread>

#include <unistd.h>

using namespace seahex;
using namespace seahex::test;
using namespace benchmark_planners;
using demos::drawPairs;
using demos::LargestWater;
using demos::Pair;
using demos::PairRules;

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace
{

/// Sets of cells that hang together, by joining cells that have distance 1: no neighbours' table, no stack.
std::vector<std::set<HexCoord>> watersOf(const HexOccupancy &occupancy)
{
    std::vector<std::set<HexCoord>> waters;
    for (std::int64_t row = 0; row < occupancy.lattice().rows(); ++row)
        for (std::int64_t column = 0; column < occupancy.lattice().columns(); ++column)
        {
            const HexCoord cell = toCube({column, row});
            if (occupancy.isBlocked(cell))
                continue;
            std::set<HexCoord> joined = {cell};
            std::vector<std::set<HexCoord>> others;
            for (std::set<HexCoord> &water : waters)
            {
                const bool touches = std::any_of(water.begin(), water.end(),
                                                 [cell](HexCoord other) { return hexDistance(cell, other) == 1; });
                if (touches)
                    joined.insert(water.begin(), water.end());
                else
                    others.push_back(std::move(water));
            }
            others.push_back(std::move(joined));
            waters = std::move(others);
        }
    return waters;
}

TEST(LargestWater, isTheLargerOfTwo)
{
    const AsciiWorld world(R"(
         a . # . . #
        . # # . b #
         # # . # . #
    )");
    const LargestWater water(world.occupancy());
    EXPECT_EQ(water.cellCount(), 6);
    EXPECT_TRUE(water.contains(toOffset(world.cell('b'))));
    EXPECT_FALSE(water.contains(toOffset(world.cell('a'))));
    EXPECT_FALSE(water.contains({-1, 0}));
    EXPECT_FALSE(water.contains({1000, 1000}));
}

TEST(LargestWater, isALargestSetOfCellsThatHangTogether)
{
    forEachSeed(30,
                [](Random &random)
                {
                    const HexLattice lattice(Point::Zero(), 1.0, random.integer(1, 14), random.integer(1, 14));
                    const auto occupancy = randomOccupancy(random, lattice, random.real(0.2, 0.7));
                    const LargestWater water(*occupancy);
                    std::size_t most = 0;
                    for (const std::set<HexCoord> &cells : watersOf(*occupancy))
                    {
                        most = std::max(most, cells.size());
                        const auto inside =
                            std::count_if(cells.begin(), cells.end(),
                                          [&water](HexCoord cell) { return water.contains(toOffset(cell)); });
                        EXPECT_TRUE(inside == 0 || static_cast<std::size_t>(inside) == cells.size());
                        EXPECT_TRUE(inside == 0 || water.cellCount() == inside);
                    }
                    EXPECT_EQ(static_cast<std::size_t>(water.cellCount()), most);
                });
}

TEST(Pairs, areWhatTheyPromise)
{
    forEachSeed(8,
                [](Random &random)
                {
                    const HexLattice lattice(Point(-300.0, 500.0), 2.0, 60, 70);
                    const auto occupancy = randomOccupancy(random, lattice, random.real(0.01, 0.25));
                    const LargestWater water(*occupancy);
                    const PairRules rules = {16, 0.3, static_cast<std::uint32_t>(random.integer(0, 1 << 30))};
                    const std::vector<Pair> pairs = drawPairs(*occupancy, water, rules);
                    const double diagonal = (lattice.bounds().max - lattice.bounds().min).norm();
                    ASSERT_EQ(pairs.size(), 16u);
                    int offCentre = 0;
                    for (std::size_t k = 0; k < pairs.size(); ++k)
                    {
                        const Pair &pair = pairs[k];
                        EXPECT_EQ(pair.number, k + 1);
                        EXPECT_GE(pair.distance(), 0.3 * diagonal);
                        EXPECT_FALSE(isFree(*occupancy, pair.start, pair.goal));
                        for (const Point &end : {pair.start, pair.goal})
                        {
                            EXPECT_TRUE(isFree(*occupancy, end, end));
                            EXPECT_TRUE(water.contains(toOffset(lattice.cellAt(end))));
                            offCentre += (end - lattice.centre(lattice.cellAt(end))).norm() > 0.1 ? 1 : 0;
                        }
                        // The course as navigators count it: north is +y, clockwise.
                        const double course = pair.courseDeg() * M_PI / 180.0;
                        EXPECT_NEAR(pair.start.x() + pair.distance() * std::sin(course), pair.goal.x(), 1e-6);
                        EXPECT_NEAR(pair.start.y() + pair.distance() * std::cos(course), pair.goal.y(), 1e-6);
                        EXPECT_GE(pair.courseDeg(), 22.5 * static_cast<double>(k) - 1e-9);
                        EXPECT_LE(pair.courseDeg(), 22.5 * static_cast<double>(k + 1) + 1e-9);
                    }
                    EXPECT_GT(offCentre, 20);

                    const std::vector<Pair> again = drawPairs(*occupancy, water, rules);
                    const std::vector<Pair> other = drawPairs(*occupancy, water, {16, 0.3, rules.seed + 1});
                    EXPECT_EQ(again[3].start, pairs[3].start);
                    EXPECT_EQ(again[15].goal, pairs[15].goal);
                    EXPECT_NE(other[3].start, pairs[3].start);
                });
}

TEST(Pairs, thatCanNotBeDrawnAreRefused)
{
    const auto blocked = occupancyWith(HexLattice(Point::Zero(), 1.0, 1, 1), {toCube({0, 0})});
    EXPECT_THROW(drawPairs(*blocked, LargestWater(*blocked), {1, 0.1, 1}), demos::Failure);
}

std::vector<std::pair<double, double>> improvements(const CostHistory &history)
{
    std::vector<std::pair<double, double>> rows;
    for (const TimedCost &c : history.improvements())
        rows.emplace_back(c.seconds, c.cost);
    return rows;
}

using Rows = std::vector<std::pair<double, double>>;

TEST(CostHistory, keepsWhatIsBetterInTheOrderOfTime)
{
    CostHistory history;
    history.add(0.3, 8.0);
    history.add(0.1, 10.0);  // told late, by another thread
    history.add(0.2, 11.0);
    history.add(0.4, 8.0);
    history.add(0.5, INFINITY);
    history.add(0.6, NAN);
    history.add(0.7, 5.0);
    EXPECT_EQ(improvements(history), (Rows{{0.1, 10.0}, {0.3, 8.0}, {0.7, 5.0}}));
}

TEST(CostHistory, aClaimThatWasNotDeliveredCountsAsWhatWas)
{
    CostHistory history;
    history.add(0.1, 10.0);
    history.add(0.2, 4.0);
    history.finish(1.0, 7.0);
    EXPECT_EQ(improvements(history), (Rows{{0.1, 10.0}, {0.2, 7.0}}));
}

TEST(CostHistory, endsWithTheCostOfThePath)
{
    CostHistory history;
    history.finish(1.0, 7.0);
    EXPECT_EQ(improvements(history), (Rows{{1.0, 7.0}}));
    history.add(0.5, 9.0);
    EXPECT_EQ(improvements(history), (Rows{{0.5, 9.0}, {1.0, 7.0}}));
    history.clear();
    EXPECT_TRUE(history.improvements().empty());
}

/// A planner that does as it is told.
class Puppet : public ob::Planner
{
public:
    using Play = std::function<ob::PlannerStatus(Puppet &, const ob::PlannerTerminationCondition &)>;

    Puppet(const ob::SpaceInformationPtr &si, Play play) : ob::Planner(si, "Puppet"), play_(std::move(play)) {}

    ob::PlannerStatus solve(const ob::PlannerTerminationCondition &ptc) override { return play_(*this, ptc); }

    void report(double cost) { pdef_->getIntermediateSolutionCallback()(this, {}, ob::Cost(cost)); }
    void answer(const std::vector<Point> &points)
    {
        const auto path = std::make_shared<og::PathGeometric>(si_);
        for (const Point &p : points)
            path->append(stateAt(si_, p).get());
        pdef_->addSolutionPath(path);
    }
    void showCost(const std::function<std::string()> &read)
    {
        addPlannerProgressProperty("best cost DOUBLE", read);
        addPlannerProgressProperty("trap INTEGER", [this] { return std::to_string(++trapped); });
    }

    int trapped = 0;

private:
    Play play_;
};

class RecordedPlannerTest : public testing::Test
{
protected:
    RecordedPlannerTest()
    {
        problem_->setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si_));
    }

    std::shared_ptr<RecordedPlanner> record(Puppet::Play play, Finish finish = Finish::None)
    {
        puppet_ = std::make_shared<Puppet>(si_, std::move(play));
        return recordPuppet(finish);
    }
    std::shared_ptr<RecordedPlanner> recordPuppet(Finish finish = Finish::None)
    {
        auto planner = std::make_shared<RecordedPlanner>("recorded", puppet_, finish);
        planner->setProblemDefinition(problem_);
        return planner;
    }

    std::shared_ptr<const HexOccupancy> open_ = occupancyWith(HexLattice(Point(-1.0, 21.0), 1.0, 30, 30), {});
    ob::SpaceInformationPtr si_ = chartSpace(open_);
    ob::ProblemDefinitionPtr problem_ = problemBetween(si_, {2.0, 2.0}, {20.0, 2.0});
    std::shared_ptr<Puppet> puppet_;
};

TEST_F(RecordedPlannerTest, notesWhatIsReportedWhenItIsReported)
{
    const auto planner = record(
        [](Puppet &puppet, const ob::PlannerTerminationCondition &)
        {
            puppet.report(40.0);
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            puppet.report(30.0);
            return ob::PlannerStatus::EXACT_SOLUTION;
        });
    EXPECT_EQ(planner->solve(1.0), ob::PlannerStatus::EXACT_SOLUTION);
    const std::vector<TimedCost> rows = planner->history().improvements();
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].cost, 40.0);
    EXPECT_EQ(rows[1].cost, 30.0);
    EXPECT_GE(rows[1].seconds - rows[0].seconds, 0.02);
    EXPECT_GE(planner->wallSeconds(), rows[1].seconds);

    EXPECT_FALSE(problem_->getIntermediateSolutionCallback());
    planner->clear();
    EXPECT_TRUE(planner->history().improvements().empty());
}

TEST_F(RecordedPlannerTest, readsTheBestCostOfAPlannerThatReportsNone)
{
    std::atomic<double> cost{INFINITY};
    puppet_ = std::make_shared<Puppet>(si_,
                                       [&cost](Puppet &, const ob::PlannerTerminationCondition &)
                                       {
                                           for (const double next : {50.0, 25.0})
                                           {
                                               std::this_thread::sleep_for(std::chrono::milliseconds(30));
                                               cost = next;
                                           }
                                           std::this_thread::sleep_for(std::chrono::milliseconds(30));
                                           return ob::PlannerStatus::EXACT_SOLUTION;
                                       });
    puppet_->showCost([&cost] { return std::to_string(cost.load()); });
    const auto planner = recordPuppet();
    planner->solve(1.0);
    const std::vector<TimedCost> rows = planner->history().improvements();
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].cost, 50.0);
    EXPECT_EQ(rows[1].cost, 25.0);
    EXPECT_EQ(puppet_->trapped, 0) << "another property was read while the planner ran";
    EXPECT_TRUE(planner->getPlannerProgressProperties().empty());
    ob::PlannerData data(si_);
    planner->getPlannerData(data);
    EXPECT_EQ(data.properties.at("trap INTEGER"), "1");
}

TEST_F(RecordedPlannerTest, doesNotReadTheCostOfAPlannerThatReportsIt)
{
    puppet_ = std::make_shared<Puppet>(si_,
                                       [](Puppet &puppet, const ob::PlannerTerminationCondition &)
                                       {
                                           puppet.report(40.0);
                                           std::this_thread::sleep_for(std::chrono::milliseconds(20));
                                           return ob::PlannerStatus::EXACT_SOLUTION;
                                       });
    puppet_->showCost([] { return "39.9"; });  // the same, but rounded
    const auto planner = recordPuppet();
    planner->solve(1.0);
    ASSERT_EQ(planner->history().improvements().size(), 1u);
    EXPECT_EQ(planner->history().improvements()[0].cost, 40.0);
}

TEST_F(RecordedPlannerTest, holdsThePlannerToItsLimit)
{
    const auto planner = record(
        [](Puppet &, const ob::PlannerTerminationCondition &ptc)
        {
            const auto muchLater = std::chrono::steady_clock::now() + std::chrono::seconds(20);
            while (!ptc)
                if (std::chrono::steady_clock::now() > muchLater)
                    return ob::PlannerStatus::ABORT;
            return ob::PlannerStatus::TIMEOUT;
        });
    planner->setTimeLimit(0.03);
    EXPECT_EQ(planner->solve(ob::plannerNonTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
    EXPECT_GE(planner->wallSeconds(), 0.03);
    EXPECT_GT(planner->processorSeconds(), 0.0);

    planner->setTimeLimit(1e6);
    EXPECT_EQ(planner->solve(ob::plannerAlwaysTerminatingCondition()), ob::PlannerStatus::TIMEOUT);
}

TEST_F(RecordedPlannerTest, anExceptionIsACrashAndNoMore)
{
    const auto planner = record([](Puppet &, const ob::PlannerTerminationCondition &) -> ob::PlannerStatus
                                { throw std::logic_error("on purpose"); });
    testing::internal::CaptureStderr();
    EXPECT_EQ(planner->solve(1.0), ob::PlannerStatus::CRASH);
    EXPECT_NE(testing::internal::GetCapturedStderr().find("on purpose"), std::string::npos);
}

TEST_F(RecordedPlannerTest, simplificationIsPartOfTheRun)
{
    const Puppet::Play detour = [](Puppet &puppet, const ob::PlannerTerminationCondition &)
    {
        puppet.answer({{2.0, 2.0}, {11.0, 12.0}, {20.0, 2.0}});
        return ob::PlannerStatus::EXACT_SOLUTION;
    };
    const double straight = 18.0;
    const double detourLength = 2.0 * std::hypot(9.0, 10.0);

    record(detour)->solve(1.0);
    EXPECT_NEAR(problem_->getSolutionPath()->length(), detourLength, 1e-9);

    problem_->clearSolutionPaths();
    const auto planner = record(detour, Finish::Simplify);
    planner->solve(1.0);
    EXPECT_NEAR(problem_->getSolutionPath()->length(), straight, 1e-6);
    EXPECT_EQ(problem_->getSolutionCount(), 1u);
    ASSERT_EQ(planner->history().improvements().size(), 1u);
    EXPECT_NEAR(planner->history().improvements()[0].cost, detourLength, 1e-9);
}

TEST_F(RecordedPlannerTest, everyPlannerOfTheRosterSolvesUnderItsOwnName)
{
    ASSERT_GE(rosterNames().size(), 12u);
    EXPECT_THROW(makeFromRoster("NoSuchPlanner", si_), std::out_of_range);
    problem_->getOptimizationObjective()->setCostThreshold(ob::Cost(INFINITY));  // the first solution will do
    for (const std::string &name : rosterNames())
    {
        SCOPED_TRACE(name);
        const auto planner = makeFromRoster(name, si_);
        EXPECT_EQ(planner->getName(), name);
        planner->setProblemDefinition(problem_);
        planner->setTimeLimit(20.0);
        // In a process of its own, as in a campaign: some of OMPL's planners leak states.
        EXPECT_EXIT(
            {
                const bool isSolved = planner->solve(30.0) == ob::PlannerStatus::EXACT_SOLUTION;
                _exit(isSolved && pathOf(problem_)->check() ? 0 : 1);
            },
            testing::ExitedWithCode(0), "");
    }
}

/// A problem on a chart of the project's own, and paths that were made up.
class RunJudgeTest : public testing::Test
{
protected:
    RunJudgeTest()
    {
        useOccupancy(setup_, world_.arena().occupancy());
        setStartAndGoal(setup_, start_, goal_);
        setup_.getSpaceInformation()->setup();
    }

    static ChartWorld makeWorld()
    {
        const auto chart = demos::readChart({(std::filesystem::path(SEAHEX_MAPS_DIR) / "shangchuan.000").string()});
        ArenaOptions options;
        options.pitch = 400.0;
        return {chart, demos::makeArena(*chart, options)};
    }
    Point at(double latitude, double longitude) const
    {
        return world_.arena().projection().forward(GeoPoint::fromLatLon(latitude, longitude));
    }
    /// A place from which both start and goal are seen.
    Point pointPast() const
    {
        const HexOccupancy &occupancy = *world_.arena().occupancy();
        for (int i = 0; i < 70; ++i)
            for (int j = 0; j < 35; ++j)
            {
                Point p = at(21.55 + 0.005 * i, 112.7 + 0.01 * j);
                if (isFree(occupancy, start_, p) && isFree(occupancy, p, goal_))
                    return p;
            }
        throw std::logic_error("there is no such place");
    }
    std::optional<double> judge(const std::vector<Point> &points, bool isApproximate = false)
    {
        const auto path = std::make_shared<og::PathGeometric>(setup_.getSpaceInformation());
        for (const Point &p : points)
            path->append(stateAt(setup_.getSpaceInformation(), p).get());
        setup_.getProblemDefinition()->clearSolutionPaths();
        setup_.getProblemDefinition()->addSolutionPath(path, isApproximate, isApproximate ? 1.0 : 0.0);
        run_.clear();
        return RunJudge(world_, setup_).judge(run_);
    }

    ChartWorld world_ = makeWorld();
    Point start_ = at(21.825, 112.686);
    Point goal_ = at(21.617, 113.064);  // straight ahead lies an island
    Point past_ = pointPast();
    og::SimpleSetup setup_{planarSpace(*world_.arena().occupancy())};
    ompl::tools::Benchmark::RunProperties run_;
};

TEST_F(RunJudgeTest, measuresTheLineItself)
{
    const double length = (past_ - start_).norm() + (goal_ - past_).norm();
    const std::optional<double> cost = judge({start_, past_, goal_});
    ASSERT_TRUE(cost);
    EXPECT_NEAR(*cost, length, 1e-6);
    EXPECT_EQ(run_.at("valid BOOLEAN"), "1");
    EXPECT_NEAR(std::stod(run_.at("length REAL")), length, 1e-4);
    EXPECT_EQ(run_.at("legs INTEGER"), "2");
    EXPECT_EQ(run_.at("turns INTEGER"), "1");
    const Point in = past_ - start_;
    const Point out = goal_ - past_;
    const double turn = std::acos(in.dot(out) / in.norm() / out.norm()) * 180.0 / M_PI;
    EXPECT_NEAR(std::stod(run_.at("turn angle REAL")), turn, 1e-6);
    const double clearance = std::stod(run_.at("least clearance REAL"));
    EXPECT_GT(clearance, 0.0);

    // More vertices on the same line change nothing but the number of legs.
    EXPECT_NEAR(judge({start_, 0.5 * (start_ + past_), past_, goal_}).value(), length, 1e-6);
    EXPECT_EQ(run_.at("legs INTEGER"), "3");
    EXPECT_EQ(run_.at("turns INTEGER"), "1");
    EXPECT_NEAR(std::stod(run_.at("least clearance REAL")), clearance, 0.5);
}

TEST_F(RunJudgeTest, aPathThatIsNotValidHasNoMetrics)
{
    for (const std::vector<Point> &path : {std::vector<Point>{start_, goal_},          // over the island
                                           std::vector<Point>{start_, past_},          // not to the goal
                                           std::vector<Point>{past_, goal_},           // not from the start
                                           std::vector<Point>{start_, past_, start_},  // back again
                                           std::vector<Point>{start_}})
    {
        EXPECT_FALSE(judge(path));
        EXPECT_EQ(run_, (ompl::tools::Benchmark::RunProperties{{"valid BOOLEAN", "0"}}));
    }
    EXPECT_FALSE(judge({start_, past_, goal_}, true)) << "approximate";
    EXPECT_TRUE(run_.empty());
}

TEST(Roster, latticePlannersAreRawAndTheDefaultIsNot)
{
    const auto open = occupancyWith(HexLattice(Point::Zero(), 1.0, 10, 10), {});
    const auto parameters = [si = chartSpace(open)](const char *name)
    {
        std::map<std::string, std::string> all;
        makeFromRoster(name, si)->params().getParams(all);
        return std::vector<std::string>{all.at("rings"), all.at("anytime"), all.at("smoothing")};
    };
    EXPECT_EQ(parameters("HexAStar"), (std::vector<std::string>{"3", "1", "1"}));
    EXPECT_EQ(parameters("HexAStar-1"), (std::vector<std::string>{"1", "0", "0"}));
    EXPECT_EQ(parameters("HexAStar-2"), (std::vector<std::string>{"2", "0", "0"}));
    EXPECT_EQ(parameters("HexAStar-3"), (std::vector<std::string>{"3", "0", "0"}));
}

TEST(Cores, noTwoLeasesShareOne)
{
    // Another benchmark on this machine may take and give back cores meanwhile.
    const std::vector<int> allowed = allowedCores();
    std::vector<CoreLease> leases;
    std::set<int> cores;
    for (std::size_t i = 0; i < allowed.size(); ++i)
    {
        leases.push_back(CoreLease::take());
        if (!leases.back().hasCore())
            continue;
        EXPECT_NE(std::find(allowed.begin(), allowed.end(), leases.back().core()), allowed.end());
        EXPECT_TRUE(cores.insert(leases.back().core()).second);
    }
    const bool hasAll = cores.size() == allowed.size();
    EXPECT_TRUE(!hasAll || !CoreLease::take().hasCore());
    leases.clear();
    bool hasOne = false;
    for (int i = 0; i < 6000 && !hasOne; ++i)
    {
        hasOne = CoreLease::take().hasCore();
        std::this_thread::sleep_for(std::chrono::milliseconds(hasOne ? 0 : 10));
    }
    EXPECT_TRUE(hasOne);
}

}  // namespace
