// What plan_route refuses: each with its documented exit code, one sentence, no file and no crash.

#include "demos/PlanRoute.h"

#include <algorithm>
#include <random>

using namespace seahex::test;

namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

enum Code
{
    Usage = 2,
    BadChart = 3,
    NotNavigable = 4,
    NoRoute = 5,
    OutOfTime = 6
};

const char *statusOf(int code)
{
    switch (code)
    {
        case Usage:
            return "usage";
        case BadChart:
            return "chart";
        case NotNavigable:
            return "not_navigable";
        case NoRoute:
            return "no_route";
        default:
            return "out_of_time";
    }
}

class PlanRouteRefusal : public testing::Test
{
protected:
    fs::path file(const std::string &name) const { return folder_ / name; }

    /// Runs with text and with --json. Expects the code, the words in one sentence, and no output file.
    void expectRefusal(const Arguments &arguments, Code code, const std::vector<std::string> &words = {})
    {
        SCOPED_TRACE(testing::PrintToString(arguments));
        const TemporaryFolder outputs;
        Arguments all = arguments;
        for (const auto &[option, name] : {std::pair("--out", "r.geojson"), std::pair("--picture", "r.svg")})
            if (std::find(all.begin(), all.end(), option) == all.end())
                all = all + Arguments{option, (outputs / name).string()};

        const ProgramResult text = planRoute(all);
        EXPECT_EQ(text.exitCode, code) << text.summary();
        EXPECT_EQ(text.out, "");
        const std::string intro = "plan_route: error: ";
        ASSERT_EQ(text.err.rfind(intro, 0), 0u) << text.summary();
        const std::string sentence = text.err.substr(intro.size(), text.err.size() - intro.size() - 1);
        EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
        EXPECT_EQ(text.err.back(), '\n');
        EXPECT_GT(sentence.size(), 15u) << sentence;
        EXPECT_LT(sentence.size(), 600u) << sentence;
        for (const std::string &word : words)
            EXPECT_NE(sentence.find(word), std::string::npos) << "'" << word << "' is not in: " << sentence;

        const ProgramResult json = planRoute(all + Arguments{"--json"});
        EXPECT_EQ(json.exitCode, code) << json.summary();
        EXPECT_EQ(json.err, "");
        const Json object = Json::parse(json.out, nullptr, false);
        EXPECT_EQ(object, Json({{"status", statusOf(code)}, {"exit", static_cast<int>(code)}, {"message", sentence}}))
            << json.summary();
        EXPECT_TRUE(fs::is_empty(outputs.path())) << "a file is left behind";
    }

    void expectBadChart(const fs::path &chart, const std::vector<std::string> &words = {})
    {
        expectRefusal({"--chart", chart.string(), "--from", "21.635,112.521", "--to", "21.669,112.901"}, BadChart,
                      words);
    }

    TemporaryFolder folder_;
};

TEST_F(PlanRouteRefusal, missingChart)
{
    expectBadChart(file("nowhere.000"), {"nowhere.000"});
}

TEST_F(PlanRouteRefusal, cellCutWithinARecord)
{
    const std::string bytes = readBytes(shangchuan());
    for (const std::size_t length :
         {std::size_t{3}, std::size_t{1000}, bytes.size() / 4, bytes.size() / 2, bytes.size() - 1})
    {
        writeBytes(file("cut.000"), bytes.substr(0, length));
        expectBadChart(file("cut.000"), {"cut.000"});
    }
}

TEST_F(PlanRouteRefusal, cellCutBetweenRecords)
{
    const std::string bytes = readBytes(shangchuan());
    const std::vector<std::size_t> starts = recordStarts(bytes);
    ASSERT_GT(starts.size(), 100u);
    for (const std::size_t records :
         {std::size_t{1}, std::size_t{3}, starts.size() / 2, starts.size() - 3, starts.size() - 2})
    {
        writeBytes(file("cut.000"), bytes.substr(0, starts[records]));
        expectBadChart(file("cut.000"), {"cut.000"});
    }
}

TEST_F(PlanRouteRefusal, folderWithoutAChart)
{
    writeBytes(file("readme.txt"), "no chart here\n");
    expectBadChart(folder_.path(), {folder_.path().string()});
}

