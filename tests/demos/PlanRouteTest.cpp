// plan_route as people run it: the published scenario, every option, and what it prints and writes. Each route is
// judged by ChartOracle. What it refuses is in PlanRouteRefusalTest.cpp.

#include "demos/PlanRoute.h"

#include <cpl_minixml.h>

#include <cmath>
#include <cstdlib>
#include <memory>

using namespace seahex::test;

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

const LatLon from{21.635, 112.521};
const LatLon to{21.669, 112.901};

void expectKeys(const Json &object, const std::vector<const char *> &keys)
{
    ASSERT_TRUE(object.is_object());
    for (const char *key : keys)
        EXPECT_TRUE(object.contains(key)) << key << " is missing in " << object.dump(1);
}

double number(const Json &report, const char *route, const char *key)
{
    return report.at(route).at(key).get<double>();
}

TEST(PlanRoute, jsonHasEveryFieldOfTheContract)
{
    const Json report = routeReport(aroundShangchuan());
    expectKeys(report, {"status", "planner", "raw", "smoothed", "expanded", "search_ms", "chart", "lattice",
                        "start_cell", "goal_cell"});
    EXPECT_EQ(report.at("status"), "route");
    EXPECT_EQ(report.at("planner"), "HexAStar");
    EXPECT_GT(report.at("expanded"), 0);
    EXPECT_GT(report.at("search_ms"), 0.0);
    EXPECT_EQ(report.at("improvable"), false);
    expectKeys(report.at("chart"), {"cells", "features_used", "features_skipped", "read_ms"});
    ASSERT_EQ(report.at("chart").at("cells").size(), 1u);
    EXPECT_EQ(report.at("chart").at("cells").at(0).at("name"), "shangchuan");
    expectKeys(report.at("lattice"), {"pitch", "columns", "rows", "blocked", "build_ms"});
    EXPECT_EQ(report.at("start_cell").size(), 3u);
    EXPECT_EQ(report.at("goal_cell").size(), 3u);
    for (const char *name : {"raw", "smoothed"})
    {
        const Json &route = report.at(name);
        expectKeys(route, {"length_m", "length_nm", "length_cells", "length_lattice", "turns", "turn_angle_deg",
                           "min_clearance_m", "potential_hazards", "waypoints"});
        EXPECT_NEAR(route.at("length_nm").get<double>() * 1852.0, route.at("length_m").get<double>(), 1e-6);
        EXPECT_EQ(waypoints(route).front(), from);
        EXPECT_EQ(waypoints(route).back(), to);
        EXPECT_GT(route.at("min_clearance_m").get<double>(), 0.0);
    }
    EXPECT_LT(number(report, "smoothed", "length_m"), number(report, "raw", "length_m"));
    EXPECT_LT(number(report, "smoothed", "turns"), number(report, "raw", "turns"));
    expectSafe(report, ChartOracle(shangchuan(), {1.2, 0.5}));
}

TEST(PlanRoute, publishedScenarioGivesThePublishedNumbers)
{
    std::vector<Json> byRings;
    for (const char *rings : {"1", "2", "3"})
    {
        byRings.push_back(routeReport({"--scenario", "cheng2020", "--rings", rings}));
        const Json &report = byRings.back();
        ASSERT_TRUE(report.is_object());
        EXPECT_EQ(report.at("start_cell"), Json({-52, -62, 114}));
        EXPECT_EQ(report.at("goal_cell"), Json({63, -166, 103}));
        EXPECT_EQ(report.at("lattice").at("columns"), 143);
        EXPECT_EQ(report.at("lattice").at("rows"), 159);
        EXPECT_EQ(waypoints(report.at("raw")).front(), from);
        EXPECT_EQ(waypoints(report.at("smoothed")).back(), to);
    }
    EXPECT_NEAR(number(byRings[0], "raw", "length_lattice"), 146.0, 0.03 * 146.0);
    for (const std::size_t more : {1, 2})
    {
        EXPECT_LT(number(byRings[more], "raw", "turns"), number(byRings[0], "raw", "turns"));
        EXPECT_LT(number(byRings[more], "raw", "turn_angle_deg"), number(byRings[0], "raw", "turn_angle_deg"));
    }
}

TEST(PlanRoute, textNamesWhatMatters)
{
    const ProgramResult result = planRoute(aroundShangchuan());
    ASSERT_EQ(result.exitCode, 0) << result.summary();
    EXPECT_EQ(result.err, "");
    for (const char *words : {"shangchuan", "1:50000", "pitch", "HexAStar", "NM", "nearest hazard", "turns"})
        EXPECT_NE(result.out.find(words), std::string::npos) << words << " is not in\n" << result.out;
}

