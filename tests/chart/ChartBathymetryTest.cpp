#include "seahex/chart/ChartBathymetry.h"

#include "seahex/chart/ChartArena.h"
#include "seahex/chart/ChartError.h"
#include "seahex/chart/ChartReader.h"

#include "support/ChartOracle.h"
#include "support/Random.h"
#include "support/TestCharts.h"
#include "support/TestData.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// 0.1 by 0.1 degrees: 5 to 10 m in the west, 20 to 50 m in the east, an island in the middle of the south, soundings,
/// and things that lie and stand in the water.
std::filesystem::path writeBay(const TemporaryFolder &folder)
{
    const auto path = folder / "bay.gpkg";
    writeChart(path, {{"M_COVR", {{boxWkt(10.0, 50.0, 10.1, 50.1), {{"CATCOV", 1}}}}},
                      {"DEPARE",
                       {{boxWkt(10.0, 50.0, 10.04, 50.1), {{"DRVAL1", 5.0}, {"DRVAL2", 10.0}}},
                        {boxWkt(10.05, 50.0, 10.1, 50.1), {{"DRVAL1", 20.0}, {"DRVAL2", 50.0}}},
                        {boxWkt(10.04, 50.03, 10.05, 50.1), {{"DRVAL1", 10.0}}}}},
                      {"LNDARE", {{boxWkt(10.04, 50.0, 10.05, 50.03), {}}}},
                      {"SOUNDG",
                       {{"POINT (10.06 50.05)", {{"DEPTH", 30.0}}},
                        {"POINT (10.09 50.05)", {{"DEPTH", 60.0}}},
                        {"POINT (10.09 50.09)", {{"DEPTH", 30.0}}},
                        {"POINT (10.06 50.09)", {{"DEPTH", 30.0}}},
                        {"POINT (10.02 50.05)", {{"DEPTH", 7.5}}},
                        {"POINT (10.07 50.02)", {{"DEPTH", 12.0}}}}},
                      {"WRECKS", {{"POINT (10.08 50.02)", {{"VALSOU", 14.0}, {"WATLEV", 3}}}}},
                      {"OBSTRN", {{"POINT (10.085 50.03)", {{"WATLEV", 3}}}}},
                      {"CBLSUB", {{"LINESTRING (10.055 50.0,10.055 50.1)", {}}}},
                      {"PILPNT", {{"POINT (10.01 50.01)", {}}}}});
    return path;
}

/// GDAL's own reading of one layer of a chart: every point of a class with a value.
std::vector<std::pair<LatLon, double>> pointsOf(const std::string &path, const char *layerName, const char *attribute)
{
    GDALAllRegister();
    const char *const options[] = {"SPLIT_MULTIPOINT=ON", "ADD_SOUNDG_DEPTH=ON", nullptr};
    const std::unique_ptr<GDALDataset, void (*)(GDALDataset *)> dataset(
        GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR, nullptr, options), [](GDALDataset *open) { GDALClose(open); });
    std::vector<std::pair<LatLon, double>> points;
    OGRLayer *layer = dataset == nullptr ? nullptr : dataset->GetLayerByName(layerName);
    if (layer == nullptr)
        return points;
    for (const OGRFeatureUniquePtr &feature : *layer)
    {
        const OGRGeometry *geometry = feature->GetGeometryRef();
        if (geometry == nullptr || !feature->IsFieldSetAndNotNull(feature->GetFieldIndex(attribute)))
            continue;
        const double value = feature->GetFieldAsDouble(attribute);
        if (wkbFlatten(geometry->getGeometryType()) == wkbPoint)
            points.push_back({{geometry->toPoint()->getY(), geometry->toPoint()->getX()}, value});
        else if (wkbFlatten(geometry->getGeometryType()) == wkbLineString)
            for (const OGRPoint &p : *geometry->toLineString())
                points.push_back({{p.getY(), p.getX()}, value});
    }
    return points;
}

