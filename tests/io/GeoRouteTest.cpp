#include "seahex/io/GeoRoute.h"

#include "support/Random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

// The readings are measured here without GeographicLib and without Projection::forward: rhumb lines through the
// isometric latitude, geodesics through the chord of the ellipsoid, distances in space.

namespace seahex
{

namespace
{

using Space = Eigen::Vector3d;

constexpr double DEGREE = 0.017453292519943295;
constexpr double A_M = 6378137.0;
constexpr double FLATTENING = 1.0 / 298.257223563;
constexpr double E2 = FLATTENING * (2.0 - FLATTENING);

struct LatLon
{
    double latitudeDeg;
    double longitudeDeg;
};

LatLon latLon(const GeoPoint &p)
{
    return {p.latitudeDeg(), p.longitudeDeg()};
}

Space inSpace(const LatLon &p)
{
    const double phi = p.latitudeDeg * DEGREE;
    const double lambda = p.longitudeDeg * DEGREE;
    const double n = A_M / std::sqrt(1.0 - E2 * std::sin(phi) * std::sin(phi));
    return {n * std::cos(phi) * std::cos(lambda), n * std::cos(phi) * std::sin(lambda), n * (1.0 - E2) * std::sin(phi)};
}

/// The foot on the ellipsoid of a point near it, by iteration.
LatLon onEllipsoid(const Space &p)
{
    const double across = std::hypot(p.x(), p.y());
    double phi = std::atan2(p.z(), across * (1.0 - E2));
    for (int i = 0; i < 8; ++i)
    {
        const double n = A_M / std::sqrt(1.0 - E2 * std::sin(phi) * std::sin(phi));
        phi = std::atan2(p.z() + E2 * n * std::sin(phi), across);
    }
    return {phi / DEGREE, std::atan2(p.y(), p.x()) / DEGREE};
}

double isometric(double latitudeDeg)
{
    const double e = std::sqrt(E2);
    const double sine = std::sin(latitudeDeg * DEGREE);
    return std::atanh(sine) - e * std::atanh(e * sine);
}

/// The three readings of a leg at t in [0, 1].
std::vector<Space> readings(const LatLon &a, const LatLon &b, double t)
{
    const double longitudeSpan = std::remainder(b.longitudeDeg - a.longitudeDeg, 360.0);
    const LatLon straight{a.latitudeDeg + t * (b.latitudeDeg - a.latitudeDeg), a.longitudeDeg + t * longitudeSpan};

    // a rhumb line is straight over isometric latitude; along a parallel that is no measure, but longitude is
    LatLon rhumb = straight;
    if (std::abs(b.latitudeDeg - a.latitudeDeg) > 1e-7)
        rhumb.longitudeDeg = a.longitudeDeg + longitudeSpan *
                                                  (isometric(rhumb.latitudeDeg) - isometric(a.latitudeDeg)) /
                                                  (isometric(b.latitudeDeg) - isometric(a.latitudeDeg));

    // the foot of the chord leaves the geodesic by far less than a centimetre as long as a leg is below 50 km
    const Space chord = inSpace(a) + t * (inSpace(b) - inSpace(a));
    return {inSpace(straight), inSpace(rhumb), inSpace(onEllipsoid(chord))};
}

double distanceToSegment(const Space &p, const Space &a, const Space &b)
{
    const double square = (b - a).squaredNorm();
    const double t = square > 0.0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0.0;
    return (p - (a + t * (b - a))).norm();
}

/// The plane's leg as a polyline in space, `stepM` metres apart.
std::vector<Space> drawn(const Leg &leg, const Projection &projection, double stepM)
{
    const double lengthM = leg.length() * (projection.isMetric() ? 1.0 : 111320.0);
    const int n = static_cast<int>(lengthM / stepM) + 1;
    std::vector<Space> line;
    for (int i = 0; i <= n; ++i)
        line.push_back(
            inSpace(latLon(projection.inverse(leg.from + (static_cast<double>(i) / n) * (leg.to - leg.from)))));
    return line;
}

double distanceToLine(const Space &p, const std::vector<Space> &line)
{
    double least = (p - line.front()).norm();
    for (std::size_t i = 1; i < line.size(); ++i)
        least = std::min(least, distanceToSegment(p, line[i - 1], line[i]));
    return least;
}

/// The greatest distance of any reading of the written legs from a route of one leg.
double worstReadingM(const GeoRoute &written, const Leg &leg, const Projection &projection, int samples)
{
    const std::vector<Space> line = drawn(leg, projection, 200.0);  // pieces sag by 1 mm
    double worst = 0.0;
    for (std::size_t i = 1; i < written.waypoints.size(); ++i)
        for (int k = 0; k <= samples; ++k)
            for (const Space &reading : readings(latLon(written.waypoints[i - 1]), latLon(written.waypoints[i]),
                                                 static_cast<double>(k) / samples))
                worst = std::max(worst, distanceToLine(reading, line));
    return worst;
}

bool isRounded(double deg)
{
    return std::abs(deg * 1e7 - std::round(deg * 1e7)) < 1e-4;  // what a double keeps of it
}

void expectWritten(const GeoRoute &written, const GeoPoint &start, const GeoPoint &goal)
{
    ASSERT_GE(written.waypoints.size(), 2U);
    EXPECT_EQ(written.waypoints.front(), start);
    EXPECT_EQ(written.waypoints.back(), goal);
    for (std::size_t i = 1; i + 1 < written.waypoints.size(); ++i)
    {
        const GeoPoint &p = written.waypoints[i];
        EXPECT_TRUE(isRounded(p.latitudeDeg()) && isRounded(p.longitudeDeg())) << toString(p);
        EXPECT_GE(p.longitudeDeg(), -180.0);
        EXPECT_LT(p.longitudeDeg(), 180.0);
        EXPECT_NE(p, written.waypoints[i - 1]);
    }
}

/// Writes the leg between two points of the plane and checks all that toGeoRoute promises.
GeoRoute checkLeg(const Projection &projection, const Point &a, const Point &b, int samples = 64)
{
    const Leg leg{a, b};
    const GeoPoint start = projection.inverse(a);
    const GeoPoint goal = projection.inverse(b);
    const GeoRoute written = toGeoRoute(Route({a, b}), projection, start, goal);
    expectWritten(written, start, goal);
    EXPECT_LE(worstReadingM(written, leg, projection, samples), legToleranceM + 0.002)
        << toString(start) << " to " << toString(goal) << ", " << projection.name();
    return written;
}

Point polar(double length, double angle)
{
    return {length * std::cos(angle), length * std::sin(angle)};
}

/// Length of the meridian between two latitudes, by Simpson's rule.
double meridianM(double fromDeg, double toDeg)
{
    const auto radius = [](double deg)
    {
        const double sine = std::sin(deg * DEGREE);
        return A_M * (1.0 - E2) / std::pow(1.0 - E2 * sine * sine, 1.5);
    };
    const int n = 2000;
    const double h = (toDeg - fromDeg) / n;
    double sum = radius(fromDeg) + radius(toDeg);
    for (int i = 1; i < n; ++i)
        sum += (i % 2 == 1 ? 4.0 : 2.0) * radius(fromDeg + i * h);
    return sum * h * DEGREE / 3.0;
}

}  // namespace

TEST(GeoRoute, ReadingsOfRandomLegsStayNearTheLineInMetricFrames)
{
    test::Random random(7001);
    SCOPED_TRACE(random.seedText());
    for (const double latitude : {-70.0, -45.0, -12.0, 0.0, 0.5, 21.6, 42.3, 58.0, 70.0, 78.0})
        for (int i = 0; i < 6; ++i)
        {
            const Projection projection =
                Projection::transverseMercator(GeoPoint::fromLatLon(latitude, random.real(-180.0, 180.0)));
            const double lengthM = std::pow(10.0, random.real(0.0, 4.7));
            const Point a = polar(random.real(0.0, 100000.0), random.real(0.0, 6.3));
            checkLeg(projection, a, a + polar(lengthM, random.real(0.0, 6.3)), 40);
        }
}

TEST(GeoRoute, ReadingsOfRandomLegsStayNearTheLineInDegrees)
{
    test::Random random(7002);
    SCOPED_TRACE(random.seedText());
    const Projection projection = Projection::plateCarree();
    for (int i = 0; i < 60; ++i)
    {
        const Point a(random.real(-179.0, 179.0), random.real(-75.0, 75.0));
        const double lengthDeg = std::pow(10.0, random.real(-4.0, -0.3));
        checkLeg(projection, a, a + polar(lengthDeg, random.real(0.0, 6.3)), 40);
    }
}

TEST(GeoRoute, LongLegsAreParted)
{
    for (const double latitude : {-70.0, -33.0, 42.0, 70.0})
    {
        SCOPED_TRACE(latitude);
        const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(latitude, -70.9));
        // along the parallel, along the meridian, and past the centre in an S
        const GeoRoute eastward = checkLeg(projection, {-95000.0, 20000.0}, {95000.0, 20000.0});
        const GeoRoute northward = checkLeg(projection, {90000.0, -95000.0}, {90000.0, 95000.0});
        checkLeg(projection, {-60000.0, -70000.0}, {60000.0, 70000.0});

        // Without waypoints between, a rhumb line leaves the eastward leg by L^2 tan(latitude) / 8R, hundreds of
        // metres.
        const GeoRoute bare{{eastward.waypoints.front(), eastward.waypoints.back()}};
        EXPECT_GT(worstReadingM(bare, {{-95000.0, 20000.0}, {95000.0, 20000.0}}, projection, 16), 400.0);
        EXPECT_GT(eastward.waypoints.size(), northward.waypoints.size());
        // and no more than the halving of 190 km to about 6 km at middle latitudes, 3 km at 70 degrees, needs
        EXPECT_LE(eastward.waypoints.size(), 129U);
    }
}

