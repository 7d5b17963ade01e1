#include "seahex/chart/Projection.h"

#include "seahex/chart/ChartReader.h"

#include "support/TestCharts.h"
#include "support/TestData.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>

using namespace seahex;

namespace
{

double distanceToSegment(const Point &p, const Point &a, const Point &b)
{
    const Point along = b - a;
    const double lengthSquared = along.squaredNorm();
    const double t = lengthSquared > 0.0 ? std::clamp((p - a).dot(along) / lengthSquared, 0.0, 1.0) : 0.0;
    return (p - (a + t * along)).norm();
}

double distanceToPath(const Point &p, const std::vector<Point> &path)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < path.size(); ++i)
        least = std::min(least, distanceToSegment(p, path[i - 1], path[i]));
    return least;
}

/// The largest distance between the straight longitude-latitude edge, sampled, and its image, both ways.
double deviation(const Projection &projection, const GeoPoint &from, const GeoPoint &to,
                 const std::vector<Point> &image)
{
    constexpr int SAMPLES = 3000;
    std::vector<Point> truth;
    for (int i = 0; i <= SAMPLES; ++i)
    {
        const double t = static_cast<double>(i) / SAMPLES;
        truth.push_back(projection.forward(
            GeoPoint::fromLatLon(from.latitudeDeg() + t * (to.latitudeDeg() - from.latitudeDeg()),
                                 from.longitudeDeg() + t * (to.longitudeDeg() - from.longitudeDeg()))));
    }
    double worst = 0.0;
    for (const Point &sample : truth)
        worst = std::max(worst, distanceToPath(sample, image));
    for (std::size_t i = 1; i < image.size(); ++i)
        for (double t : {0.25, 0.5, 0.75})
            worst = std::max(worst, distanceToPath(image[i - 1] + t * (image[i] - image[i - 1]), truth));
    return worst;
}

std::vector<Point> imageOf(const Projection &projection, const GeoPoint &from, const GeoPoint &to)
{
    GeoShape line;
    line.lonLat.lines.push_back(
        {Point(from.longitudeDeg(), from.latitudeDeg()), Point(to.longitudeDeg(), to.latitudeDeg())});
    const LineString image = projection.forward(line).lines.at(0);
    return {image.begin(), image.end()};
}

double degrees(int low, int high)
{
    return 1e-4 * *rc::gen::inRange(low * 10000, high * 10000 + 1);
}

TEST(Projection, hasItsOriginAtTheCentreAndUnitScale)
{
    const GeoPoint centre = GeoPoint::fromLatLon(42.27, -70.905);
    const Projection projection = Projection::transverseMercator(centre);
    EXPECT_TRUE(projection.isMetric());
    EXPECT_EQ(projection.name(), "transverse Mercator at 42.270000 N 70.905000 W");
    EXPECT_LT(projection.forward(centre).norm(), 1e-6);
    // A minute of latitude at 42.27 degrees measures 1851.3 m on WGS-84; north is up, east is right.
    const Point north = projection.forward(GeoPoint::fromLatLon(42.27 + 1.0 / 60.0, -70.905));
    EXPECT_NEAR(north.y(), 1851.3, 0.2);
    EXPECT_NEAR(north.x(), 0.0, 1e-6);
    EXPECT_GT(projection.forward(GeoPoint::fromLatLon(42.27, -70.9)).x(), 400.0);
}

RC_GTEST_PROP(Projection, returnsWithinAMillimetre, ())
{
    const GeoPoint centre = GeoPoint::fromLatLon(degrees(-80, 80), degrees(-180, 180));
    const Projection projection = Projection::transverseMercator(centre);
    const GeoPoint position =
        GeoPoint::fromLatLon(centre.latitudeDeg() + degrees(-5, 5), centre.longitudeDeg() + degrees(-5, 5));
    const GeoPoint back = projection.inverse(projection.forward(position));
    RC_ASSERT(std::abs(back.latitudeDeg() - position.latitudeDeg()) < 1e-3 / 111e3);
    RC_ASSERT(std::abs(back.longitudeDeg() - position.longitudeDeg()) < 1e-3 / 111e3);
}

TEST(Projection, keepsLongitudesOfAChartAcrossTheDateLine)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(-17.0, 179.9));
    const GeoPoint beyond = GeoPoint::fromLatLon(-17.0, 180.4);
    EXPECT_NEAR(projection.inverse(projection.forward(beyond)).longitudeDeg(), 180.4, 1e-9);
}

