#include "seahex/chart/CableCrossing.h"

#include "seahex/chart/ChartArena.h"
#include "seahex/chart/ChartBathymetry.h"
#include "seahex/chart/ChartReader.h"
#include "seahex/world/DiveArena.h"

#include "support/TestCharts.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// 50 m of water; a cable from shore to shore at 10.05 E, one that hangs at 30 m at 10.02 E, a cable area in the east,
/// and a pile in the line of the first.
class Cables : public ::testing::Test
{
protected:
    Cables()
    {
        writeChart(
            folder / "cables.gpkg",
            {{"M_COVR", {{boxWkt(10.0, 50.0, 10.1, 50.1), {{"CATCOV", 1}}}}},
             {"DEPARE", {{boxWkt(10.0, 50.0, 10.1, 50.1), {{"DRVAL1", 50.0}, {"DRVAL2", 100.0}}}}},
             {"CBLSUB",
              {{"LINESTRING (10.05 50.0,10.05 50.1)", {}}, {"LINESTRING (10.02 50.0,10.02 50.1)", {{"DRVAL1", 30.0}}}}},
             {"CBLARE", {{boxWkt(10.08, 50.0, 10.09, 50.1), {}}}},
             {"PILPNT", {{"POINT (10.05 50.02)", {}}}}});
        chart = readChart((folder / "cables.gpkg").string());
        seabed = chartBathymetry(chart, frame, 50.0);
    }

    Point at(double latitude, double longitude) const
    {
        return frame.forward(GeoPoint::fromLatLon(latitude, longitude));
    }

    DiveArena arena(HazardScope scope, const std::shared_ptr<const Bathymetry> &over) const
    {
        ArenaOptions options;
        options.scope = scope;
        options.projection = frame;
        options.pitch = 30.0;
        DiveLimits limits;
        limits.clearanceM = 2.0;
        return {over, limits, ChartArena(chart, options).occupancy()};
    }

    TemporaryFolder folder;
    Chart chart;
    std::shared_ptr<const Bathymetry> seabed;
    Projection frame = Projection::transverseMercator(GeoPoint::fromLatLon(50.05, 10.05));
};

TEST_F(Cables, raiseTheSeabedWhereTheyLie)
{
    const auto raised = raiseCables(*seabed, chart, frame, 8.0);
    EXPECT_EQ(raised->depthAt(at(50.05, 10.05)), 42.0);
    EXPECT_EQ(raised->depthAt(at(50.05, 10.05014)), 42.0) << "10 m beside the line";
    EXPECT_EQ(raised->depthAt(at(50.05, 10.02)), 22.0) << "of known depth";
    EXPECT_EQ(raised->depthAt(at(50.05, 10.085)), 42.0) << "somewhere in the area";
    EXPECT_EQ(raised->depthAt(at(50.05, 10.035)), 50.0);
    EXPECT_EQ(raised->depthAt(at(50.05, 10.055)), 50.0) << "350 m away";
    EXPECT_EQ(raiseCables(*seabed, chart, frame, 8.0, 400.0)->depthAt(at(50.05, 10.055)), 42.0) << "within the margin";
    EXPECT_EQ(raiseCables(*seabed, chart, frame, 0.0)->depthAt(at(50.05, 10.05)), 50.0);
}

TEST_F(Cables, areWallsOrAreCrossedAbove)
{
    const auto across = [&](double latitude, double depthM)
    {
        const Point a = at(latitude, 10.04);
        const Point b = at(latitude, 10.06);
        return std::pair(Point3(a.x(), a.y(), depthM), Point3(b.x(), b.y(), depthM));
    };
    const auto [high, highEnd] = across(50.05, 39.0);
    const auto [low, lowEnd] = across(50.05, 41.0);
    const auto [pile, pileEnd] = across(50.02, 10.0);
    const DiveArena walls = arena(HazardScope::WaterColumn, seabed);
    EXPECT_FALSE(walls.isFree(high, highEnd));
    const DiveArena above = arena(HazardScope::WaterColumnAboveCables, raiseCables(*seabed, chart, frame, 8.0));
    EXPECT_TRUE(above.isFree(high, highEnd));
    EXPECT_FALSE(above.isFree(low, lowEnd)) << "clearance and height above the cable, 50 m deep";
    EXPECT_TRUE(above.isFree(low)) << "but it may be as deep beside it";
    EXPECT_FALSE(above.isFree(pile, pileEnd)) << "other columns stay";
}

TEST_F(Cables, refuseWhatIsNoHeight)
{
    EXPECT_THROW(raiseCables(*seabed, chart, frame, -1.0), std::domain_error);
    EXPECT_THROW(raiseCables(*seabed, chart, frame, std::nan("")), std::domain_error);
    EXPECT_THROW(raiseCables(*seabed, chart, frame, 1.0, -1.0), std::domain_error);
    EXPECT_THROW(raiseCables(*seabed, chart, Projection::plateCarree(), 1.0), std::domain_error);
}

}  // namespace
