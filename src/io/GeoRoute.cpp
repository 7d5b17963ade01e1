#include "seahex/io/GeoRoute.h"

#include "seahex/geometry/SegmentDistance.h"

#include "seahex/io/ScaleBar.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GeodesicLine.hpp>
#include <GeographicLib/Rhumb.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace seahex
{

namespace
{

using GeographicLib::Geodesic;
using GeographicLib::GeodesicLine;
using GeographicLib::Rhumb;
using GeographicLib::RhumbLine;

/// Intervals between the points at which a reading is measured. A bow is caught in full by its middle; an S, as of a
/// leg across the central meridian, to 2 %.
constexpr int SAMPLES = 16;

/// What of the tolerance the measured points may take.
constexpr double SAMPLED_SHARE = 0.95;

/// Halvings after which a leg is given up: one around the whole earth would be in pieces of 4 cm.
constexpr int DEEPEST = 30;

/// A straight piece of the plane, as a measure for positions.
class PlanePiece
{
public:
    PlanePiece(const Projection &projection, const Point &a, const Point &b) : projection_(projection), a_(a), b_(b) {}

    /// Metres from the position to the piece; infinite if the position has no image.
    double distanceM(const GeoPoint &position) const
    {
        Point image;
        try
        {
            image = projection_.forward(position);
        }
        catch (const PositionError &)
        {
            return std::numeric_limits<double>::infinity();
        }
        if (projection_.isMetric())
            return distanceToSegment(image, a_, b_);
        image.x() += 360.0 * std::round((0.5 * (a_.x() + b_.x()) - image.x()) / 360.0);
        const Point metres(metresPerDegreeOfLongitude(position.latitudeDeg()),
                           metresPerDegreeOfLatitude(position.latitudeDeg()));
        return distanceToSegment(Point::Zero(), (a_ - image).cwiseProduct(metres), (b_ - image).cwiseProduct(metres));
    }

private:
    const Projection &projection_;
    Point a_;
    Point b_;
};

/// The three ways to read a written leg, each from 0 (its start) to 1.
class Readings
{
public:
    Readings(const GeoPoint &from, const GeoPoint &to)
        : from_(from), latitudeSpanDeg_(to.latitudeDeg() - from.latitudeDeg()),
          longitudeSpanDeg_(std::remainder(to.longitudeDeg() - from.longitudeDeg(), 360.0)), leg_(rhumbLeg(from, to)),
          rhumb_(Rhumb::WGS84().Line(from.latitudeDeg(), from.longitudeDeg(), leg_.courseDeg)),
          geodesic_(Geodesic::WGS84().InverseLine(from.latitudeDeg(), from.longitudeDeg(), to.latitudeDeg(),
                                                  to.longitudeDeg()))
    {
    }

    /// Whether all three lie within the distance of the piece, at t.
    bool areWithin(double limitM, const PlanePiece &piece, double t) const
    {
        return piece.distanceM(straight(t)) <= limitM && isWithin(limitM, piece, rhumb_, t * leg_.lengthM) &&
               isWithin(limitM, piece, geodesic_, t * geodesic_.Distance());
    }

private:
    GeoPoint straight(double t) const
    {
        return GeoPoint::fromLatLon(from_.latitudeDeg() + t * latitudeSpanDeg_,
                                    from_.longitudeDeg() + t * longitudeSpanDeg_);
    }

    template <class Line>
    static bool isWithin(double limitM, const PlanePiece &piece, const Line &line, double distanceM)
    {
        double latitudeDeg = 0.0;
        double longitudeDeg = 0.0;
        line.Position(distanceM, latitudeDeg, longitudeDeg);
        // a rhumb line that runs over a pole has no longitude there
        return std::isfinite(longitudeDeg) &&
               piece.distanceM(GeoPoint::fromLatLon(latitudeDeg, longitudeDeg)) <= limitM;
    }

    GeoPoint from_;
    double latitudeSpanDeg_;
    double longitudeSpanDeg_;
    RhumbLeg leg_;
    RhumbLine rhumb_;
    GeodesicLine geodesic_;
};

bool readsAsDrawn(const PlanePiece &piece, const GeoPoint &from, const GeoPoint &to)
{
    const Readings readings(from, to);
    for (int i = 0; i <= SAMPLES; ++i)
        if (!readings.areWithin(SAMPLED_SHARE * legToleranceM, piece, static_cast<double>(i) / SAMPLES))
            return false;
    return true;
}

/// Halves a leg of the plane until it can be written.
class LegDivider
{
public:
    LegDivider(const Projection &projection, const Leg &leg, std::vector<GeoPoint> &waypoints)
        : projection_(projection), leg_(leg), waypoints_(waypoints)
    {
    }

    /// Appends what comes after `from`, the written point at t0, up to and including `to`, the one at t1.
    void append(double t0, const GeoPoint &from, double t1, const GeoPoint &to, int depth = 0)
    {
        if (readsAsDrawn({projection_, at(t0), at(t1)}, from, to))
        {
            waypoints_.push_back(to);
            return;
        }
        if (depth == DEEPEST)
            throw PositionError("the leg at " + toString(from) + " can't be written within " +
                                std::to_string(legToleranceM) + " m of the line in the " + projection_.name());
        const double middle = 0.5 * (t0 + t1);
        const GeoPoint between = writtenPosition(projection_.inverse(at(middle)));
        append(t0, from, middle, between, depth + 1);
        append(middle, between, t1, to, depth + 1);
    }

private:
    Point at(double t) const { return leg_.from + t * (leg_.to - leg_.from); }

    const Projection &projection_;
    Leg leg_;
    std::vector<GeoPoint> &waypoints_;
};

void requireEnd(const char *name, const GeoPoint &position, const Projection &projection, const Point &end)
{
    const double distanceM = PlanePiece(projection, end, end).distanceM(position);
    if (!(distanceM <= endToleranceM))
        throw PositionError(std::string(name) + " " + toString(position) + " lies " + std::to_string(distanceM) +
                            " m from the end of the route");
}

/// Leaves out waypoints that are written like the one before; keeps the first and the last.
std::vector<GeoPoint> withoutRepetitions(const std::vector<GeoPoint> &waypoints)
{
    std::vector<GeoPoint> kept{waypoints.front()};
    for (std::size_t i = 1; i + 1 < waypoints.size(); ++i)
        if (writtenPosition(waypoints[i]) != writtenPosition(kept.back()))
            kept.push_back(waypoints[i]);
    while (kept.size() > 1 && writtenPosition(kept.back()) == writtenPosition(waypoints.back()))
        kept.pop_back();
    kept.push_back(waypoints.back());
    return kept;
}

}  // namespace

GeoPoint writtenPosition(const GeoPoint &position)
{
    const double unit = std::pow(10.0, positionDecimals);
    const auto rounded = [unit](double deg)
    {
        return std::round(deg * unit) / unit + 0.0;
    };  // + 0.0: never -0
    const double longitudeDeg = position.longitudeDeg();
    const double reducedDeg = rounded(longitudeDeg - 360.0 * std::floor((longitudeDeg + 180.0) / 360.0));
    return GeoPoint::fromLatLon(rounded(position.latitudeDeg()), reducedDeg >= 180.0 ? -180.0 : reducedDeg);
}

GeoRoute toGeoRoute(const Route &route, const Projection &projection, const GeoPoint &start, const GeoPoint &goal)
{
    if (route.empty())
        return {};
    const std::vector<Point> &points = route.waypoints();
    requireEnd("start", start, projection, points.front());
    requireEnd("goal", goal, projection, points.back());
    if (points.size() == 1)
        return {{start, goal}};

    std::vector<GeoPoint> waypoints{start};
    for (std::size_t i = 0; i < route.legCount(); ++i)
    {
        const bool last = i + 1 == route.legCount();
        const GeoPoint to = last ? goal : writtenPosition(projection.inverse(points[i + 1]));
        LegDivider(projection, route.leg(i), waypoints).append(0.0, GeoPoint(waypoints.back()), 1.0, to);
    }
    return {withoutRepetitions(waypoints)};
}

RhumbLeg rhumbLeg(const GeoPoint &from, const GeoPoint &to)
{
    double lengthM = 0.0;
    double azimuthDeg = 0.0;
    Rhumb::WGS84().Inverse(from.latitudeDeg(), from.longitudeDeg(), to.latitudeDeg(), to.longitudeDeg(), lengthM,
                           azimuthDeg);
    const double courseDeg = azimuthDeg < 0.0 ? azimuthDeg + 360.0 : azimuthDeg;
    return {courseDeg < 360.0 ? courseDeg + 0.0 : 0.0, lengthM};  // 360 is what a tiny negative azimuth rounds to
}

double rhumbLengthM(const GeoRoute &route)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < route.waypoints.size(); ++i)
        sum += rhumbLeg(route.waypoints[i - 1], route.waypoints[i]).lengthM;
    return sum;
}

}  // namespace seahex
