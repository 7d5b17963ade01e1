// plan_dive as people run it: what it writes is judged against the raster's own numbers; what it refuses ends with its
// exit code, one sentence, and no file.

#include "demos/PlanRoute.h"
#include "support/TestData.h"
#include "support/TestRasters.h"

#include <cmath>
#include <limits>

using namespace seahex::test;

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

enum Code
{
    Usage = 2,
    BadSeabed = 3,
    NotNavigable = 4,
    NoDive = 5,
    OutOfTime = 6
};

/// 41 x 31 nodes 0.001 degrees apart from 10 E 45 N: 100 m of water, a ridge across from north to south that rises to
/// 20 m below the surface, with a gap of 60 m in its south.
TestRaster ridge()
{
    TestRaster raster;
    raster.columns = 41;
    raster.rows = 31;
    raster.epsg = 4326;
    raster.transform = {10.0 - 0.0005, 0.001, 0.0, 45.03 + 0.0005, 0.0, -0.001};
    for (int row = 0; row < raster.rows; ++row)
        for (int column = 0; column < raster.columns; ++column)
        {
            const double top = row >= 22 && row <= 26 ? 60.0 : 20.0;
            const double ridgeDepth = top + 20.0 * std::abs(column - 20);
            raster.values.push_back(-std::min(100.0, ridgeDepth) - 0.01 * ((7 * row + 3 * column) % 10));
        }
    return raster;
}

/// Judges the line of a file by a raster in degrees: bilinear heights at a tenth of a cell.
void expectSafe(const Json &file, const fs::path &path, double clearanceM, double ceilingM)
{
    const PlainRaster raster(path);
    const Json &line = file.at("features").at(0).at("geometry");
    ASSERT_EQ(line.at("type"), "LineString");
    const Json &positions = line.at("coordinates");
    ASSERT_GE(positions.size(), 2u);
    for (std::size_t leg = 1; leg < positions.size(); ++leg)
    {
        const auto at = [&](std::size_t i, std::size_t k)
        {
            return positions[i][k].get<double>();
        };
        const double cells = std::abs(at(leg, 0) - at(leg - 1, 0)) / std::abs(raster.transform[1]) +
                             std::abs(at(leg, 1) - at(leg - 1, 1)) / std::abs(raster.transform[5]);
        const int steps = 1 + static_cast<int>(10.0 * cells);
        for (int i = 0; i <= steps; ++i)
        {
            const double t = static_cast<double>(i) / steps;
            const auto between = [&](std::size_t k)
            {
                return at(leg - 1, k) + t * (at(leg, k) - at(leg - 1, k));
            };
            const double water = between(2) - raster.bilinear(between(0), between(1));
            ASSERT_GE(water, clearanceM) << "leg " << leg << " at " << between(0) << ", " << between(1);
            ASSERT_LE(between(2), -ceilingM + 1e-9) << "leg " << leg;
        }
    }
}

class PlanDive : public testing::Test
{
protected:
    ProgramResult run(const Arguments &arguments) const
    {
        return runProgram(Arguments{SEAHEX_PLAN_DIVE} + arguments, folder_.path());
    }

    std::string write(const TestRaster &raster, const std::string &name = "seabed.tif") const
    {
        writeRaster(folder_ / name, raster);
        return (folder_ / name).string();
    }

    /// Across the ridge of `ridge()`, too deep to pass above but through the gap.
    Arguments acrossTheRidge() const
    {
        return {"--bathymetry",    write(ridge()), "--from", "45.02,10.003@50", "--to",
                "45.02,10.037@60", "--clearance",  "10",     "--ceiling",       "30"};
    }

    /// Fine enough slices for it.
    static Arguments slices() { return {"--slices", "35", "--across", "31", "--levels", "15"}; }

    Json dive(const Arguments &arguments) const
    {
        const ProgramResult result = run(arguments + Arguments{"--json"});
        EXPECT_EQ(result.exitCode, 0) << result.summary();
        EXPECT_EQ(result.err, "");
        return result.exitCode == 0 ? Json::parse(result.out) : Json();
    }