TEST(Projection, bendsTheLongLegOfTheDesign)
{
    // 190 km east to west near 39 degrees north; the straight chord is off by hundreds of metres.
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(37.0, -74.3));
    const GeoPoint from = GeoPoint::fromLatLon(39.0, -75.4);
    const GeoPoint to = GeoPoint::fromLatLon(39.0, -73.2);
    const std::vector<Point> image = imageOf(projection, from, to);
    EXPECT_GT(deviation(projection, from, to, {image.front(), image.back()}), 500.0);
    EXPECT_LE(deviation(projection, from, to, image), projection.edgeToleranceM());
    EXPECT_LT(image.size(), 200u);
}

RC_GTEST_PROP(Projection, keepsEveryEdgeWithinItsTolerance, ())
{
    const GeoPoint centre = GeoPoint::fromLatLon(degrees(-75, 75), degrees(-170, 170));
    const Projection projection = Projection::transverseMercator(centre);
    const auto near = [&]
    {
        // All sizes of edges: from metres to hundreds of kilometres.
        const double scale = std::pow(10.0, -*rc::gen::inRange(0, 5));
        return GeoPoint::fromLatLon(centre.latitudeDeg() + 3.0 * scale * degrees(-1, 1),
                                    centre.longitudeDeg() + 3.0 * scale * degrees(-1, 1));
    };
    const GeoPoint from = near();
    const GeoPoint to = near();
    const std::vector<Point> image = imageOf(projection, from, to);
    RC_ASSERT(deviation(projection, from, to, image) <= projection.edgeToleranceM());
    RC_ASSERT(image.front() == projection.forward(from));
    RC_ASSERT(image.back() == projection.forward(to));

    std::vector<Point> reversed = imageOf(projection, to, from);
    std::reverse(reversed.begin(), reversed.end());
    RC_ASSERT(reversed == image);
}

TEST(Projection, densifiesALineToTheToleranceAskedFor)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(60.0, 5.0));
    const GeoPoint from = GeoPoint::fromLatLon(60.2, 3.5);
    const GeoPoint to = GeoPoint::fromLatLon(60.9, 6.5);
    std::size_t corners = 0;
    for (double toleranceM : {10.0, 1.0, 0.01})
    {
        const LineString image = projection.forward({from, to}, toleranceM);
        EXPECT_LE(deviation(projection, from, to, {image.begin(), image.end()}), toleranceM);
        EXPECT_GT(image.size(), corners);
        corners = image.size();
    }
    EXPECT_EQ(projection.forward({from}, 1.0).size(), 1u);
    EXPECT_TRUE(projection.forward(std::vector<GeoPoint>{}, 1.0).empty());
}

TEST(Projection, giveNeighbouringAreasTheSameEdgeAndClosesRings)
{
    const auto box = [](double west, double east)
    {
        Polygon area;
        area.outer() = {Point(west, 58.0), Point(east, 58.0), Point(east, 60.0), Point(west, 60.0), Point(west, 58.0)};
        return area;
    };
    GeoShape shape;
    shape.lonLat.areas = {box(3.0, 5.0), box(5.0, 7.0)};
    shape.lonLat.areas[1].inners().push_back({Point(5.5, 59), Point(6.5, 59.2), Point(6, 59.5), Point(5.5, 59)});
    shape.lonLat.points = {Point(5.0, 59.0)};
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(59.0, 4.0));
    const Shape image = projection.forward(shape);
    ASSERT_EQ(image.areas.size(), 2u);
    ASSERT_EQ(image.areas[1].inners().size(), 1u);
    EXPECT_EQ(image.points.at(0), projection.forward(GeoPoint::fromLatLon(59.0, 5.0)));

    const Point south = projection.forward(GeoPoint::fromLatLon(58.0, 5.0));
    const Point north = projection.forward(GeoPoint::fromLatLon(60.0, 5.0));
    const auto edge = [](const Ring &ring, const Point &from, const Point &to)
    {
        const auto begin = std::find(ring.begin(), ring.end(), from);
        const auto end = std::find(begin, ring.end(), to);
        EXPECT_TRUE(begin != ring.end() && end != ring.end());
        return end == ring.end() ? std::vector<Point>{} : std::vector<Point>(begin, end + 1);
    };
    const std::vector<Point> up = edge(image.areas[0].outer(), south, north);
    std::vector<Point> down = edge(image.areas[1].outer(), north, south);
    // The second ring starts at the south end, so its way down ends at the ring's close.
    std::reverse(down.begin(), down.end());
    EXPECT_GT(up.size(), 3u);
    EXPECT_EQ(up, down);
    for (const Polygon &area : image.areas)
    {
        EXPECT_EQ(area.outer().front(), area.outer().back());
        for (const Ring &hole : area.inners())
            EXPECT_EQ(hole.front(), hole.back());
    }
}

