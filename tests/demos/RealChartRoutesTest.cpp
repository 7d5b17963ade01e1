// Routes on real charts, judged by ChartOracle, which shares no code with the library: not its reader, rules,
// projection, cells or geometry.

#include "seahex/seahex.h"

#include "support/ChartOracle.h"
#include "support/TestCharts.h"
#include "support/TestData.h"

#include <gtest/gtest.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <optional>
#include <set>

using namespace seahex;
using namespace seahex::test;

namespace fs = std::filesystem;
namespace og = ompl::geometric;

namespace
{

constexpr unsigned seed = 20240611;
constexpr std::size_t pairCount = 20;
constexpr double leastDepthM = 5.0;
constexpr double leastDistanceShare = 0.25;
/// Points keep a radius of 10 m from written legs; what the judge may be off by at this distance is a centimetre.
constexpr double pointRadiusM = 9.9;

GeoPoint position(const LatLon &p)
{
    return GeoPoint::fromLatLon(p.first, p.second);
}

std::vector<LatLon> latLons(const GeoRoute &route)
{
    std::vector<LatLon> positions;
    for (const GeoPoint &p : route.waypoints)
        positions.emplace_back(p.latitudeDeg(), p.longitudeDeg());
    return positions;
}

std::string trace(const LatLon &from, const LatLon &to)
{
    return "seed " + std::to_string(seed) + ": " + toString(position(from)) + " to " + toString(position(to));
}

std::string listed(const std::vector<Violation> &violations)
{
    std::string text;
    for (const Violation &violation : violations)
        text += "\n  leg " + std::to_string(violation.leg) + ": " + violation.what;
    return text;
}

/// A chart as the library and as the judge see it.
struct Scene
{
    Scene(const fs::path &file, const Vessel &vessel)
        : chart(readChart(file.string())), arena(chart, ArenaOptions{vessel, HazardScope::All, {}, {}, 0.0}),
          check(chart, arena), oracle(file.string(), {vessel.draughtM, vessel.underKeelClearanceM})
    {
        ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    }

    std::vector<std::pair<LatLon, LatLon>> pairs() const
    {
        return oracle.randomPairs(seed, pairCount, leastDepthM, leastDistanceShare);
    }