    void expectRefusal(const Arguments &arguments, Code code, const std::vector<std::string> &words) const
    {
        SCOPED_TRACE(testing::PrintToString(arguments));
        const Arguments all = arguments + Arguments{"--out",       (folder_ / "refused.geojson").string(),
                                                    "--profile",   (folder_ / "refused.svg").string(),
                                                    "--picture3d", (folder_ / "refused.png").string()};
        const ProgramResult result = run(all);
        EXPECT_EQ(result.exitCode, code) << result.summary();
        EXPECT_EQ(result.out, "");
        const std::string intro = "plan_dive: error: ";
        ASSERT_EQ(result.err.rfind(intro, 0), 0u) << result.summary();
        EXPECT_EQ(result.err.find('\n'), result.err.size() - 1) << "more than one line: " << result.err;
        for (const std::string &word : words)
            EXPECT_NE(result.err.find(word), std::string::npos) << "'" << word << "' is not in " << result.err;
        for (const char *file : {"refused.geojson", "refused.svg", "refused.png"})
            EXPECT_FALSE(fs::exists(folder_ / file)) << file;
        const Json json = Json::parse(run(all + Arguments{"--json"}).out);
        EXPECT_EQ(json.at("exit"), static_cast<int>(code));
        EXPECT_EQ(json.at("message").get<std::string>(),
                  result.err.substr(intro.size(), result.err.size() - intro.size() - 1));
    }

    TemporaryFolder folder_;
};

TEST_F(PlanDive, findsTheGapInTheRidgeAndWritesItDown)
{
    const Arguments base = acrossTheRidge();
    for (const char *planner : {"LayeredPlanner", "AntColony", "PrismAStar", "RRTstar", "BITstar", "PRMstar"})
    {
        SCOPED_TRACE(planner);
        const bool isOnSlices = planner == std::string("LayeredPlanner") || planner == std::string("AntColony");
        const bool ends = isOnSlices || planner == std::string("PrismAStar");  // the others use all of their time
        const std::string out = (folder_ / "dive.geojson").string();
        const Json report = dive(base + (isOnSlices ? slices() : Arguments{}) +
                                 Arguments{"--planner", planner, "--time", ends ? "60" : "0.6", "--out", out});
        ASSERT_TRUE(report.is_object());
        EXPECT_EQ(report.at("status"), "dive");
        const Json file = Json::parse(readBytes(out));
        expectSafe(file, folder_ / "seabed.tif", 10.0, 30.0);
        const Json &positions = file.at("features").at(0).at("geometry").at("coordinates");
        EXPECT_EQ(positions.front(), Json({10.003, 45.02, -50.0}));
        EXPECT_EQ(positions.back(), Json({10.037, 45.02, -60.0}));
        double southernmost = 90.0;
        for (const Json &p : positions)
            southernmost = std::min(southernmost, p.at(1).get<double>());
        EXPECT_LT(southernmost, 45.009) << "through the gap";
        const Json &waypoints = report.at("dive").at("waypoints");
        ASSERT_EQ(waypoints.size(), positions.size());
        for (std::size_t i = 0; i < waypoints.size(); ++i)
        {
            EXPECT_NEAR(waypoints[i][0].get<double>(), positions[i][1].get<double>(), 1e-7);
            EXPECT_EQ(waypoints[i][2].get<double>(), -positions[i][2].get<double>());
            EXPECT_EQ(file.at("features").at(i + 1).at("properties").at("depth_m"), waypoints[i][2]);
        }
        EXPECT_GE(report.at("dive").at("least_water_m").get<double>(), 10.0);
        EXPECT_GE(report.at("dive").at("length_m").get<double>(), 2679.0) << "the straight line";
        EXPECT_EQ(report.at("slices").is_object(), isOnSlices);
    }
}

/// The steepest leg of a written line, in metres up or down for a metre on a sphere of the earth's least radius of
/// curvature, that of a meridian at the equator.
double steepestOnSphere(const Json &positions)
{
    constexpr double metresPerDegree = 6335439.0 * 3.14159265358979323846 / 180.0;
    double steepest = 0.0;
    for (std::size_t i = 1; i < positions.size(); ++i)
    {
        const auto by = [&](std::size_t k)
        {
            return positions[i][k].get<double>() - positions[i - 1][k].get<double>();
        };
        const double northM = by(1) * metresPerDegree;
        const double eastM = by(0) * metresPerDegree * std::cos(45.03 * 3.14159265358979323846 / 180.0);
        steepest = std::max(steepest, std::abs(by(2)) / std::hypot(northM, eastM));
    }
    return steepest;
}