double depthAt(const Bathymetry &seabed, const Projection &projection, const LatLon &at)
{
    return seabed.depthAt(projection.forward(GeoPoint::fromLatLon(at.first, at.second)));
}

/// Never deeper than the chart's own depth areas, soundings and contours, as others read them; and not everywhere
/// unknown.
void expectLowerBound(const std::string &path, double spacingM, bool inDegreesFrame)
{
    SCOPED_TRACE(path);
    const Chart chart = readChart(path);
    const GeoPoint centre = chart.bounds.centre();
    const Projection projection =
        inDegreesFrame ? Projection::localEquirectangular(centre) : Projection::transverseMercator(centre);
    const auto least = chartBathymetry(chart, projection, spacingM);
    const auto interpolated = chartBathymetry(chart, projection, spacingM, ChartDepths::Interpolated);
    const ChartOracle oracle(path, {1.2, 0.5});
    Random random(12);
    int charted = 0;
    int known = 0;
    int deeper = 0;
    for (int i = 0; i < 3000; ++i)
    {
        const LatLon at(random.real(chart.bounds.southDeg, chart.bounds.northDeg),
                        random.real(chart.bounds.westDeg, chart.bounds.eastDeg));
        const auto depth = oracle.chartedDepth(at.first, at.second);
        const double ours = depthAt(*least, projection, at);
        const double estimate = depthAt(*interpolated, projection, at);
        EXPECT_LE(ours, estimate + 1e-6);
        charted += depth ? 1 : 0;
        known += std::isfinite(ours) ? 1 : 0;
        deeper += estimate > ours + 0.1 ? 1 : 0;
        if (std::isfinite(ours))
        {
            ASSERT_TRUE(depth.has_value()) << at.first << " " << at.second;
            ASSERT_LE(ours, *depth + 1e-5) << at.first << " " << at.second;
        }
    }
    EXPECT_GT(charted, 500);
    EXPECT_GT(known, charted / 2);
    EXPECT_GT(deeper, known / 10);
    const auto soundings = pointsOf(path, "SOUNDG", "DEPTH");
    const auto contours = pointsOf(path, "DEPCNT", "VALDCO");
    EXPECT_GT(soundings.size(), 5u);
    for (const auto &marks : {soundings, contours})
        for (const auto &[at, value] : marks)
        {
            EXPECT_LE(depthAt(*least, projection, at), value + 1e-5) << at.first << " " << at.second;
            EXPECT_LE(depthAt(*interpolated, projection, at), value + 1e-5) << at.first << " " << at.second;
        }
}

class Bay : public ::testing::Test
{
protected:
    Bay() : path(writeBay(folder)), chart(readChart(path.string())) {}

    double at(ChartDepths depths, double latitude, double longitude) const
    {
        return depthAt(*chartBathymetry(chart, frame, 50.0, depths), frame, {latitude, longitude});
    }

    TemporaryFolder folder;
    std::filesystem::path path;
    Chart chart;
    Projection frame = Projection::transverseMercator(GeoPoint::fromLatLon(50.05, 10.05));
};

TEST_F(Bay, hasTheLeastDepthOfItsAreasDownToSoundingsAndDangers)
{
    const double unknown = Bathymetry::unknownDepth;
    EXPECT_EQ(at(ChartDepths::Least, 50.05, 10.02), 5.0);
    EXPECT_EQ(at(ChartDepths::Least, 50.07, 10.08), 20.0);
    EXPECT_EQ(at(ChartDepths::Least, 50.07, 10.04), 5.0) << "on the edge of two areas";
    EXPECT_EQ(at(ChartDepths::Least, 50.02, 10.07), 12.0) << "a sounding shoaler than its area";
    EXPECT_EQ(at(ChartDepths::Least, 50.02, 10.08), 14.0) << "a wreck";
    EXPECT_EQ(at(ChartDepths::Least, 50.03, 10.085), unknown) << "an obstruction at no known depth";
    EXPECT_EQ(at(ChartDepths::Least, 50.01, 10.045), unknown) << "land";
    EXPECT_EQ(at(ChartDepths::Least, 50.01, 10.0399), unknown) << "a cell that land touches";
    EXPECT_EQ(at(ChartDepths::Least, 50.05, 10.00001), unknown) << "a cell at the coverage's edge";
    EXPECT_EQ(at(ChartDepths::Least, 50.05, 10.11), unknown);
    EXPECT_EQ(at(ChartDepths::Least, 50.01, 10.01), 5.0) << "a pile is no seabed";
}