TEST(PlanRoute, helpNamesEveryOption)
{
    const ProgramResult result = planRoute({"--help"});
    EXPECT_EQ(result.exitCode, 0);
    EXPECT_EQ(result.err, "");
    for (const char *option : {"--help",    "--chart", "--from",     "--to",           "--draught",  "--ukc",
                               "--margin",  "--pitch", "--cells",    "--rings",        "--guidance", "--metric",
                               "--planner", "--time",  "--seed",     "--no-smoothing", "--out",      "--blocked-cells",
                               "--picture", "--json",  "--scenario", "Exit codes"})
        EXPECT_NE(result.out.find(option), std::string::npos) << option;
    EXPECT_NE(result.out.find("NOT FOR NAVIGATION"), std::string::npos);
}

TEST(PlanRoute, withoutSmoothingThereIsNone)
{
    const Json report = routeReport(aroundShangchuan() + Arguments{"--no-smoothing"});
    ASSERT_TRUE(report.is_object());
    EXPECT_TRUE(report.at("smoothed").is_null());
    EXPECT_GT(waypoints(report.at("raw")).size(), 2u);
}

TEST(PlanRoute, readsDegreesAndMinutes)
{
    const Json report = routeReport(
        {"--chart", shangchuan(), "--from", "21 38.1N, 112 31.26E", "--to", "N21 40.14 E112 54.06", "--pitch", "100"});
    ASSERT_TRUE(report.is_object());
    const std::vector<LatLon> route = waypoints(report.at("smoothed"));
    EXPECT_NEAR(route.front().first, from.first, 1e-12);
    EXPECT_NEAR(route.front().second, from.second, 1e-12);
    EXPECT_NEAR(route.back().first, to.first, 1e-12);
    EXPECT_NEAR(route.back().second, to.second, 1e-12);
}

TEST(PlanRoute, pitchIsTaken)
{
    const Json report = routeReport(aroundShangchuan() + Arguments{"--pitch", "50"});
    ASSERT_TRUE(report.is_object());
    EXPECT_EQ(report.at("lattice").at("pitch"), 50.0);
    expectSafe(report, ChartOracle(shangchuan(), {1.2, 0.5}));
}

TEST(PlanRoute, marginIsKept)
{
    const Json report = routeReport(aroundShangchuan() + Arguments{"--margin", "75"});
    ASSERT_TRUE(report.is_object());
    const ChartOracle oracle(shangchuan(), {1.2, 0.5});
    expectSafe(report, oracle);
    for (const char *name : {"raw", "smoothed"})
    {
        EXPECT_GE(number(report, name, "min_clearance_m"), 75.0);
        EXPECT_GE(oracle.nearestHazard(waypoints(report.at(name))).distanceM, 75.0 * 0.999);
    }
}

TEST(PlanRoute, deeperVesselKeepsToDeeperWater)
{
    const ChartOracle oracle(shangchuan(), {8.5, 1.0});
    const auto [start, goal] = oracle.randomPairs(7, 1, 10.0, 0.5).front();
    const auto text = [](const LatLon &p)
    {
        return Json(p.first).dump() + "," + Json(p.second).dump();
    };
    const Json report = routeReport(
        {"--chart", shangchuan(), "--from", text(start), "--to", text(goal), "--draught", "8.5", "--ukc", "1"});
    expectSafe(report, oracle);
}

TEST(PlanRoute, everyGuidanceAndMetricGivesASafeRoute)
{
    const ChartOracle oracle(shangchuan(), {1.2, 0.5});
    const struct
    {
        const char *metric;
        const char *length;
    } metrics[] = {{"euclidean", "length_cells"}, {"lattice", "length_lattice"}};
    for (const auto &[metric, length] : metrics)
    {
        double best = 0.0;
        for (const std::string guidance : {"none", "distance", "tie_break", "relaxed", "cheng"})
        {
            SCOPED_TRACE(std::string(metric) + ", " + guidance);
            const Json report = routeReport(aroundShangchuan() +
                                            Arguments{"--pitch", "60", "--metric", metric, "--guidance", guidance});
            ASSERT_TRUE(report.is_object());
            expectSafe(report, oracle);
            // Nothing leads Dijkstra's algorithm astray. The published guidance may overestimate Euclidean costs on 3
            // rings.
            best = guidance == "none" ? number(report, "raw", length) : best;
            const bool isExact = guidance != "cheng" || std::string(metric) == "lattice";
            EXPECT_NEAR(number(report, "raw", length), best, (isExact ? 1e-9 : 0.05) * best);
        }
    }
}