TEST_F(PlanDive, aVehicleThatClimbsLittleGoesRoundTheRidge)
{
    const std::string out = (folder_ / "dive.geojson").string();
    const Arguments base{"--bathymetry",     write(ridge()), "--from", "45.011,10.003@50", "--to",
                         "45.011,10.037@60", "--clearance",  "10",     "--planner",        "PrismAStar"};
    const auto southernmost = [&](const Json &positions)
    {
        double least = 90.0;
        for (const Json &p : positions)
            least = std::min(least, p.at(1).get<double>());
        return least;
    };
    const auto written = [&]
    {
        return Json::parse(readBytes(out)).at("features").at(0).at("geometry").at("coordinates");
    };
    const Json free = dive(base + Arguments{"--out", out});
    ASSERT_TRUE(free.is_object());
    EXPECT_GT(southernmost(written()), 45.0105) << "straight over it, climbing 40 m";
    EXPECT_GT(free.at("dive").at("steepest").get<double>(), 0.025);
    EXPECT_TRUE(free.at("limits").at("climb").is_null());

    const Json limited = dive(base + Arguments{"--climb", "0.02", "--out", out});
    ASSERT_TRUE(limited.is_object());
    EXPECT_LT(southernmost(written()), 45.009) << "through the gap";
    EXPECT_LE(steepestOnSphere(written()), 0.02 * 1.01);
    EXPECT_LE(limited.at("dive").at("steepest").get<double>(), 0.02 * 1.001);
    EXPECT_EQ(limited.at("limits").at("climb"), 0.02);

    expectRefusal(base + Arguments{"--climb", "0.0001"}, NoDive, {"PrismAStar", "climb of 0.0001"});
}

TEST_F(PlanDive, prismsAreAsFineAsAskedFor)
{
    TestRaster wall = ridge();
    for (std::size_t i = 20; i < wall.values.size(); i += static_cast<std::size_t>(wall.columns))
        wall.values[i] = 1.0;
    const Arguments base{"--bathymetry", write(wall),       "--from",    "45.02,10.003@50",
                         "--to",         "45.02,10.037@60", "--planner", "PrismAStar"};
    expectRefusal(base + Arguments{"--cell-size", "100", "--layer", "5"}, NoDive, {"cells of 100 m", " 13 layers"});
    expectRefusal(base + Arguments{"--layer", "20"}, NoDive, {" 4 layers"});
    // other rings and cells, another dive
    const auto length = [&](const Arguments &more)
    {
        const Json report = dive(acrossTheRidge() + Arguments{"--planner", "PrismAStar"} + more);
        return report.is_object() ? report.at("dive").at("length_m").get<double>() : 0.0;
    };
    const double usual = length({});
    for (const Arguments &more : std::vector<Arguments>{{"--rings", "1"}, {"--cell-size", "150"}})
    {
        const double other = length(more);
        EXPECT_NE(other, usual) << testing::PrintToString(more);
        EXPECT_NEAR(other, usual, 0.05 * usual) << testing::PrintToString(more);
    }
}

TEST_F(PlanDive, exactIsNoWorseThanGreedyAndMoreDangerIsShorter)
{
    TestRaster low = ridge();
    for (double &height : low.values)
        height -= 30.0;
    const Arguments base{"--bathymetry",    write(low),    "--from", "45.02,10.003@50", "--to",
                         "45.02,10.037@60", "--clearance", "10",     "--ceiling",       "30"};
    const Json exact = dive(base);
    const Json greedy = dive(base + Arguments{"--planner", "LayeredPlanner-greedy"});
    ASSERT_TRUE(exact.is_object() && greedy.is_object());
    EXPECT_LE(exact.at("dive").at("length_m").get<double>(), 1.2 * greedy.at("dive").at("length_m").get<double>());
    const Json bold = dive(base + Arguments{"--K", "1"});
    const Json timid = dive(base + Arguments{"--K", "0.01"});
    EXPECT_LE(bold.at("slices").at("length"), timid.at("slices").at("length"));
    EXPECT_GE(bold.at("slices").at("danger"), timid.at("slices").at("danger"));
}

