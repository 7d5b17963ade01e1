#pragma once

#include <seahex/chart/Projection.h>
#include <seahex/io/GeoRoute.h>
#include <seahex/world/Occupancy.h>

#include <map>
#include <stdexcept>
#include <string>

namespace seahex
{

/// Thrown when a file can't be written; names the file and the reason.
class WriteError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// What a route file holds. Pointers may be null: that part is then left out.
struct RouteFileContent
{
    const GeoRoute *route = nullptr;    ///< feature "route" and its "waypoint" points; at least two waypoints
    const GeoRoute *rawPath = nullptr;  ///< feature "raw_path", likewise

    /// Blocked cells of the rectangle, "blocked_cell"; a million of them make a file of a third of a gigabyte and
    /// take about half a minute.
    const Occupancy *blocked = nullptr;
    const Projection *projection = nullptr;  ///< needed for the blocked cells
    /// Properties of the route: length_m, turns, ...; one that is not finite becomes null.
    std::map<std::string, double> numbers = {};
    std::map<std::string, std::string> texts = {};  ///< planner, chart, ...; UTF-8
};

/// Writes a GeoJSON FeatureCollection (RFC 7946: longitude first, WGS-84) through GDAL, in this order:
///
/// - "route", a LineString, with the numbers and texts;
/// - "waypoint", a Point each, with `index` (from 1), and with `course_deg` (rhumb line, clockwise from north) and
///   `leg_length_m` to the next one;
/// - "raw_path", a LineString;
/// - "blocked_cell", a Polygon each, with `q`, `r` and `s` if it is a hexagon, `column` and `row` if it is a square.
///
/// The word is the property `kind`.
///
/// A dive's positions have a third coordinate, minus the depth to the millimetre (RFC 7946 calls it a height above the
/// ellipsoid; here it counts from the datum of depths), and its waypoints a `depth_m`.
///
/// Positions have positionDecimals, longitudes lie in [-180, 180]. Lines and cells across the antimeridian are cut
/// there, as the RFC asks, and become a MultiLineString or MultiPolygon. The last waypoint has no course and length;
/// one at the place of the next has no course.
///
/// The file appears complete or not at all: it is written beside its place and renamed.
///
/// @throws WriteError if the file can't be written, a line has fewer than two waypoints or a depth for some of
///         them only, blocked cells come without a
///         projection or reach where it has no positions, or a number or text bears the name of another property
void writeGeoJson(const std::string &path, const RouteFileContent &content);

}  // namespace seahex
