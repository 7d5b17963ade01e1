#include "seahex/chart/WrittenRouteCheck.h"

#include "support/TestCharts.h"

#include <seahex/chart/ChartReader.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace seahex
{
namespace
{

using test::boxWkt;

/// Deep water with a square island, a bridge over the north, and a rock.
Chart smallChart()
{
    test::TemporaryFolder folder;
    const auto path = folder / "small.gpkg";
    test::writeChart(path,
                     {{"M_COVR", {{boxWkt(10.0, 50.0, 10.1, 50.1), {{"CATCOV", 1}}}}},
                      {"DEPARE",
                       {{"POLYGON ((10 50,10.1 50,10.1 50.1,10 50.1,10 50),(10.04 50.04,10.04 50.06,10.06 50.06,10.06 "
                         "50.04,10.04 50.04))",
                         {{"DRVAL1", 10.0}, {"DRVAL2", 20.0}}}}},
                      {"LNDARE", {{boxWkt(10.04, 50.04, 10.06, 50.06), {}}}},
                      {"BRIDGE", {{"LINESTRING (10.05 50.06,10.05 50.1)", {{"VERCLR", 12.0}}}}},
                      {"UWTROC", {{"POINT (10.05 50.02)", {{"WATLEV", 3}}}}}});
    return readChart(path.string());
}

std::vector<GeoPoint> line(const std::vector<std::pair<double, double>> &latLon)
{
    std::vector<GeoPoint> points;
    for (const auto &[latitude, longitude] : latLon)
        points.push_back(GeoPoint::fromLatLon(latitude, longitude));
    return points;
}

/// In metres, and in degrees.
class WrittenRouteCheckOf : public testing::TestWithParam<bool>
{
protected:
    static ArenaOptions options()
    {
        ArenaOptions o;
        o.projection =
            GetParam() ? Projection::transverseMercator(GeoPoint::fromLatLon(50.05, 10.05)) : Projection::plateCarree();
        o.scope = GetParam() ? HazardScope::All : HazardScope::LandOnly;
        o.pitch = GetParam() ? 50.0 : 0.0005;
        return o;
    }

    Chart chart_ = smallChart();
    ChartArena arena_{chart_, options()};
    WrittenRouteCheck check_{chart_, arena_};
};

TEST_P(WrittenRouteCheckOf, findsTheLegThatTouchesLand)
{
    const auto around = line({{50.05, 10.01}, {50.03, 10.02}, {50.03, 10.08}, {50.05, 10.09}});
    EXPECT_FALSE(check_.firstFault(around));
    const auto across = line({{50.05, 10.01}, {50.05, 10.02}, {50.05, 10.08}});
    const auto fault = check_.firstFault(across);
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->leg, 1u);
    EXPECT_NE(fault->what.find("LNDARE"), std::string::npos) << fault->what;
}

TEST_P(WrittenRouteCheckOf, findsTheLegThatLeavesTheChart)
{
    const auto fault = check_.firstFault(line({{50.05, 10.01}, {50.05, 9.99}}));
    ASSERT_TRUE(fault);
    EXPECT_NE(fault->what.find("coverage"), std::string::npos) << fault->what;
}

TEST_P(WrittenRouteCheckOf, touchesAtACorner)
{
    EXPECT_TRUE(check_.firstFault(line({{50.03, 10.03}, {50.05, 10.03}, {50.03, 10.05}})))
        << "through the island's corner at 50.04 N 10.04 E";
    EXPECT_FALSE(check_.firstFault(line({{50.03, 10.03}, {50.0499, 10.03}, {50.03, 10.0499}})));
}

TEST_P(WrittenRouteCheckOf, measuresMetresToTheHazardItself)
{
    // along a parallel 0.01 degree south of the island and 0.01 north of the rock: 1112.3 m on WGS-84 at 50 N
    const double clearance = check_.leastClearanceM(line({{50.03, 10.01}, {50.03, 10.09}}));
    EXPECT_NEAR(clearance, 1112.3, 1.0);
}

TEST_P(WrittenRouteCheckOf, namesWhatIsNotJudgedYet)
{
    const auto under = check_.crossedCautions(line({{50.08, 10.01}, {50.08, 10.09}, {50.08, 10.01}}));
    ASSERT_EQ(under.size(), 1u);
    EXPECT_EQ(under.front()->objectClass, "BRIDGE");
    EXPECT_TRUE(check_.crossedCautions(line({{50.03, 10.01}, {50.03, 10.09}})).empty());
}

INSTANTIATE_TEST_SUITE_P(Frames, WrittenRouteCheckOf, testing::Bool(),
                         [](const auto &frame) { return frame.param ? "metres" : "degrees"; });

TEST(WrittenRouteCheck, keepsTheRadiusOfPoints)
{
    const Chart chart = smallChart();
    ArenaOptions options;
    options.pitch = 50.0;
    const ChartArena arena(chart, options);
    const WrittenRouteCheck check(chart, arena);
    // 0.00008 degree of latitude are 8.9 m, 0.0001 are 11.1 m
    EXPECT_TRUE(check.firstFault(line({{50.02008, 10.04}, {50.02008, 10.06}})));
    EXPECT_FALSE(check.firstFault(line({{50.0201, 10.04}, {50.0201, 10.06}})));
}

}  // namespace
}  // namespace seahex