TEST_F(Bay, isInterpolatedBetweenSoundingsWithinTheAreasDepths)
{
    const double along = at(ChartDepths::Interpolated, 50.07, 10.065);
    EXPECT_GT(along, 29.0);
    EXPECT_LE(along, 36.0);
    // half way to 60 m: 45 by the surface, less a cell's slope
    EXPECT_GT(at(ChartDepths::Interpolated, 50.0505, 10.075), 40.0);
    EXPECT_LE(at(ChartDepths::Interpolated, 50.0505, 10.075), 45.0);
    EXPECT_EQ(at(ChartDepths::Interpolated, 50.051, 10.0875), 50.0) << "not beyond the area's DRVAL2";
    EXPECT_EQ(at(ChartDepths::Interpolated, 50.07, 10.045), 10.0) << "an area without DRVAL2";
    EXPECT_EQ(at(ChartDepths::Interpolated, 50.08, 10.01), 5.0) << "outside the triangles";
    EXPECT_EQ(at(ChartDepths::Interpolated, 50.01, 10.045), Bathymetry::unknownDepth);
}

TEST_F(Bay, refusesWhatIsNoGridAndWaterThatIsNone)
{
    EXPECT_THROW(chartBathymetry(chart, Projection::plateCarree(), 50.0), std::domain_error);
    EXPECT_THROW(chartBathymetry(chart, frame, 0.0), std::domain_error);
    EXPECT_THROW(chartBathymetry(chart, frame, std::nan("")), std::domain_error);
    EXPECT_THROW(chartBathymetry(chart, frame, 0.1), std::domain_error);
    EXPECT_THROW(chartBathymetry(chart, frame, 20000.0), ChartEmpty);
}

TEST_F(Bay, columnsOfTheChartAreAllThatIsNoSeabed)
{
    ArenaOptions options;
    options.scope = HazardScope::WaterColumn;
    options.projection = frame;
    options.pitch = 30.0;
    const ChartArena arena(chart, options);
    const auto isFree = [&](double latitude, double longitude)
    {
        const HexOccupancy &columns = *arena.occupancy();
        return columns.isFree(columns.lattice().cellAt(frame.forward(GeoPoint::fromLatLon(latitude, longitude))));
    };
    EXPECT_TRUE(isFree(50.05, 10.02)) << "shallow water";
    EXPECT_TRUE(isFree(50.02, 10.07)) << "a sounding";
    EXPECT_FALSE(isFree(50.02, 10.08)) << "a wreck at 14 m";
    EXPECT_FALSE(isFree(50.03, 10.085)) << "an obstruction";
    EXPECT_FALSE(isFree(50.066, 10.055)) << "a cable";
    EXPECT_FALSE(isFree(50.01, 10.01)) << "a pile";
    EXPECT_FALSE(isFree(50.01, 10.045)) << "land";
    EXPECT_FALSE(isFree(50.11, 10.05)) << "off the chart";
}

/// What DRVAL1 and DRVAL2 of depth areas say, their contours say as well.
void expectContoursToAddNothing(const std::string &path, double spacingM)
{
    SCOPED_TRACE(path);
    Chart chart = readChart(path);
    EXPECT_GT(chart.contours.size(), 20u);
    const Projection frame = Projection::transverseMercator(chart.bounds.centre());
    const auto with = chartBathymetry(chart, frame, spacingM);
    chart.contours.clear();
    const auto without = chartBathymetry(chart, frame, spacingM);
    for (std::int64_t row = 0; row < with->grid().rows(); ++row)
        for (std::int64_t column = 0; column < with->grid().columns(); ++column)
            ASSERT_EQ(with->nodeDepth(column, row), without->nodeDepth(column, row));
}

