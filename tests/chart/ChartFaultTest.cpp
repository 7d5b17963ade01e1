// Charts that are sound files but say something impossible or dangerous about their own coverage.

#include "seahex/chart/ChartError.h"
#include "seahex/chart/ChartReader.h"
#include "seahex/world/BlockingRule.h"

#include "support/TestCharts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

using namespace seahex;
using namespace seahex::test;

namespace
{

TestFeature coverage(const std::string &wkt, int catcov = 1)
{
    return {wkt, {{"CATCOV", catcov}}};
}

TestFeature deepWater(const std::string &wkt)
{
    return {wkt, {{"DRVAL1", 10.0}, {"DRVAL2", 20.0}}};
}

Chart read(const std::vector<TestLayer> &layers)
{
    const TemporaryFolder folder;
    const auto path = folder / "chart.gpkg";
    writeChart(path, layers);
    return readChart(path.string());
}

double gapFraction(const Chart &chart)
{
    return chart.cells.at(0).groupOne.gapFraction;
}

TEST(ChartFault, aGapIsFoundAlthoughAnOverlapMakesUpForItsArea)
{
    const Chart chart =
        read({{"M_COVR", {coverage(boxWkt(10.0, 50.0, 10.2, 50.1))}},
              {"DEPARE", {deepWater(boxWkt(10.0, 50.0, 10.1, 50.1)), deepWater(boxWkt(10.0, 50.0, 10.1, 50.1))}}});
    EXPECT_EQ(chart.cells.at(0).groupOne.twiceAreaDifference, "0");
    EXPECT_FALSE(chart.cells.at(0).groupOne.tiles);
    EXPECT_NEAR(gapFraction(chart), 0.5, 1e-9);
    EXPECT_TRUE(std::any_of(chart.hazards.begin(), chart.hazards.end(),
                            [](const GeoHazard &hazard) { return hazard.object->rule == HazardRule::ChartGap; }));
}

TEST(ChartFault, aGapIsFoundAlthoughAnAreaBeyondTheCoverageMakesUpForIt)
{
    const Chart chart = read({{"M_COVR", {coverage(boxWkt(10.0, 50.0, 10.2, 50.1))}},
                              {"DEPARE", {deepWater(boxWkt(9.9, 50.0, 10.1, 50.1))}}});
    EXPECT_EQ(chart.cells.at(0).groupOne.twiceAreaDifference, "0");
    EXPECT_NEAR(gapFraction(chart), 0.5, 1e-9);
}

TEST(ChartFault, areasThatShareLinesButNotCornersTile)
{
    // the southern area has corners on the northern one's edge and on the coverage's that the others lack
    const Chart chart =
        read({{"M_COVR", {coverage(boxWkt(10.0, 50.0, 10.2, 50.1))}},
              {"DEPARE",
               {deepWater("POLYGON ((10 50, 10.05 50, 10.2 50, 10.2 50.05, 10.1 50.05, 10 50.05, 10 50.02, 10 50))"),
                deepWater(boxWkt(10.0, 50.05, 10.2, 50.1))}}});
    EXPECT_TRUE(chart.cells.at(0).groupOne.tiles);
    EXPECT_EQ(gapFraction(chart), 0.0);
    EXPECT_TRUE(chart.cells.at(0).warnings.empty()) << chart.cells.at(0).warnings.front();
}

TEST(ChartFault, stripsTileUnlessOneIsMissing)
{
    // Strips between two jagged lines: neighbours share all corners, in opposite order, and are stored in any order.
    constexpr int STRIPS = 12;
    constexpr int CORNERS = 40;
    std::mt19937 random(7);
    std::vector<std::vector<std::string>> lines;
    for (int line = 0; line <= STRIPS; ++line)
    {
        std::vector<std::string> corners;
        for (int i = 0; i <= CORNERS; ++i)
        {
            const bool isJagged = line > 0 && line < STRIPS && i > 0 && i < CORNERS;
            const int north = 500000 + 100 * line + (isJagged ? static_cast<int>(random() % 80) : 0);
            corners.push_back("10." + std::to_string(1000 + i) + " " + std::to_string(north / 10000) + "." +
                              std::to_string(10000 + north % 10000).substr(1));
        }
        lines.push_back(corners);
    }
    const auto strip = [&lines](std::size_t south, std::size_t north)
    {
        std::string wkt = "POLYGON ((";
        for (const std::string &corner : lines[south])
            wkt += corner + ", ";
        for (auto corner = lines[north].rbegin(); corner != lines[north].rend(); ++corner)
            wkt += *corner + ", ";
        return deepWater(wkt + lines[south].front() + "))");
    };
    std::vector<TestFeature> strips;
    for (std::size_t i = 0; i < STRIPS; ++i)
        strips.push_back(strip(i, i + 1));
    std::shuffle(strips.begin(), strips.end(), random);
    const std::vector<TestFeature> whole = {coverage(strip(0, STRIPS).wkt)};

    const Chart sound = read({{"M_COVR", whole}, {"DEPARE", strips}});
    EXPECT_EQ(sound.cells.at(0).groupOne.twiceAreaDifference, "0");
    EXPECT_TRUE(sound.cells.at(0).groupOne.tiles);
    EXPECT_TRUE(sound.cells.at(0).warnings.empty());

    strips.pop_back();
    const Chart gap = read({{"M_COVR", whole}, {"DEPARE", strips}});
    EXPECT_FALSE(gap.cells.at(0).groupOne.tiles);
    EXPECT_NEAR(gapFraction(gap), 1.0 / STRIPS, 0.05);
    strips.push_back(strips.front());
    const Chart twice = read({{"M_COVR", whole}, {"DEPARE", strips}});
    EXPECT_FALSE(twice.cells.at(0).groupOne.tiles);
    EXPECT_GT(gapFraction(twice), 0.0);
}

TEST(ChartFault, whatIsDeclaredToHoldNoDataIsTakenOutOfTheCoverage)
{
    const Chart chart =
        read({{"M_COVR", {coverage(boxWkt(10.0, 50.0, 10.2, 50.1)), coverage(boxWkt(10.05, 50.02, 10.1, 50.05), 2)}},
              {"DEPARE", {deepWater(boxWkt(10.0, 50.0, 10.2, 50.1))}}});
    ASSERT_EQ(chart.coverage.lonLat.areas.size(), 1u);
    EXPECT_EQ(chart.coverage.lonLat.areas.front().inners().size(), 1u);
}

TEST(ChartFault, noDataBesideTheCoverageChangesNothing)
{
    const Chart chart =
        read({{"M_COVR", {coverage(boxWkt(10.0, 50.0, 10.1, 50.1)), coverage(boxWkt(10.1, 50.0, 10.2, 50.1), 2)}},
              {"DEPARE", {deepWater(boxWkt(10.0, 50.0, 10.1, 50.1))}}});
    EXPECT_TRUE(chart.cells.at(0).groupOne.tiles);
    EXPECT_EQ(chart.bounds.eastDeg, 10.1);
}

TEST(ChartFault, aCoverageThatCrossesItselfIsRefused)
{
    EXPECT_THROW(read({{"M_COVR", {coverage("POLYGON ((10 50, 10.2 50.1, 10.2 50, 10 50.1, 10 50))")}},
                       {"DEPARE", {deepWater(boxWkt(10.0, 50.0, 10.2, 50.1))}}}),
                 ChartDamaged);
}

TEST(ChartFault, aChartAroundHalfTheWorldIsRefused)
{
    EXPECT_THROW(read({{"M_COVR", {coverage(boxWkt(-179.9, 10.0, 179.9, 10.1))}},
                       {"DEPARE", {deepWater(boxWkt(-179.9, 10.0, 179.9, 10.1))}}}),
                 ChartUnsupported);
    EXPECT_THROW(read({{"M_COVR", {coverage(boxWkt(179.9, 10.0, 180.2, 10.1))}},
                       {"DEPARE", {deepWater(boxWkt(179.9, 10.0, 180.2, 10.1))}}}),
                 ChartUnsupported);
}

TEST(ChartFault, aNewObjectThatShowsIsKeptClearOfLikeAnyDanger)
{
    const Chart chart = read({{"M_COVR", {coverage(boxWkt(10.0, 50.0, 10.1, 50.1))}},
                              {"DEPARE", {deepWater(boxWkt(10.0, 50.0, 10.1, 50.1))}},
                              {"NEWOBJ", {{"POINT (10.05 50.05)", {{"WATLEV", 2}}}}}});
    const auto object = std::find_if(chart.hazards.begin(), chart.hazards.end(),
                                     [](const GeoHazard &hazard) { return hazard.object->objectClass == "NEWOBJ"; });
    ASSERT_NE(object, chart.hazards.end());
    EXPECT_TRUE(judge(*object->object, Vessel()).blocks());
    EXPECT_EQ(object->object->radiusM, 10.0);
}

TEST(ChartFault, cellsAwayFromTheWindowAreLeftAside)
{
    const std::vector<std::string> maps = {std::string(SEAHEX_MAPS_DIR) + "/shangchuan.000",
                                           std::string(SEAHEX_MAPS_DIR) + "/sanya.000"};
    EXPECT_EQ(readChart(maps).cells.size(), 2u);
    const Chart near = readChart(maps, GeoBox{109.5, 18.1, 109.6, 18.2});
    ASSERT_EQ(near.cells.size(), 1u);
    EXPECT_EQ(near.cells.front().name, "sanya");
    EXPECT_NE(near.cells.front().warnings.back().find("shangchuan"), std::string::npos);
    EXPECT_EQ(readChart(maps, GeoBox{0.0, 0.0, 1.0, 1.0}).cells.size(), 2u) << "none would be left";
}

}  // namespace