// Across the equator all readings are S-shaped: their middles lie on the line whatever the rest does.
TEST(GeoRoute, LegsAcrossTheEquatorAreParted)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(0.0, 7.0));
    const GeoRoute written = checkLeg(projection, {-67000.0, -67000.0}, {67000.0, 67000.0});
    EXPECT_GT(written.waypoints.size(), 2U);
    EXPECT_EQ(written.waypoints.size() % 2, 1U);
}

TEST(GeoRoute, AMeridianNeedsNoWaypoints)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(42.0, -70.9));
    EXPECT_EQ(checkLeg(projection, {0.0, -20000.0}, {0.0, 20000.0}).waypoints.size(), 2U);
}

TEST(GeoRoute, LegsMayCrossTheAntimeridian)
{
    const Projection metric = Projection::transverseMercator(GeoPoint::fromLatLon(-17.0, 179.9));
    const GeoRoute written = checkLeg(metric, {-40000.0, 3000.0}, {60000.0, -8000.0});
    EXPECT_GT(written.waypoints.front().longitudeDeg(), 179.0);
    EXPECT_LT(written.waypoints[written.waypoints.size() - 2].longitudeDeg(), -179.0);

    checkLeg(Projection::plateCarree(), {179.8, 60.0}, {180.3, 60.1});
    // the ends as people give them, on either side of the plane's own count
    const Route route({Point(179.8, 60.0), Point(180.3, 60.1)});
    const GeoPoint start = GeoPoint::fromLatLon(60.0, 179.8);
    const GeoPoint goal = GeoPoint::fromLatLon(60.1, -179.7);
    expectWritten(toGeoRoute(route, Projection::plateCarree(), start, goal), start, goal);
}