TEST(Projection, keepsDegreesInThePlateCarree)
{
    const Projection projection = Projection::plateCarree();
    EXPECT_FALSE(projection.isMetric());
    EXPECT_EQ(projection.edgeToleranceM(), 0.0);
    const GeoPoint position = GeoPoint::fromLatLon(21.635, 112.521);
    EXPECT_EQ(projection.forward(position), Point(112.521, 21.635));
    EXPECT_EQ(projection.inverse(Point(112.521, 21.635)), position);
    GeoShape shape;
    shape.lonLat.lines.push_back({Point(0, 0), Point(90, 60)});
    EXPECT_EQ(projection.forward(shape).lines.at(0), shape.lonLat.lines.at(0));
    EXPECT_EQ(projection.forward({position, GeoPoint::fromLatLon(-40, 3)}, 0.01).size(), 2u);
    EXPECT_THROW(projection.inverse(Point(0, 91)), PositionError);
}

TEST(Projection, refusesWhatHasNoImage)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(40.0, 10.0));
    EXPECT_THROW(projection.inverse(Point(nan, 0.0)), PositionError);
    EXPECT_THROW(projection.inverse(Point(0.0, std::numeric_limits<double>::infinity())), PositionError);
    EXPECT_THROW(projection.inverse(Point(1e12, 0.0)), PositionError);
    EXPECT_THROW(Projection::plateCarree().inverse(Point(nan, 0.0)), PositionError);
    GeoShape shape;
    shape.lonLat.points.push_back(Point(nan, 40.0));
    EXPECT_THROW(projection.forward(shape), PositionError);
    shape.lonLat.points.clear();
    shape.lonLat.lines.push_back({Point(10.0, 40.0), Point(10.0, nan)});
    EXPECT_THROW(projection.forward(shape), PositionError);
}

TEST(Projection, isSharedBetweenThreads)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(60.0, 5.0));
    const GeoPoint from = GeoPoint::fromLatLon(60.2, 3.5);
    const GeoPoint to = GeoPoint::fromLatLon(60.9, 6.5);
    const std::vector<Point> expected = imageOf(projection, from, to);
    std::vector<int> wrong(4, 0);
    std::vector<std::thread> threads;
    for (int &count : wrong)
        threads.emplace_back(
            [&]
            {
                for (int i = 0; i < 100; ++i)
                    count += imageOf(projection, from, to) != expected;
            });
    for (std::thread &thread : threads)
        thread.join();
    EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

TEST(Projection, keepsTheCoverageOfACoastalCellWithinTolerance)
{
    SEAHEX_TEST_DATA_OR_SKIP(charts, "charts");
    const Chart chart = readChart((charts / "noaa/US3DE01M").string());
    const Projection projection = Projection::transverseMercator(chart.bounds.centre());
    const Ring &coverage = chart.coverage.lonLat.areas.at(0).outer();
    double worst = 0.0;
    double worstChord = 0.0;
    for (std::size_t i = 1; i < coverage.size(); ++i)
    {
        const GeoPoint from = GeoPoint::fromLonLat(coverage[i - 1].x(), coverage[i - 1].y());
        const GeoPoint to = GeoPoint::fromLonLat(coverage[i].x(), coverage[i].y());
        const std::vector<Point> image = imageOf(projection, from, to);
        worst = std::max(worst, deviation(projection, from, to, image));
        worstChord = std::max(worstChord, deviation(projection, from, to, {image.front(), image.back()}));
    }
    EXPECT_LE(worst, projection.edgeToleranceM());
    EXPECT_GT(worstChord, 10.0) << "the edges are no test of bending";
}

TEST(Projection, projectsEveryHazardOfAChart)
{
    Chart chart;
    auto object = std::make_shared<HazardObject>();
    GeoShape shape;
    shape.lonLat.points = {Point(10.0, 40.0)};
    chart.hazards = {{object, shape}, {object, shape}};
    const auto hazards = projectHazards(chart, Projection::transverseMercator(GeoPoint::fromLatLon(40.0, 10.0)));
    ASSERT_EQ(hazards.size(), 2u);
    EXPECT_EQ(hazards[0].object, object);
    EXPECT_LT(hazards[1].shape.points.at(0).norm(), 1e-6);
}

