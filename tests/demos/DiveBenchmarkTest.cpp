// benchmark_planners over a seabed as people run it, on a small raster of our own.

#include "demos/PlanRoute.h"
#include "support/RunProgram.h"
#include "support/TestRasters.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

using namespace seahex::test;

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

/// 61 x 41 nodes 0.001 degrees apart from 10 E 45 N: hills up to 10 m below the surface and hollows of 90 m.
TestRaster hills()
{
    TestRaster raster;
    raster.columns = 61;
    raster.rows = 41;
    raster.epsg = 4326;
    raster.transform = {10.0 - 0.0005, 0.001, 0.0, 45.04 + 0.0005, 0.0, -0.001};
    for (int row = 0; row < raster.rows; ++row)
        for (int column = 0; column < raster.columns; ++column)
            raster.values.push_back(-50.0 - 40.0 * std::sin(0.4 * column) * std::cos(0.3 * row));
    return raster;
}

class DiveBenchmark : public testing::Test
{
protected:
    ProgramResult benchmark(const Arguments &arguments) const
    {
        return runProgram(Arguments{SEAHEX_BENCHMARK_PLANNERS} + arguments);
    }

    std::string seabed() const
    {
        writeRaster(folder_ / "hills.tif", hills());
        return (folder_ / "hills.tif").string();
    }

    fs::path out() const { return folder_ / "out"; }

    TemporaryFolder folder_;
};

TEST_F(DiveBenchmark, comparesPlannersAndFindsEveryDiveSafe)
{
    const Arguments dives = {
        "--bathymetry", seabed(),
        "--clearance",  "12",
        "--ceiling",    "3",
        "--pairs",      "3",
        "--time",       "1",
        "--planners",   "PrismAStar,LayeredPlanner-greedy,LayeredPlanner-exact,RRTConnect+simplify",
        "--out",        out().string()};
    const ProgramResult text = benchmark(dives);
    ASSERT_EQ(text.exitCode, 0) << text.summary();
    for (const char *words :
         {"in the way of the straight line of 3 pairs", "unsafe", "LayeredPlanner-exact", "index.html"})
        EXPECT_NE(text.out.find(words), std::string::npos) << words << " is not in\n" << text.out;
    EXPECT_EQ(text.out.find("UNSAFE"), std::string::npos) << text.out;
    const std::string page = readBytes(out() / "index.html");
    EXPECT_NE(page.find("Planners over the seabed hills.tif"), std::string::npos);
    EXPECT_EQ(page.find(folder_.path().string()), std::string::npos);

    const ProgramResult json = benchmark(dives + Arguments{"--json"});
    ASSERT_EQ(json.exitCode, 0) << json.summary();
    EXPECT_NE(json.err.find("3 of 3 jobs were done before"), std::string::npos) << "nothing is run again";
    const Json report = Json::parse(json.out, nullptr, false);
    ASSERT_TRUE(report.is_object()) << json.out;
    const Json &arena = report.at("settings").at("arena");
    EXPECT_EQ(arena.at("seabed"), "hills.tif");
    EXPECT_EQ(arena.at("clearance_m"), 12.0);
    EXPECT_TRUE(arena.at("deepest_m").is_null());
    ASSERT_EQ(report.at("settings").at("pair_list").size(), 3u);
    for (const Json &pair : report.at("settings").at("pair_list"))
        EXPECT_EQ(pair.at("start").size(), 3u) << "latitude, longitude, depth";
    ASSERT_EQ(report.at("planners").size(), 4u);
    for (const Json &planner : report.at("planners"))
    {
        SCOPED_TRACE(planner.dump());
        EXPECT_EQ(planner.at("unsafe"), 0);
        EXPECT_EQ(planner.at("crashed"), 0);
        if (planner.at("planner") == "LayeredPlanner-greedy")  // it may end in a dead end
            continue;
        EXPECT_EQ(planner.at("solved"), 3);
        EXPECT_GE(planner.at("least_clearance_m").at("lower").get<double>(), 12.0);
    }
}

TEST_F(DiveBenchmark, helpNamesTheOptionsOfDivesAndTheirPlanners)
{
    const ProgramResult help = benchmark({"--help"});
    EXPECT_EQ(help.exitCode, 0) << help.summary();
    for (const char *word : {"--bathymetry", "--band", "--values", "--datum-offset", "--no-data", "--degrees",
                             "--clearance", "--ceiling", "--deepest", "LayeredPlanner-greedy", "PrismAStar-climb"})
        EXPECT_NE(help.out.find(word), std::string::npos) << word;
}

TEST_F(DiveBenchmark, refusesAFolderOfOtherLimits)
{
    const Arguments few = {"--bathymetry", seabed(), "--pairs",      "1",       "--time", "0.1", "--planners",
                           "PrismAStar",   "--out",  out().string(), "--shard", "1/1"};
    EXPECT_EQ(benchmark(few + Arguments{"--clearance", "12"}).exitCode, 0);
    const ProgramResult other = benchmark(few + Arguments{"--clearance", "13"});
    EXPECT_EQ(other.exitCode, 2) << other.summary();
    EXPECT_NE(other.err.find("arena.clearance_m is 12.0 there and 13.0 here"), std::string::npos) << other.err;
}

TEST_F(DiveBenchmark, refusesInOneSentence)
{
    const auto expectRefusal = [this](const Arguments &arguments, int code, const std::string &words)
    {
        SCOPED_TRACE(testing::PrintToString(arguments));
        const ProgramResult result = benchmark(arguments + Arguments{"--out", out().string()});
        EXPECT_EQ(result.exitCode, code) << result.summary();
        EXPECT_EQ(result.err.rfind("benchmark_planners: error: ", 0), 0u) << result.err;
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
        EXPECT_FALSE(fs::exists(out() / "pair-0001.log"));
    };
    const std::string raster = seabed();
    expectRefusal({"--clearance", "5"}, 2, "--bathymetry");
    expectRefusal({"--bathymetry", raster, "--pitch", "20"}, 2, "--pitch");
    expectRefusal({"--bathymetry", raster, "--planners", "HexAStar"}, 2, "no planner 'HexAStar'; known are Layered");
    expectRefusal({"--planners", "PrismAStar"}, 2, "no planner 'PrismAStar'; known are HexAStar");
    expectRefusal({"--bathymetry", raster, "--clearance", "-1"}, 2, "--clearance must be 0 or more");
    expectRefusal({"--bathymetry", raster, "--ceiling", "9", "--deepest", "8"}, 2, "--deepest must be below");
    expectRefusal({"--bathymetry", raster, "--values", "hills"}, 2, "--values must be");
    expectRefusal({"--bathymetry", raster, "--band", "0"}, 2, "--band must be 1 or more");
    expectRefusal({"--bathymetry", raster, "--band", "2"}, 3, "hills.tif");
    expectRefusal({"--bathymetry", (folder_ / "none.tif").string()}, 3, "none.tif");
    expectRefusal({"--bathymetry", raster, "--clearance", "200"}, 3, "hills.tif");
    expectRefusal({"--bathymetry", raster, "--least-distance", "0.9"}, 4, "a smaller --least-distance may help");
}

}  // namespace