TEST(GeoRoute, KeepsTheWaypointsOfTheRoute)
{
    test::Random random(7003);
    SCOPED_TRACE(random.seedText());
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(42.27, -70.905));
    for (int i = 0; i < 20; ++i)
    {
        std::vector<Point> points;
        for (int k = 0; k < 12; ++k)
            points.push_back(random.pointIn({Point(-30000.0, -30000.0), Point(30000.0, 30000.0)}));
        const GeoPoint start = projection.inverse(points.front());
        const GeoPoint goal = projection.inverse(points.back());
        const GeoRoute written = toGeoRoute(Route(points), projection, start, goal);
        expectWritten(written, start, goal);
        std::size_t next = 0;
        for (const GeoPoint &waypoint : written.waypoints)
            if (next < points.size() && (projection.forward(waypoint) - points[next]).norm() < 0.01)
                ++next;
        EXPECT_EQ(next, points.size()) << "the route's waypoints, in their order";
    }
}

TEST(GeoRoute, StartAndGoalAreAsGiven)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(42.0, -70.0));
    const GeoPoint start = GeoPoint::fromLatLon(42.0123456789, 289.987654321);  // more decimals, longitude beyond 180
    const GeoPoint goal = GeoPoint::fromLatLon(42.0222222222, -70.0333333333);
    const Route route({projection.forward(start), projection.forward(goal)});
    expectWritten(toGeoRoute(route, projection, start, goal), start, goal);
}