    Chart chart;
    ChartArena arena;
    WrittenRouteCheck check;
    ChartOracle oracle;
};

/// The lattice's best path and the shortest of the plane, as they are written.
struct WrittenRoutes
{
    GeoRoute raw;
    GeoRoute smoothed;
};

/// Empty where a cell of start or goal is blocked, or no water joins them at this cell size.
std::optional<WrittenRoutes> plan(const Scene &scene, const LatLon &from, const LatLon &to)
{
    const auto &occupancy = scene.arena.occupancy();
    const Projection &projection = scene.arena.projection();
    og::SimpleSetup setup(planarSpace(*occupancy));
    useOccupancy(setup, occupancy);
    setStartAndGoal(setup, projection.forward(position(from)), projection.forward(position(to)));
    const auto solve = [&](bool smoothing) -> std::optional<Route>
    {
        setup.clear();
        auto planner = std::make_shared<HexAStar>(setup.getSpaceInformation());
        planner->setSmoothing(smoothing);
        setup.setPlanner(planner);
        setup.setup();
        const ompl::base::PlannerStatus status = planner->solve(30.0);
        EXPECT_NE(planner->outcome(), PlanningOutcome::OutOfTime);
        if (status != ompl::base::PlannerStatus::EXACT_SOLUTION)
            return std::nullopt;
        EXPECT_EQ(planner->isProvenShortest(), smoothing);
        return routeFromPath(setup.getSolutionPath());
    };
    const std::optional<Route> path = solve(false);
    const std::optional<Route> shortest = solve(true);
    EXPECT_EQ(path.has_value(), shortest.has_value());
    if (!path || !shortest)
        return std::nullopt;
    return WrittenRoutes{toGeoRoute(*path, projection, position(from), position(to)),
                         toGeoRoute(*shortest, projection, position(from), position(to))};
}

/// What the judge says of one written route, and what the library's own check says.
void expectSafe(const Scene &scene, const GeoRoute &route, const LatLon &from, const LatLon &to)
{
    const std::vector<LatLon> written = latLons(route);
    ASSERT_GE(written.size(), 2u);
    EXPECT_EQ(written.front(), from);
    EXPECT_EQ(written.back(), to);
    const std::vector<Violation> plain = scene.oracle.violations(written);
    EXPECT_TRUE(plain.empty()) << listed(plain);
    const std::vector<Violation> wide = scene.oracle.violationsWithin(written, pointRadiusM);
    EXPECT_TRUE(wide.empty()) << listed(wide);
    const std::optional<LegFault> fault = scene.check.firstFault(route.waypoints);
    EXPECT_FALSE(fault) << "leg " << fault->leg << " " << fault->what;
}

/// The library's least clearance against the judge's. The library's edges may lie 0.25 m off (Projection), the judge's
/// distances are off by up to 0.1 % below 1 km and 1 % far away, and the frame's scale by 0.05 % at the charts'
/// corners.
void expectSameClearance(const Scene &scene, const GeoRoute &route)
{
    const double clearance = scene.check.leastClearanceM(route.waypoints);
    const NearestHazard judged = scene.oracle.nearestHazard(latLons(route));
    EXPECT_GT(clearance, 0.0);
    EXPECT_GE(clearance, scene.arena.vessel().marginM);
    EXPECT_NEAR(clearance, judged.distanceM, 0.3 + (judged.distanceM < 1000.0 ? 0.002 : 0.011) * judged.distanceM)
        << judged.what;
}

/// Everything of overhead and regulation that the judge finds on the route must be named. Tunnels lie below the seabed;
/// the judge lists them, the catalogue ignores them.
std::size_t expectCrossingsNamed(const Scene &scene, const GeoRoute &route)
{
    std::set<std::string> named;
    for (const HazardObject *object : scene.check.crossedCautions(route.waypoints))
        named.insert(object->objectClass + " " + object->featureId);
    const std::vector<std::string> crossed = scene.oracle.crossedOverheadAndRegulation(latLons(route));
    for (const std::string &object : crossed)
        EXPECT_TRUE(named.count(object) == 1 || object.rfind("TUNNEL ", 0) == 0)
            << object << " is crossed and not named";
    return crossed.size();
}

bool isOwn(const std::string &name)
{
    return name == "shangchuan" || name == "sanya";
}

/// One test a cell, so that they run beside each other.
class RealChartRoutes : public testing::TestWithParam<const char *>
{
protected:
    void SetUp() override
    {
        const std::string name = GetParam();
        if (isOwn(name))
        {
            file_ = fs::path(SEAHEX_MAPS_DIR) / (name + ".000");
            return;
        }
        SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
        file_ = charts / "noaa" / name / (name + ".000");
        if (!fs::exists(file_))
            GTEST_SKIP() << "there is no chart " << file_;
    }