/// How far the estimate is off, in the median, at soundings that it was not made of.
double medianMiss(const Chart &whole, bool withContours, double spacingM)
{
    Chart chart = whole;
    if (!withContours)
        chart.contours.clear();
    std::vector<const GeoHazard *> unseen;
    chart.hazards.clear();
    std::size_t soundings = 0;
    for (const GeoHazard &hazard : whole.hazards)
        if (hazard.object->rule == HazardRule::Sounding && soundings++ % 4 == 0)
            unseen.push_back(&hazard);
        else
            chart.hazards.push_back(hazard);
    const Projection frame = Projection::transverseMercator(chart.bounds.centre());
    const auto estimate = chartBathymetry(chart, frame, spacingM, ChartDepths::Interpolated);
    std::vector<double> misses;
    for (const GeoHazard *hazard : unseen)
    {
        const Point &lonLat = hazard->shape.lonLat.points.front();
        const double depth = depthAt(*estimate, frame, {lonLat.y(), lonLat.x()});
        if (std::isfinite(depth))
            misses.push_back(std::abs(depth - hazard->object->value("DEPTH").value()));
    }
    EXPECT_GT(misses.size(), unseen.size() / 2);
    const auto middle = misses.begin() + static_cast<std::ptrdiff_t>(misses.size() / 2);
    std::nth_element(misses.begin(), middle, misses.end());
    return *middle;
}

/// Deep water with soundings of 60 m, two of them near by on both sides of a long contour, with contours of which one
/// has no depth and another is shoaler than the area that it lies in.
class Contours : public ::testing::Test
{
protected:
    Contours()
    {
        writeChart(folder / "contours.gpkg",
                   {{"M_COVR", {{boxWkt(10.0, 50.0, 10.1, 50.1), {{"CATCOV", 1}}}}},
                    {"DEPARE", {{boxWkt(10.0, 50.0, 10.1, 50.1), {{"DRVAL1", 20.0}, {"DRVAL2", 100.0}}}}},
                    {"SOUNDG",
                     {{"POINT (10.01 50.01)", {{"DEPTH", 60.0}}},
                      {"POINT (10.09 50.01)", {{"DEPTH", 60.0}}},
                      {"POINT (10.01 50.09)", {{"DEPTH", 60.0}}},
                      {"POINT (10.09 50.09)", {{"DEPTH", 60.0}}},
                      {"POINT (10.045 50.05)", {{"DEPTH", 60.0}}},
                      {"POINT (10.055 50.05)", {{"DEPTH", 60.0}}}}},
                    {"DEPCNT",
                     {{"LINESTRING (10.05 50.01,10.05 50.09)", {{"VALDCO", 30.0}}},
                      {"LINESTRING (10.07 50.01,10.07 50.015)", {{"VALDCO", 15.0}}},
                      {"LINESTRING (10.02 50.01,10.02 50.09)", {}}}}});
        chart = readChart((folder / "contours.gpkg").string());
    }

    double at(ChartDepths depths, double latitude, double longitude) const
    {
        return depthAt(*chartBathymetry(chart, frame, 50.0, depths), frame, {latitude, longitude});
    }

    TemporaryFolder folder;
    Chart chart;
    Projection frame = Projection::transverseMercator(GeoPoint::fromLatLon(50.05, 10.05));
};

TEST_F(Contours, areReadWithTheirDepths)
{
    ASSERT_EQ(chart.contours.size(), 2u);
    EXPECT_EQ(chart.contours[0].depthM, 30.0);
    EXPECT_EQ(chart.contours[1].depthM, 15.0);
    EXPECT_EQ(chart.contours[0].shape.lonLat.lines.size(), 1u);
    EXPECT_EQ(chart.cells.front().skipped.at("contour without a depth (VALDCO)").at("DEPCNT"), 1u);
}