TEST(GeoRoute, LeavesOutRepetitions)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(42.0, -70.0));
    const GeoPoint start = GeoPoint::fromLatLon(42.00000001, -70.0);
    const GeoPoint goal = GeoPoint::fromLatLon(42.01, -70.01);
    const Point a = projection.forward(start);
    const Point b(-500.0, 500.0);
    const Point c = projection.forward(goal);
    const Point tiny(1e-4, -1e-4);
    const GeoRoute written =
        toGeoRoute(Route({a, a, a + tiny, b, b, b + tiny, b, c - tiny, c, c}), projection, start, goal);
    expectWritten(written, start, goal);
    EXPECT_EQ(written.waypoints.size(), 3U);

    // out and back along the same line is no repetition
    const GeoRoute back = toGeoRoute(Route({a, b, a}), projection, start, start);
    EXPECT_EQ(back.waypoints.size(), 3U);
}

TEST(GeoRoute, HasTwoWaypointsAtLeast)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(42.0, -70.0));
    const GeoPoint here = GeoPoint::fromLatLon(42.001, -70.002);
    const Point image = projection.forward(here);
    const std::vector<GeoPoint> twice{here, here};
    EXPECT_EQ(toGeoRoute(Route({image}), projection, here, here).waypoints, twice);
    EXPECT_EQ(toGeoRoute(Route({image, image}), projection, here, here).waypoints, twice);
    EXPECT_EQ(toGeoRoute(Route({image, image, image}), projection, here, here).waypoints, twice);
    EXPECT_TRUE(toGeoRoute(Route(), projection, here, here).waypoints.empty());
    EXPECT_EQ(rhumbLengthM({twice}), 0.0);
    EXPECT_EQ(rhumbLengthM({}), 0.0);
}

TEST(GeoRoute, RefusesEndsThatAreNotTheRoutes)
{
    const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(42.0, -70.0));
    const GeoPoint start = GeoPoint::fromLatLon(42.0, -70.0);
    const GeoPoint goal = GeoPoint::fromLatLon(42.01, -70.0);
    const GeoPoint off = GeoPoint::fromLatLon(42.00001, -70.0);  // 1.1 m
    const Route route({projection.forward(start), projection.forward(goal)});
    EXPECT_THROW(toGeoRoute(route, projection, off, goal), PositionError);
    EXPECT_THROW(toGeoRoute(route, projection, start, off), PositionError);
    EXPECT_THROW(toGeoRoute(Route({projection.forward(start)}), projection, start, goal), PositionError);
    const Route degrees({Point(-70.0, 42.0), Point(-70.0, 42.01)});
    EXPECT_THROW(toGeoRoute(degrees, Projection::plateCarree(), off, goal), PositionError);
    EXPECT_NO_THROW(toGeoRoute(degrees, Projection::plateCarree(), start, goal));
}

TEST(GeoRoute, RefusesWhatIsNoPosition)
{
    const Route route({Point(0.0, 80.0), Point(0.0, 95.0), Point(0.0, 80.0)});
    const GeoPoint start = GeoPoint::fromLatLon(80.0, 0.0);
    EXPECT_THROW(toGeoRoute(route, Projection::plateCarree(), start, start), PositionError);
}

// Rhumb lines wind around a pole, and longitudes jump there.
TEST(GeoRoute, LegsMayPassThePoles)
{
    for (const double latitude : {89.0, -89.0})
        for (const double offsetM : {0.25, 5.0, 100.0})
        {
            const Projection projection = Projection::transverseMercator(GeoPoint::fromLatLon(latitude, 10.0));
            const double pole = projection.forward(GeoPoint::fromLatLon(std::copysign(90.0, latitude), 10.0)).y();
            checkLeg(projection, Point(-9000.0, pole + offsetM), Point(11000.0, pole + offsetM));
        }
}