TEST_F(PlanDive, theSameSeedGivesTheSameDive)
{
    const Arguments base = acrossTheRidge() + slices() + Arguments{"--planner", "AntColony", "--seed", "5"};
    EXPECT_EQ(dive(base).at("dive"), dive(base).at("dive"));
}

TEST_F(PlanDive, drawsBothPictures)
{
    for (const char *extension : {".svg", ".png"})
    {
        const std::string profile = (folder_ / (std::string("profile") + extension)).string();
        const std::string picture = (folder_ / (std::string("seabed") + extension)).string();
        const ProgramResult result =
            run(acrossTheRidge() + slices() + Arguments{"--profile", profile, "--picture3d", picture});
        ASSERT_EQ(result.exitCode, 0) << result.summary();
        for (const std::string &file : {profile, picture})
        {
            EXPECT_GT(fs::file_size(file), 4000u) << file;
            EXPECT_NE(result.out.find(file), std::string::npos);
        }
    }
}

TEST_F(PlanDive, refusesWhatIsNoSeabed)
{
    const Arguments ends{"--from", "45.02,10.003@5", "--to", "45.02,10.037@5"};
    const auto on = [&](const std::string &file)
    {
        return Arguments{"--bathymetry", file} + ends;
    };
    expectRefusal(on("nowhere.nc"), BadSeabed, {"nowhere.nc"});
    writeBytes(folder_ / "empty.tif", "");
    expectRefusal(on((folder_ / "empty.tif").string()), BadSeabed, {"empty.tif"});
    TestRaster land = ridge();
    for (double &height : land.values)
        height = 5.0;
    expectRefusal(on(write(land, "land.tif")), BadSeabed, {"land.tif"});
    TestRaster nothing = ridge();
    for (double &height : nothing.values)
        height = std::numeric_limits<double>::quiet_NaN();
    expectRefusal(on(write(nothing, "nan.tif")), BadSeabed, {"nan.tif"});
    TestRaster metres = ridge();
    metres.epsg = 32632;
    metres.transform = {0.0, 100.0, 0.0, 5000000.0, 0.0, -100.0};
    expectRefusal(Arguments{"--bathymetry", write(metres, "metres.tif")} + ends, BadSeabed, {"metres.tif", " metres"});
    expectRefusal(on(write(ridge())) + Arguments{"--clearance", "500"}, BadSeabed, {"seabed.tif", "500", "m"});
}

TEST_F(PlanDive, refusesEndsThatAreNotInTheWater)
{
    TestRaster raster = ridge();
    for (const std::size_t node : {42, 43, 83, 84})  // around 45.0285 N 10.0015 E
        raster.values[node] = 30.5;
    raster.values[raster.values.size() - 1] = std::numeric_limits<double>::quiet_NaN();  // south-east corner
    const std::string file = write(raster);
    const auto from = [&](const std::string &start)
    {
        return Arguments{"--bathymetry", file, "--from",    start, "--to",      "45.02,10.037@60",
                         "--clearance",  "10", "--ceiling", "30",  "--deepest", "95"};
    };
    expectRefusal(from("45.0285,10.0015@40"), NotNavigable, {"start", "on land", "30.5 m above"});
    expectRefusal(from("45.02,10.003@92"), NotNavigable, {"start", "too deep", "10.05 m of clearance", "would do"});
    expectRefusal(from("45.02,10.003@97"), NotNavigable, {"start", "greatest depth of 95 m"});
    expectRefusal(from("45.02,10.003@20"), NotNavigable, {"start", "above the ceiling of 30 m"});
    expectRefusal(from("45.02,10.02@35"), NotNavigable, {"start", "too deep", "no depth would do"});
    expectRefusal(from("45.02,11@35"), NotNavigable, {"start", "outside"});
    expectRefusal(from("45.0001,10.0399@35"), NotNavigable, {"start", "unknown"});
}

TEST_F(PlanDive, refusesWhereNoWayIs)
{
    TestRaster wall = ridge();
    for (std::size_t i = 20; i < wall.values.size(); i += static_cast<std::size_t>(wall.columns))
        wall.values[i] = 1.0;
    const Arguments base{"--bathymetry", write(wall), "--from", "45.02,10.003@50", "--to", "45.02,10.037@60"};
    expectRefusal(base, NoDive, {"LayeredPlanner", "slice"});
    expectRefusal(base + Arguments{"--planner", "LayeredPlanner-greedy"}, NoDive, {"LayeredPlanner-greedy", "slice"});
    expectRefusal(base + Arguments{"--planner", "RRTstar", "--time", "0.1"}, OutOfTime, {"RRTstar", "0.1 s"});
}