TEST(Projection, theScaleIsABoundOfThePlanesStretch)
{
    for (const double latitude : {0.0, 21.5, 60.0, 75.0})
    {
        const auto projection = Projection::transverseMercator(GeoPoint::fromLatLon(latitude, 10.0));
        for (const double east : {0.0, 0.5, 3.0, 12.0, 25.0})
        {
            // a short leg northward: 1e-4 degree along the meridian, whose length on WGS-84 is known
            const Point a = projection.forward(GeoPoint::fromLatLon(latitude, 10.0 + east));
            const Point b = projection.forward(GeoPoint::fromLatLon(latitude + 1e-4, 10.0 + east));
            const double radians = 3.14159265358979323846 / 180.0;
            const double sine = std::sin((latitude + 5e-5) * radians);
            const double curvature =
                6378137.0 * (1.0 - 0.00669437999014) / std::pow(1.0 - 0.00669437999014 * sine * sine, 1.5);
            const double scale = (b - a).norm() / (1e-4 * radians * curvature);
            EXPECT_LE(scale, projection.largestScale(Box{a.cwiseMin(b), a.cwiseMax(b)}) + 1e-7)
                << latitude << " " << east;
            EXPECT_GE(scale, 0.99 * projection.largestScale(Box{a, a})) << "and not a wild one";
        }
    }
    EXPECT_EQ(Projection::plateCarree().largestScale(Box{Point(0, 0), Point(100, 100)}), 1.0);
}

TEST(Projection, localEquirectangularIsAffine)
{
    const auto projection = Projection::localEquirectangular(GeoPoint::fromLatLon(39.5, 8.0));
    EXPECT_TRUE(projection.isMetric());
    EXPECT_EQ(projection.edgeToleranceM(), 0.0);
    EXPECT_EQ(projection.forward(GeoPoint::fromLatLon(39.5, 8.0)), Point(0, 0));
    const Point degree = projection.forward(GeoPoint::fromLatLon(40.5, 9.0));
    EXPECT_EQ(degree, metresPerDegree(39.5));
    // The lengths of a degree at latitude 40, to a metre: 85,394 and 111,035 (WGS-84, tables of the NGA).
    EXPECT_NEAR(metresPerDegree(40.0).x(), 85393.7, 1.0);
    EXPECT_NEAR(metresPerDegree(40.0).y(), 111034.6, 1.0);
    EXPECT_EQ(projection.forward(GeoPoint::fromLatLon(39.5, 368.5)),
              projection.forward(GeoPoint::fromLatLon(39.5, 8.5)));

    GeoShape line;
    line.lonLat.lines.push_back({Point(2.0, 37.0), Point(14.0, 42.0)});
    const Shape image = projection.forward(line);
    ASSERT_EQ(image.lines.at(0).size(), 2u) << "straight lines stay straight";
    for (const double t : {0.1, 0.5, 0.9})
    {
        const GeoPoint back = projection.inverse(image.lines[0][0] + t * (image.lines[0][1] - image.lines[0][0]));
        EXPECT_NEAR(back.longitudeDeg(), 2.0 + 12.0 * t, 1e-12);
        EXPECT_NEAR(back.latitudeDeg(), 37.0 + 5.0 * t, 1e-12);
    }
    EXPECT_THROW(projection.inverse(Point(0, 6e6)), PositionError);
    EXPECT_THROW(Projection::localEquirectangular(GeoPoint::fromLatLon(86.0, 8.0)), PositionError);
}

TEST(Projection, theScaleOfALocalEquirectangularIsABoundAndItsErrorIsWhatTheHeaderSays)
{
    for (const double latitude : {-60.0, -2.0, 0.0, 21.5, 40.0, 70.0})
    {
        const auto projection = Projection::localEquirectangular(GeoPoint::fromLatLon(latitude, 10.0));
        const Point here = metresPerDegree(latitude);
        for (const double south : {-3.0, -1.0, 0.0, 2.0})
            for (const double height : {0.0, 1.0, 5.0})
            {
                const Box box{Point(-1e5, south * here.y()), Point(1e5, (south + height) * here.y())};
                const double largest = projection.largestScale(box);
                double seen = 0.0;
                for (int i = 0; i <= 100; ++i)
                {
                    const Point there = metresPerDegree(latitude + south + height * i / 100.0);
                    seen = std::max({seen, here.x() / there.x(), here.y() / there.y()});
                }
                EXPECT_LE(seen, largest * (1.0 + 1e-12)) << latitude << " " << south << " " << height;
                EXPECT_GE(seen, largest * (1.0 - 1e-6));
            }
    }
    const double off = metresPerDegree(40.0).x() / metresPerDegree(40.0 + 100.0 / 111.0).x() - 1.0;
    EXPECT_NEAR(off, 0.0132, 0.0005) << "100 km north of latitude 40";
}

}  // namespace