TEST(GeoRoute, WrittenPositionsAreRoundedAndInRange)
{
    EXPECT_EQ(writtenPosition(GeoPoint::fromLatLon(42.12345678, -70.98765432)),
              GeoPoint::fromLatLon(42.1234568, -70.9876543));
    for (const double longitude : {180.0, -180.0, 540.0, 179.99999999, -180.00000001})
        EXPECT_EQ(writtenPosition(GeoPoint::fromLatLon(0.0, longitude)).longitudeDeg(), -180.0) << longitude;
    EXPECT_EQ(writtenPosition(GeoPoint::fromLatLon(0.0, 289.5)).longitudeDeg(), -70.5);
    EXPECT_FALSE(std::signbit(writtenPosition(GeoPoint::fromLatLon(-1e-9, -1e-9)).latitudeDeg()));
}

TEST(RhumbLeg, AgreesWithTheMeridianTheParallelAndTheLoxodrome)
{
    // a minute of latitude at 45 degrees: 1852.2 m
    const RhumbLeg minute =
        rhumbLeg(GeoPoint::fromLatLon(45.0 - 1.0 / 120.0, 10.0), GeoPoint::fromLatLon(45.0 + 1.0 / 120.0, 10.0));
    EXPECT_NEAR(minute.lengthM, meridianM(45.0 - 1.0 / 120.0, 45.0 + 1.0 / 120.0), 1e-5);
    EXPECT_NEAR(minute.lengthM, 1852.2, 0.05);
    EXPECT_EQ(minute.courseDeg, 0.0);

    const double phi = -38.0 * DEGREE;
    const double radiusM = A_M * std::cos(phi) / std::sqrt(1.0 - E2 * std::sin(phi) * std::sin(phi));
    const RhumbLeg westward = rhumbLeg(GeoPoint::fromLatLon(-38.0, -179.9), GeoPoint::fromLatLon(-38.0, 179.9));
    EXPECT_NEAR(westward.lengthM, radiusM * 0.2 * DEGREE, 1e-5);
    EXPECT_NEAR(westward.courseDeg, 270.0, 1e-9);

    test::Random random(7004);
    SCOPED_TRACE(random.seedText());
    for (int i = 0; i < 200; ++i)
    {
        const double fromDeg = random.real(-80.0, 80.0);
        const double toDeg = random.real(-80.0, 80.0);
        const double west = random.real(-90.0, 0.0);
        const double east = random.real(0.0, 90.0);
        const double eastward = (east - west) * DEGREE;
        const double tangent = eastward / (isometric(toDeg) - isometric(fromDeg));  // of the course
        const RhumbLeg leg = rhumbLeg(GeoPoint::fromLatLon(fromDeg, west), GeoPoint::fromLatLon(toDeg, east));
        EXPECT_NEAR(leg.lengthM / (std::abs(meridianM(fromDeg, toDeg)) * std::hypot(1.0, tangent)), 1.0, 1e-9);
        EXPECT_NEAR(std::tan(leg.courseDeg * DEGREE) / tangent, 1.0, 1e-7);
        EXPECT_TRUE(leg.courseDeg > 0.0 && leg.courseDeg < 180.0) << leg.courseDeg;
    }
}

TEST(RhumbLeg, LengthsAddUp)
{
    const GeoRoute route{{GeoPoint::fromLatLon(42.0, -70.0), GeoPoint::fromLatLon(43.0, -70.0),
                          GeoPoint::fromLatLon(43.0, -69.0), GeoPoint::fromLatLon(42.0, -69.0)}};
    const double phi = 43.0 * DEGREE;
    const double parallelM = DEGREE * A_M * std::cos(phi) / std::sqrt(1.0 - E2 * std::sin(phi) * std::sin(phi));
    EXPECT_NEAR(rhumbLengthM(route), 2.0 * meridianM(42.0, 43.0) + parallelM, 1e-4);
}

}  // namespace seahex