TEST_F(PlanDive, refusesWrongUsage)
{
    const Arguments base = acrossTheRidge() + slices();
    for (const auto &[more, word] :
         std::vector<std::pair<Arguments, std::string>>{{{"--planner", "HexAStar"}, "HexAStar"},
                                                        {{"--K", "2"}, "--K"},
                                                        {{"--clearance", "-1"}, "--clearance"},
                                                        {{"--deepest", "10"}, "--deepest"},
                                                        {{"--slices", "1"}, "--slices"},
                                                        {{"--levels", "1000", "--across", "1000"}, "points"},
                                                        {{"--values", "colours"}, "--values"},
                                                        {{"--vehicle-length", "0"}, "--vehicle-length"},
                                                        {{"--climb", "0.1"}, "PrismAStar"},
                                                        {{"--planner", "RRTstar"}, "--slices"},
                                                        {{"--cross-cables", "5"}, "--chart"},
                                                        {{"--cross-cables", "-5"}, "--cross-cables"},
                                                        {{"--nonsense"}, "--nonsense"}})
    {
        Arguments replaced = base;
        for (auto it = replaced.begin(); it != replaced.end();)
            it = std::find(more.begin(), more.end(), *it) != more.end() && it->rfind("--", 0) == 0
                     ? replaced.erase(it, it + 2)
                     : it + 1;
        expectRefusal(replaced + more, Usage, {word});
    }
    const Arguments prisms = acrossTheRidge() + Arguments{"--planner", "PrismAStar"};
    for (const auto &[option, value] : std::vector<std::pair<std::string, std::string>>{
             {"--climb", "-0.1"}, {"--climb", "nan"}, {"--rings", "4"}, {"--cell-size", "0"}, {"--layer", "thin"}})
        expectRefusal(prisms + Arguments{option, value}, Usage, {option});
    expectRefusal(prisms + Arguments{"--K", "0.5"}, Usage, {"--K", "PrismAStar", "LayeredPlanner"});
    const std::string file = write(ridge());
    expectRefusal({"--from", "45.02,10.003@50", "--to", "45.02,10.037@60"}, Usage, {"--bathymetry"});
    expectRefusal({"--bathymetry", file, "--from", "45.02,10.003", "--to", "45.02,10.037@60"}, Usage,
                  {"--from", "depth"});
    expectRefusal({"--bathymetry", file, "--from", "45.02,10.003@5", "--to", "95.02,10.037@6"}, Usage, {"--to"});
    const ProgramResult own = run(base + Arguments{"--out", file});
    EXPECT_EQ(own.exitCode, Usage) << own.summary();
    EXPECT_NE(own.err.find("overwrite"), std::string::npos);
}

TEST_F(PlanDive, helpNamesEveryOption)
{
    const ProgramResult result = run({"--help"});
    EXPECT_EQ(result.exitCode, 0);
    for (const char *option :
         {"--bathymetry", "--chart",   "--from",    "--to",        "--clearance", "--ceiling",  "--deepest",
          "--K",          "--planner", "--climb",   "--rings",     "--cell-size", "--layer",    "--time",
          "--seed",       "--out",     "--profile", "--picture3d", "--json",      "Exit codes", "NOT FOR NAVIGATION"})
        EXPECT_NE(result.out.find(option), std::string::npos) << option;
}

TEST_F(PlanDive, onAChartKeepsOutOfWhatStandsInTheWater)
{
    const Arguments voyage{"--chart",        sanya(),       "--from", "18.15,109.38@4", "--to",
                           "18.13,109.75@6", "--clearance", "2",      "--planner"};
    const Json report = dive(voyage + Arguments{"LayeredPlanner"});
    ASSERT_TRUE(report.is_object());
    EXPECT_EQ(report.at("seabed").at("source"), "chart sanya");
    EXPECT_GE(report.at("dive").at("least_water_m").get<double>(), 2.0);
    expectRefusal({"--chart", sanya(), "--from", "18.25,109.5@4", "--to", "18.13,109.75@6"}, NotNavigable, {"start"});
}