    fs::path file_;
};

TEST_P(RealChartRoutes, groupOneTilesTheCoverage)
{
    const Chart chart = readChart(file_.string());
    ASSERT_EQ(chart.cells.size(), 1u);
    const GroupOneCheck &check = chart.cells[0].groupOne;
    EXPECT_TRUE(check.applicable);
    EXPECT_TRUE(check.tiles);
    EXPECT_EQ(check.twiceAreaDifference, "0");
    EXPECT_EQ(check.gapFraction, 0.0);
    const GroupOneSums sums = ChartOracle(file_.string(), {1.2, 0.5}).groupOneSums();
    EXPECT_GT(sums.coverage, 0);
    EXPECT_EQ(check.twiceAreaDifference, std::to_string(sums.difference()));
}

TEST_P(RealChartRoutes, noLegTouchesAnythingForbidden)
{
    const Scene scene(file_, Vessel());
    std::size_t routed = 0;
    std::size_t crossed = 0;
    double rawM = 0.0;
    double smoothedM = 0.0;
    for (const auto &[from, to] : scene.pairs())
    {
        SCOPED_TRACE(trace(from, to));
        const std::optional<WrittenRoutes> routes = plan(scene, from, to);
        if (!routes)
            continue;
        ++routed;
        for (const GeoRoute &route : {routes->raw, routes->smoothed})
        {
            expectSafe(scene, route, from, to);
            expectSameClearance(scene, route);
            crossed += expectCrossingsNamed(scene, route);
        }
        // shorter in the plane is shorter on the ellipsoid, but for what the plane bends
        EXPECT_LE(rhumbLengthM(routes->smoothed), rhumbLengthM(routes->raw) * (1.0 + 1e-6));
        rawM += rhumbLengthM(routes->raw);
        smoothedM += rhumbLengthM(routes->smoothed);
    }
    std::cout << GetParam() << ": " << routed << " of " << pairCount << " routed, raw " << rawM / 1000.0
              << " km, smoothed " << smoothedM / 1000.0 << " km, " << crossed << " crossings named\n";
    EXPECT_GE(2 * routed, pairCount) << "too few pairs are routed to say much";
}

// The control: both judges see a line that ends on land. Without it, the test above could not fail.
TEST_P(RealChartRoutes, linesOntoLandAreReported)
{
    const Scene scene(file_, Vessel());
    const auto pairs = scene.pairs();
    std::size_t lines = 0;
    for (const GeoHazard &hazard : scene.chart.hazards)
    {
        if (hazard.object->objectClass != "LNDARE" || hazard.shape.lonLat.areas.empty() || lines == pairCount)
            continue;
        const LatLon from = pairs[lines++].first;
        const Point lonLat = hazard.shape.lonLat.areas.front().outer().front();
        const GeoPoint corner = GeoPoint::fromLatLon(lonLat.y(), lonLat.x());
        const std::vector<Violation> violations =
            scene.oracle.violations({from, {corner.latitudeDeg(), corner.longitudeDeg()}});
        EXPECT_TRUE(std::any_of(violations.begin(), violations.end(),
                                [](const Violation &violation)
                                { return violation.what.find("LNDARE") != std::string::npos; }))
            << toString(position(from)) << " to " << toString(corner) << listed(violations);
        EXPECT_TRUE(scene.check.firstFault({position(from), corner}));
    }
    EXPECT_GT(lines, 0u) << "no land on this chart: this proves nothing";
}

// The library's own check is the last one before a route is given out: it must see whatever the judge sees, and nothing
// else.
TEST_P(RealChartRoutes, bothJudgesAgreeOnStraightLines)
{
    const Scene scene(file_, Vessel());
    const auto pairs = scene.pairs();
    std::size_t forbidden = 0;
    for (const auto &[from, unusedGoal] : pairs)
        for (const auto &[unusedStart, to] : pairs)
        {
            const std::vector<LatLon> line = {from, to};
            const std::vector<Violation> violations = scene.oracle.violationsWithin(line, pointRadiusM);
            const std::optional<LegFault> fault = scene.check.firstFault({position(from), position(to)});
            EXPECT_TRUE(fault || violations.empty())
                << trace(from, to) << ": the library's check is blind for" << listed(violations);
            // Lines keep a radius of 10 m too, which the judge does not know.
            EXPECT_TRUE(!fault || !violations.empty() || scene.oracle.nearestHazard(line).distanceM < 10.1)
                << trace(from, to) << ": there is no such fault: " << fault->what;
            forbidden += violations.empty() ? 0 : 1;
        }
    EXPECT_GT(forbidden, 0u) << "no straight line is forbidden: this proves nothing";
}

INSTANTIATE_TEST_SUITE_P(Cells, RealChartRoutes,
                         testing::Values("US4MD81M", "US5MD1MC", "US5MA12M", "US4AK3SB", "US3DE01M", "shangchuan",
                                         "sanya"),
                         [](const auto &cell) { return std::string(cell.param); });

class RealChartMargin : public RealChartRoutes
{
};

TEST_P(RealChartMargin, isKeptFromEveryHazard)
{
    Vessel vessel;
    vessel.marginM = 50.0;
    const Scene scene(file_, vessel);
    const Scene withoutMargin(file_, Vessel());
    std::size_t routed = 0;
    double leastWithoutM = std::numeric_limits<double>::infinity();
    for (const auto &[from, to] : scene.pairs())
    {
        SCOPED_TRACE(trace(from, to));
        const std::optional<WrittenRoutes> routes = plan(scene, from, to);
        if (!routes)
            continue;
        ++routed;
        for (const GeoRoute &route : {routes->raw, routes->smoothed})
        {
            expectSafe(scene, route, from, to);
            expectSameClearance(scene, route);
            const NearestHazard nearest = scene.oracle.nearestHazard(latLons(route));
            EXPECT_GE(nearest.distanceM, vessel.marginM * 0.999) << nearest.what;  // the judge is good to 0.1 %
        }
        const std::optional<WrittenRoutes> bold = plan(withoutMargin, from, to);
        ASSERT_TRUE(bold) << "what a margin leaves open is open without it";
        leastWithoutM = std::min(leastWithoutM, scene.oracle.nearestHazard(latLons(bold->smoothed)).distanceM);
    }
    EXPECT_GE(2 * routed, pairCount) << "too few pairs are routed to say much";
    EXPECT_LT(leastWithoutM, vessel.marginM) << "the routes keep this distance anyway: this proves nothing";
}

INSTANTIATE_TEST_SUITE_P(Cells, RealChartMargin, testing::Values("US5MA12M", "shangchuan"),
                         [](const auto &cell) { return std::string(cell.param); });

}  // namespace