TEST(PlanRoute, chartsAwayFromTheVoyageAreLeftAside)
{
    const Json report =
        routeReport({"--chart", shangchuan(), sanya(), "--from", "18.150,109.420", "--to", "18.250,109.780"});
    ASSERT_TRUE(report.is_object());
    ASSERT_EQ(report.at("chart").at("cells").size(), 1u);
    const Json &cell = report.at("chart").at("cells").at(0);
    EXPECT_EQ(cell.at("name"), "sanya");
    EXPECT_NE(cell.at("warnings").dump().find("shangchuan"), std::string::npos);
    expectSafe(report, ChartOracle(sanya(), {1.2, 0.5}));
}

TEST(PlanRoute, neighbouringChartsAreReadTogether)
{
    const char *data = std::getenv("SEAHEX_TEST_DATA");
    const fs::path noaa = fs::path(data == nullptr ? "" : data) / "charts" / "noaa";
    if (data == nullptr || !fs::exists(noaa / "US5MD1MC"))
        GTEST_SKIP() << "SEAHEX_TEST_DATA names no folder with charts/noaa";
    const fs::path bay = noaa / "US4MD81M" / "US4MD81M.000";
    const Json report = routeReport(
        {"--chart", bay.string(), (noaa / "US5MD1MC").string(), "--from", "38.95,-76.44", "--to", "38.85,-76.40"});
    ASSERT_TRUE(report.is_object());
    EXPECT_EQ(report.at("chart").at("cells").size(), 2u);
    expectSafe(report, ChartOracle(bay.string(), {1.2, 0.5}));
}

TEST(PlanRoute, overwritesNeitherChartNorItsOwnOutput)
{
    const TemporaryFolder folder;
    const fs::path chart = folder / "sanya.000";
    fs::copy_file(sanya(), chart);
    const std::string before = readBytes(chart);
    const std::vector<std::string> job = {"--chart",        chart.string(), "--from",
                                          "18.150,109.420", "--to",         "18.250,109.780"};
    const auto exitOf = [&job](std::vector<std::string> more)
    {
        std::vector<std::string> all = {SEAHEX_PLAN_ROUTE};
        all.insert(all.end(), job.begin(), job.end());
        all.insert(all.end(), more.begin(), more.end());
        return runProgram(all).exitCode;
    };
    EXPECT_EQ(exitOf({"--out", chart.string()}), 2);
    EXPECT_EQ(readBytes(chart), before);
    EXPECT_EQ(exitOf({"--out", "/dev/null"}), 2);
    const std::string both = (folder / "both.png").string();
    EXPECT_EQ(exitOf({"--out", both, "--picture", both}), 2);
    EXPECT_FALSE(fs::exists(both));
    fs::create_symlink(folder / "route.geojson", folder / "link");
    EXPECT_EQ(exitOf({"--out", (folder / "link").string()}), 0);
    EXPECT_EQ(exitOf({"--out", (folder / "link").string()}), 0) << "now that the target is there";
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
}

TEST(PlanRoute, folderOfCellsIsAChart)
{
    const TemporaryFolder folder;
    fs::create_directories(folder / "ENC_ROOT" / "shangchuan");
    fs::copy_file(shangchuan(), folder / "ENC_ROOT" / "shangchuan" / "shangchuan.000");
    const Json report = routeReport({"--chart", (folder / "ENC_ROOT").string(), "--from", "21.635,112.521", "--to",
                                     "21.669,112.901", "--pitch", "100"});
    ASSERT_TRUE(report.is_object());
    EXPECT_EQ(report.at("chart").at("cells").at(0).at("name"), "shangchuan");
}

TEST(PlanRoute, southernAndWesternPositionsAreNoOptions)
{
    const TemporaryFolder folder;
    const fs::path chart = folder / "south.gpkg";
    writeChart(chart, {{"M_COVR", {{boxWkt(-60.1, -40.1, -60.0, -40.0), {{"CATCOV", 1}}}}},
                       {"DEPARE", {{boxWkt(-60.1, -40.1, -60.0, -40.0), {{"DRVAL1", 10.0}}}}}});
    const Json report = routeReport({"--chart", chart.string(), "--from", "-40.09,-60.09", "--to", "-40.01,-60.01"});
    ASSERT_TRUE(report.is_object());
    EXPECT_EQ(waypoints(report.at("smoothed")).front(), LatLon(-40.09, -60.09));
    EXPECT_EQ(waypoints(report.at("smoothed")).back(), LatLon(-40.01, -60.01));
    EXPECT_TRUE(report.at("smoothed").at("min_clearance_m").is_null()) << "no hazard on this chart";
}