TEST_F(PlanDive, crossesCablesOnlyAboveThem)
{
    const fs::path chart = folder_ / "cable.gpkg";
    writeChart(chart, {{"M_COVR", {{boxWkt(10.0, 45.0, 10.04, 45.03), {{"CATCOV", 1}}}}},
                       {"DEPARE", {{boxWkt(10.0, 45.0, 10.04, 45.03), {{"DRVAL1", 50.0}, {"DRVAL2", 60.0}}}}},
                       {"CBLSUB", {{"LINESTRING (10.02 45.0,10.02 45.03)", {}}}}});
    TestRaster flat = ridge();
    for (double &height : flat.values)
        height = -50.0;
    for (const Arguments &seabed : {Arguments{}, Arguments{"--bathymetry", write(flat)}})
    {
        const Arguments base =
            seabed +
            Arguments{
                "--chart", chart.string(), "--from",     "45.015,10.003@40", "--to", "45.015,10.037@40", "--clearance",
                "5",       "--planner",    "PrismAStar", "--cell-size",      "100",  "--spacing",        "60"};
        expectRefusal(base, NoDive, {"PrismAStar"});
        const Json report = dive(base + Arguments{"--cross-cables", "20"});
        ASSERT_TRUE(report.is_object());
        EXPECT_EQ(report.at("limits").at("cross_cables_m"), 20.0);
        const Json &waypoints = report.at("dive").at("waypoints");
        int crossings = 0;
        for (std::size_t i = 1; i < waypoints.size(); ++i)
        {
            const auto at = [&](std::size_t k, std::size_t of)
            {
                return waypoints[k][of].get<double>();
            };
            if ((at(i - 1, 1) <= 10.02) == (at(i, 1) <= 10.02))
                continue;
            ++crossings;
            const double t = (10.02 - at(i - 1, 1)) / (at(i, 1) - at(i - 1, 1));
            const double depth = at(i - 1, 2) + t * (at(i, 2) - at(i - 1, 2));
            EXPECT_LE(depth, 25.0) << "5 m of clearance and 20 m more";
            EXPECT_GT(depth, 20.0);
        }
        EXPECT_EQ(crossings, 1);
        expectRefusal(base + Arguments{"--cross-cables", "47"}, NoDive, {"PrismAStar"});
    }
    Arguments atCable{"--chart",          chart.string(), "--from", "45.015,10.02@40", "--to",
                      "45.015,10.037@40", "--clearance",  "5",      "--cross-cables",  "20"};
    expectRefusal(atCable, NotNavigable, {"start", "too deep", "where cables lie it counts as 20 m higher"});
    atCable.back() = "60";
    expectRefusal(atCable, NotNavigable, {"start", "too deep", "no depth would do there"});
}

TEST_F(PlanDive, realSeabeds)
{
    SEAHEX_TEST_DATA_OR_SKIP(data, "bathymetry");
    struct Voyage
    {
        const char *file;
        Arguments more;
        double clearanceM;
        double ceilingM;
    };
    const std::string out = (folder_ / "dive.geojson").string();
    for (const Voyage &voyage :
         {Voyage{"52north_tests_depth_data.nc", {"--from", "38.5,3.5@300", "--to", "39.5,12.5@1500"}, 50.0, 10.0},
          Voyage{"gmt_Iceland.nc", {"--from", "64.5,-25.5@100", "--to", "64.5,-12.5@60"}, 20.0, 5.0},
          Voyage{"geoclaw_kahului_1s.asc",
                 {"--degrees", "--from", "20.9027,-156.4674@5", "--to", "20.8970,-156.4668@4"},
                 1.5,
                 1.0}})
        for (const char *planner : {"LayeredPlanner", "AntColony", "RRTstar"})
        {
            SCOPED_TRACE(std::string(voyage.file) + ", " + planner);
            const fs::path raster = data / voyage.file;
            const Json report = dive(Arguments{"--bathymetry", raster.string(), "--planner", planner, "--time", "1",
                                               "--clearance", std::to_string(voyage.clearanceM), "--ceiling",
                                               std::to_string(voyage.ceilingM), "--out", out} +
                                     voyage.more);
            if (report.is_object())
                expectSafe(Json::parse(readBytes(out)), raster, voyage.clearanceM, voyage.ceilingM);
        }
}

}  // namespace