TEST_F(Contours, bendTheEstimateBetweenTheirEnds)
{
    EXPECT_EQ(at(ChartDepths::Interpolated, 50.05, 10.05), 30.0);
    // half way from 60 m at 10.045 to 30 m, less a cell's slope
    EXPECT_GT(at(ChartDepths::Interpolated, 50.05, 10.0475), 38.0);
    EXPECT_LE(at(ChartDepths::Interpolated, 50.05, 10.0475), 45.0);
    chart.contours.clear();
    EXPECT_NEAR(at(ChartDepths::Interpolated, 50.05, 10.0475), 60.0, 1e-3);
}

TEST_F(Contours, boundTheDepthWhereTheyAreShoalerThanTheirArea)
{
    EXPECT_EQ(at(ChartDepths::Least, 50.05, 10.05), 20.0);
    EXPECT_EQ(at(ChartDepths::Least, 50.012, 10.07), 15.0);
    EXPECT_EQ(at(ChartDepths::Interpolated, 50.012, 10.07), 15.0);
    EXPECT_EQ(at(ChartDepths::Least, 50.02, 10.07), 20.0);
}

TEST(ChartBathymetry, hasAllContoursOfARealChart)
{
    const std::string path = std::string(SEAHEX_MAPS_DIR) + "/shangchuan.000";
    const Chart chart = readChart(path);
    std::size_t corners = 0;
    double sum = 0.0;
    for (const DepthContour &contour : chart.contours)
        for (const auto &line : contour.shape.lonLat.lines)
        {
            corners += line.size();
            sum += contour.depthM * static_cast<double>(line.size());
        }
    double sumOfGdal = 0.0;
    const auto ofGdal = pointsOf(path, "DEPCNT", "VALDCO");
    for (const auto &[at, value] : ofGdal)
        sumOfGdal += value;
    EXPECT_EQ(corners, ofGdal.size());
    EXPECT_NEAR(sum, sumOfGdal, 1e-6);
}

TEST(ChartBathymetry, contoursAddNothingToWhatDepthAreasPromise)
{
    for (const char *chart : {"/sanya.000", "/shangchuan.000"})
        expectContoursToAddNothing(SEAHEX_MAPS_DIR + std::string(chart), 200.0);
}

TEST(ChartBathymetry, contoursAddNothingToWhatDepthAreasOfRealChartsPromise)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    expectContoursToAddNothing((charts / "noaa/US5MA12M/US5MA12M.000").string(), 40.0);
    expectContoursToAddNothing((charts / "noaa/US4MD81M/US4MD81M.000").string(), 200.0);
}

TEST(ChartBathymetry, contoursBringTheEstimateNearerToSoundingsThatItHasNotSeen)
{
    for (const char *name : {"/sanya.000", "/shangchuan.000"})
    {
        const Chart chart = readChart(SEAHEX_MAPS_DIR + std::string(name));
        EXPECT_LT(medianMiss(chart, true, 100.0), 0.8 * medianMiss(chart, false, 100.0)) << name;
    }
}

TEST(ChartBathymetry, isALowerBoundOnTheChartsOfTheProject)
{
    expectLowerBound(std::string(SEAHEX_MAPS_DIR) + "/sanya.000", 300.0, false);
    expectLowerBound(std::string(SEAHEX_MAPS_DIR) + "/shangchuan.000", 300.0, true);
}

TEST(ChartBathymetry, isALowerBoundOnRealCharts)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    expectLowerBound((charts / "noaa/US5MA12M/US5MA12M.000").string(), 20.0, false);
    expectLowerBound((charts / "noaa/US4AK3SB/US4AK3SB.000").string(), 100.0, true);
}

}  // namespace
