#pragma once

#include <seahex/chart/Projection.h>
#include <seahex/geometry/GeoPoint.h>
#include <seahex/route/Route.h>

#include <vector>

namespace seahex
{

/// A route as it is written: waypoints in degrees, rounded to the decimals of the file.
///
/// Between two waypoints the longitude runs the short way round, so that a leg may cross the antimeridian.
struct GeoRoute
{
    std::vector<GeoPoint> waypoints;
    std::vector<double> depthsM = {};  ///< of a dive: of each waypoint, linear between them; empty at the surface
};

/// How far the readings of a written leg may lie from the line that was checked, metres.
constexpr double legToleranceM = 0.75;

/// How far start and goal may lie from the route's ends, metres.
constexpr double endToleranceM = 0.1;

/// Decimals of a degree in written positions: about a centimetre.
constexpr int positionDecimals = 7;

/// The position as a file holds it: rounded to positionDecimals, its longitude in [-180, 180).
GeoPoint writtenPosition(const GeoPoint &position);

/// Turns a route of the plane into waypoints.
///
/// A leg that is straight in the plane is not straight in longitude and latitude, nor a rhumb line, nor a geodesic.
/// Legs are halved until all three readings of each written piece, between its rounded ends, lie within legToleranceM
/// of the plane's line. Each reading is measured at its ends and at 15 points between them, against 95 % of the
/// tolerance: the rest covers what lies between the points. Metres are those of the plane in a metric frame (never
/// shorter than on the ground) and local ones on WGS-84 in the plate carree frame, whose line is the straight
/// longitude-latitude one.
///
/// The first and the last waypoint are `start` and `goal` as given, all others are writtenPosition()s. Waypoints that
/// are written like the one before are left out; what remains are at least two, even if start and goal are the same. Of
/// a route without points nothing was checked, and nothing is returned.
///
/// @throws PositionError if a waypoint is no image of a position, if start or goal lies farther than endToleranceM from
///         the end of the route, or if halving a leg does not help
GeoRoute toGeoRoute(const Route &route, const Projection &projection, const GeoPoint &start, const GeoPoint &goal);

/// Course and length of the rhumb line between two positions on WGS-84.
struct RhumbLeg
{
    double courseDeg = 0.0;  ///< clockwise from north, [0, 360); 0 where the positions are the same
    double lengthM = 0.0;
};

RhumbLeg rhumbLeg(const GeoPoint &from, const GeoPoint &to);

/// Sum of the rhumb-line lengths of the legs on WGS-84, metres.
double rhumbLengthM(const GeoRoute &route);

}  // namespace seahex