TEST_F(PlanRouteRefusal, whatIsNoChart)
{
    std::string jpeg("\xff\xd8\xff\xe0\x00\x10JFIF\x00\x01\x01\x00\x00\x01\x00\x01\x00\x00", 20);
    std::mt19937 random(5);
    while (jpeg.size() < 5000)
        jpeg += static_cast<char>(random() & 0xff);
    writeBytes(file("photo.000"), jpeg);
    expectBadChart(file("photo.000"), {"photo.000"});
    writeBytes(file("empty.000"), "");
    expectBadChart(file("empty.000"), {"empty.000"});
    writeBytes(file("text.geojson"), "{\"type\": \"FeatureCollection\", \"features\": [");
    expectBadChart(file("text.geojson"), {"text.geojson"});
}

TEST_F(PlanRouteRefusal, chartWithoutWater)
{
    writeChart(file("dry.gpkg"), {{"M_COVR", {{boxWkt(112.0, 21.0, 113.0, 22.0), {{"CATCOV", 1}}}}},
                                  {"LNDARE", {{boxWkt(112.0, 21.0, 113.0, 22.0), {}}}}});
    expectBadChart(file("dry.gpkg"), {"no depth area"});
}

TEST_F(PlanRouteRefusal, vesselDeeperThanAllWater)
{
    expectRefusal(aroundShangchuan() + Arguments{"--draught", "1000"}, BadChart, {"no navigable cell", "1000.5"});
}

TEST_F(PlanRouteRefusal, badPositions)
{
    const auto refused = [this](const std::string &from, const std::vector<std::string> &words)
    {
        expectRefusal({"--chart", shangchuan(), "--from", from, "--to", "21.669,112.901"}, Usage, words);
    };
    refused("nan,112.521", {"--from", "nan"});
    refused("21.635,nan", {"--from"});
    refused("inf,112.521", {"--from"});
    refused("91,112.521", {"--from", "91"});
    refused("-90.001,112.521", {"--from"});
    refused("112.521,21.635", {"--from", "112.521"});  // swapped
    refused("21.635", {"--from"});
    refused("here", {"--from", "here"});
    expectRefusal({"--chart", shangchuan(), "--from", "21.635,112.521", "--to", "21.635,400"}, Usage, {"--to"});
    expectRefusal({"--chart", shangchuan(), "--from", "21.635,112.521"}, Usage, {"--to", "missing"});
    expectRefusal({"--chart", shangchuan(), "--to", "21.635,112.521"}, Usage, {"--from", "missing"});
}

TEST_F(PlanRouteRefusal, positionsOutsideTheCoverage)
{
    expectRefusal({"--chart", shangchuan(), "--from", "30,112.5", "--to", "21.669,112.901"}, NotNavigable,
                  {"start", "outside the chart", "21.5"});
    expectRefusal({"--chart", shangchuan(), "--from", "21.635,112.521", "--to", "21.635,100"}, NotNavigable,
                  {"goal", "outside the chart"});
}

TEST_F(PlanRouteRefusal, swappedPositionsGetAHint)
{
    writeTinyChart(file("tiny.gpkg"), false);
    expectRefusal({"--chart", file("tiny.gpkg").string(), "--from", "30.02,40.05", "--to", "40.05,30.08"}, NotNavigable,
                  {"start", "swapped"});
}

TEST_F(PlanRouteRefusal, startOnLand)
{
    expectRefusal({"--chart", shangchuan(), "--from", "21.6756,112.793", "--to", "21.669,112.901"}, NotNavigable,
                  {"start", "LNDARE", "nearest navigable position 21.", " m away"});
    expectRefusal({"--chart", shangchuan(), "--from", "21.635,112.521", "--to", "21.6756,112.793"}, NotNavigable,
                  {"goal", "LNDARE", "nearest navigable position 21.", " m away"});
}

TEST_F(PlanRouteRefusal, clearStartInABlockedCell)
{
    // 100 m from the wall: far beyond cells of 20 m, and within those of 1 km.
    writeTinyChart(file("tiny.gpkg"), true);
    const Arguments arguments = {"--chart",     file("tiny.gpkg").string(), "--from", "40.05,30.0388", "--to",
                                 "40.07,30.015"};
    expectRefusal(arguments + Arguments{"--pitch", "1000"}, NotNavigable,
                  {"the cell around start", "LNDARE", "the position itself is clear", "finer --pitch", " m away"});
    EXPECT_TRUE(routeReport(arguments).is_object());
}