/// A chart 256 km from west to east: water from 39.9 to 40.1 N, and land where the box is.
void writeLongChart(const fs::path &path, const std::string &landWkt, const std::string &waterWkt)
{
    writeChart(path, {{"M_COVR", {{boxWkt(30.0, 39.9, 33.0, 40.1), {{"CATCOV", 1}}}}},
                      {"DEPARE", {{waterWkt, {{"DRVAL1", 10.0}}}}},
                      {"LNDARE", {{landWkt, {}}}}});
}

// In the plane the middle of a parallel lies a kilometre south of the straight line between its ends. A shore taken for
// that straight line would give away a strip of land to a route that hugs it.
TEST(PlanRoute, longShoresAreThoseOfTheChart)
{
    const TemporaryFolder folder;
    const fs::path chart = folder / "long.gpkg";
    writeLongChart(chart, boxWkt(30.0, 40.0, 33.0, 40.1), boxWkt(30.0, 39.9, 33.0, 40.0));
    const Json report = routeReport({"--chart", chart.string(), "--from", "39.999,30.01", "--to", "39.999,32.99"});
    const ChartOracle oracle(chart.string(), {1.2, 0.5});
    expectSafe(report, oracle);
    EXPECT_LT(oracle.nearestHazard(waypoints(report.at("smoothed"))).distanceM, 60.0) << "it does not hug the shore";
}

// The same for the route: its straight line in the plane passes an islet that lies on the straight line of the chart.
TEST(PlanRoute, longLegsAreWrittenAsTheyWereChecked)
{
    const TemporaryFolder folder;
    const fs::path chart = folder / "long.gpkg";
    const std::string islet = "31.49 39.999,31.51 39.999,31.51 40.001,31.49 40.001,31.49 39.999";
    writeLongChart(chart, "POLYGON ((" + islet + "))",
                   "POLYGON ((30 39.9,33 39.9,33 40.1,30 40.1,30 39.9),(" + islet + "))");
    const Json report = routeReport({"--chart", chart.string(), "--from", "40,30.05", "--to", "40,32.95"});
    const ChartOracle oracle(chart.string(), {1.2, 0.5});
    expectSafe(report, oracle);
    EXPECT_EQ(number(report, "smoothed", "turns"), 0) << "a straight line of the plane, not the path it falls back to";
    EXPECT_GT(oracle.nearestHazard(waypoints(report.at("smoothed"))).distanceM, 500.0) << "it turns about the islet";
    EXPECT_FALSE(oracle.violations({{40.0, 30.05}, {40.0, 32.95}}).empty()) << "the straight line misses the islet";
}

TEST(PlanRoute, startMayBeTheGoal)
{
    const Json report = routeReport({"--chart", shangchuan(), "--from", "21.635,112.521", "--to", "21.635,112.521"});
    ASSERT_TRUE(report.is_object());
    EXPECT_NEAR(number(report, "smoothed", "length_m"), 0.0, 1e-9);
}

TEST(PlanRoute, writesGeoJson)
{
    const TemporaryFolder folder;
    const fs::path file = folder / "route.geojson";
    const Json report = routeReport(aroundShangchuan() + Arguments{"--out", file.string()});
    ASSERT_TRUE(report.is_object());
    const Json written = Json::parse(readBytes(file));
    EXPECT_EQ(written.at("type"), "FeatureCollection");
    const std::vector<LatLon> route = waypoints(report.at("smoothed"));
    std::vector<LatLon> line;
    std::size_t points = 0;
    std::size_t rawPaths = 0;
    for (const Json &feature : written.at("features"))
    {
        const std::string kind = feature.at("properties").at("kind");
        if (kind == "route")
        {
            for (const Json &position : feature.at("geometry").at("coordinates"))
                line.emplace_back(position.at(1), position.at(0));
            EXPECT_EQ(feature.at("properties").at("length_m"), report.at("smoothed").at("length_m"));
        }
        points += kind == "waypoint";
        rawPaths += kind == "raw_path";
        EXPECT_NE(kind, "blocked_cell");
    }
    EXPECT_EQ(line, route);
    EXPECT_EQ(points, route.size());
    EXPECT_EQ(rawPaths, 1u);
}