TEST_F(PlanRouteRefusal, badNumbers)
{
    for (const char *pitch : {"0", "-5", "nan", "inf", "abc", "", "1e-300", "1e-9", "0.2", "20 m"})
    {
        expectRefusal(aroundShangchuan() + Arguments{"--pitch", pitch}, Usage, {"--pitch"});
        expectRefusal({"--scenario", "cheng2020", "--pitch", pitch == std::string("0.2") ? "1e-7" : pitch}, Usage,
                      {"--pitch"});
    }
    for (const char *option : {"--draught", "--ukc", "--margin", "--time"})
        for (const char *value : {"-1", "nan", "inf", "much"})
            expectRefusal(aroundShangchuan() + Arguments{option, value}, Usage, {option});
    for (const char *rings : {"0", "4", "-1", "two", "1.5"})
        expectRefusal(aroundShangchuan() + Arguments{"--rings", rings}, Usage, {"--rings"});
    expectRefusal(aroundShangchuan() + Arguments{"--seed", "many"}, Usage, {"--seed"});
}

TEST_F(PlanRouteRefusal, unknownNames)
{
    expectRefusal(aroundShangchuan() + Arguments{"--fast"}, Usage, {"--fast"});
    expectRefusal(aroundShangchuan() + Arguments{"elsewhere"}, Usage, {"elsewhere"});
    expectRefusal(aroundShangchuan() + Arguments{"--planner", "Dijkstra"}, Usage, {"Dijkstra", "HexAStar", "RRTstar"});
    expectRefusal(aroundShangchuan() + Arguments{"--guidance", "luck"}, Usage, {"luck", "tie_break"});
    expectRefusal(aroundShangchuan() + Arguments{"--metric", "fuel"}, Usage, {"fuel", "lattice"});
    expectRefusal({"--scenario", "cheng2021"}, Usage, {"cheng2021", "cheng2020"});
    expectRefusal({}, Usage, {"--chart"});
}

TEST_F(PlanRouteRefusal, optionsThatDoNotGoTogether)
{
    expectRefusal({"--scenario", "cheng2020", "--margin", "10"}, Usage, {"--margin", "cheng2020"});
    expectRefusal({"--scenario", "cheng2020", "--draught", "2"}, Usage, {"--draught", "cheng2020"});
}

TEST_F(PlanRouteRefusal, placesToWriteThatDoNotExist)
{
    const TemporaryFolder outputs;
    const std::string nowhere = (outputs / "nowhere").string();
    expectRefusal(aroundShangchuan() + Arguments{"--picture", (outputs / "x.bmp").string()}, Usage, {".svg", "x.bmp"});
    expectRefusal(aroundShangchuan() + Arguments{"--out", nowhere + "/r.geojson"}, Usage, {"--out", nowhere});
    expectRefusal(aroundShangchuan() + Arguments{"--picture", nowhere + "/r.png"}, Usage, {"--picture", nowhere});
    expectRefusal(aroundShangchuan() + Arguments{"--out", outputs.path().string()}, Usage, {outputs.path().string()});
    fs::create_directory(outputs / "r.svg");
    expectRefusal(aroundShangchuan() + Arguments{"--picture", (outputs / "r.svg").string()}, Usage, {"r.svg"});
    fs::remove(outputs / "r.svg");
    EXPECT_TRUE(fs::is_empty(outputs.path()));
}

TEST_F(PlanRouteRefusal, separateWaters)
{
    writeTinyChart(file("wall.gpkg"), true);
    const Arguments acrossTheWall = {"--chart",    file("wall.gpkg").string(), "--from", "40.05,30.02", "--to",
                                     "40.05,30.08"};
    expectRefusal(acrossTheWall, NoRoute, {"no route", "cell size"});
    expectRefusal(acrossTheWall + Arguments{"--planner", "RRTstar", "--time", "0.3"}, OutOfTime, {"RRTstar", "0.3"});
}

TEST_F(PlanRouteRefusal, noTime)
{
    expectRefusal(aroundShangchuan() + Arguments{"--time", "0"}, OutOfTime, {"HexAStar", "--time"});
}

}  // namespace