TEST(PlanRoute, writesBlockedCellsOnRequest)
{
    const TemporaryFolder folder;
    const fs::path file = folder / "route.geojson";
    const Json report =
        routeReport(aroundShangchuan() + Arguments{"--pitch", "600", "--out", file.string(), "--blocked-cells"});
    ASSERT_TRUE(report.is_object());
    std::size_t blocked = 0;
    const Json written = Json::parse(readBytes(file));
    for (const Json &feature : written.at("features"))
        blocked += feature.at("properties").at("kind") == "blocked_cell";
    EXPECT_EQ(blocked, report.at("lattice").at("blocked").get<std::size_t>());
}

TEST(PlanRoute, drawsPictures)
{
    const TemporaryFolder folder;
    for (const char *name : {"route.svg", "route.png"})
        routeReport(aroundShangchuan() + Arguments{"--picture", (folder / name).string()});

    const std::string svg = readBytes(folder / "route.svg");
    const std::unique_ptr<CPLXMLNode, void (*)(CPLXMLNode *)> tree(CPLParseXMLString(svg.c_str()), CPLDestroyXMLNode);
    ASSERT_TRUE(tree) << "no XML";
    EXPECT_NE(CPLGetXMLNode(tree.get(), "=svg"), nullptr);
    EXPECT_NE(CPLGetXMLNode(tree.get(), "=svg.g"), nullptr);

    const std::string png = readBytes(folder / "route.png");
    EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(png.substr(png.size() - 8, 4), "IEND");
    EXPECT_GT(png.size(), 20000u);
}

TEST(PlanRoute, chartsMayHaveAnyName)
{
    const TemporaryFolder folder;
    const fs::path chart = folder / "sea \xc3\xa4 'of' \"$HOME\" %s;.000";
    fs::copy_file(shangchuan(), chart);
    const Json report = routeReport({"--chart", chart.string(), "--from", "21.635,112.521", "--to", "21.669,112.901"});
    ASSERT_TRUE(report.is_object());
    EXPECT_EQ(report.at("chart").at("cells").at(0).at("source"), chart.string());
}

TEST(PlanRoute, muchTimeIsNoTimeOut)
{
    EXPECT_TRUE(routeReport(aroundShangchuan() + Arguments{"--time", "1e12"}).is_object());
}

/// OMPL's planners, on the same arena: one second each. Some of OMPL 1.5.2's never free their last states (BFMT,
/// LazyPRM), which is not for the leak sanitizer to blame on plan_route.
class OmplPlanner : public testing::TestWithParam<const char *>
{
protected:
    static void SetUpTestSuite() { setenv("ASAN_OPTIONS", "detect_leaks=0", 1); }
    static void TearDownTestSuite() { unsetenv("ASAN_OPTIONS"); }
};

TEST_P(OmplPlanner, givesASafeRoute)
{
    const Json report =
        routeReport(aroundShangchuan() + Arguments{"--planner", GetParam(), "--time", "1", "--seed", "3"});
    ASSERT_TRUE(report.is_object());
    EXPECT_EQ(report.at("planner"), GetParam());
    EXPECT_EQ(waypoints(report.at("raw")).front(), from);
    EXPECT_EQ(waypoints(report.at("raw")).back(), to);
    EXPECT_LE(number(report, "smoothed", "length_m"), number(report, "raw", "length_m"));
    expectSafe(report, ChartOracle(shangchuan(), {1.2, 0.5}));
}

TEST_P(OmplPlanner, givesUpWhereThereIsNoRoute)
{
    const TemporaryFolder folder;
    writeTinyChart(folder / "wall.gpkg", true);
    const ProgramResult result = planRoute({"--chart", (folder / "wall.gpkg").string(), "--from", "40.05,30.02", "--to",
                                            "40.05,30.08", "--planner", GetParam(), "--time", "0.3"});
    EXPECT_EQ(result.exitCode, 6) << result.summary();
    EXPECT_EQ(result.out, "");
    EXPECT_NE(result.err.find(std::string(GetParam()) + " found no route within 0.3 s"), std::string::npos)
        << result.err;
}

INSTANTIATE_TEST_SUITE_P(Names, OmplPlanner,
                         testing::Values("ABITstar", "AITstar", "BFMT", "BITstar", "FMT", "InformedRRTstar", "LazyPRM",
                                         "LazyPRMstar", "PRM", "PRMstar", "RRT", "RRTConnect", "RRTsharp", "RRTstar"),
                         [](const auto &planner) { return std::string(planner.param); });

}  // namespace
