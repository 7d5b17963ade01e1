#pragma once

#include <seahex/chart/Chart.h>
#include <seahex/geometry/Box.h>
#include <seahex/geometry/GeoPoint.h>
#include <seahex/geometry/Point.h>
#include <seahex/geometry/Shape.h>

#include <memory>
#include <string>
#include <vector>

namespace seahex
{

/// The frame in which a chart is planned on: degrees <-> plane, x east, y north.
///
/// Chart edges are straight in longitude and latitude but bent in a metric frame (in a transverse Mercator a 190 km leg
/// east to west bends by 590 m), so shapes are densified until every straight piece in the plane lies within
/// `edgeToleranceM` of the true edge.
///
/// A value type, immutable; all functions are const and thread-safe (concurrent calls wait for each other, since PROJ's
/// transformations are not).
class Projection
{
public:
    /// A transverse Mercator on WGS-84 with scale 1 at `centre`, which maps to (0, 0). Unit: metre.
    static Projection transverseMercator(const GeoPoint &centre);

    /// Metres by a fixed scale each way: those of a degree of longitude and of latitude at `middle` (metresPerDegree),
    /// which maps to (0, 0). For grids in degrees: straight lines and the bilinear surface between the grid's nodes
    /// stay what they are. Unit: metre, true at the middle's latitude only. An eastward metre of the plane is off by
    /// tan(latitude) / 6371 of its length for each kilometre to the north or south: at latitude 40 by 0.13 % after
    /// 10 km, 1.3 % after 100 km; a northward one by less than 1 %, whatever the distance.
    /// @throws PositionError if the middle is nearer than 5 degrees to a pole
    static Projection localEquirectangular(const GeoPoint &middle);

    /// Longitude and latitude as they are. Unit: degree.
    static Projection plateCarree();

    bool isMetric() const;

    /// Largest distance in metres between a projected edge and its densified image; 0 in the frames that keep straight
    /// edges straight: all but the transverse Mercator.
    double edgeToleranceM() const;

    /// Most metres of the plane to a metre on the ground, in any direction at any point of a box of the plane: the
    /// plane is stretched away from its middle. Multiply by it what must not be less on the ground, divide by it what
    /// is measured in the plane. 1 in the plate carree frame.
    double largestScale(const Box &box) const;

    /// @throws PositionError if the position can't be projected.
    Point forward(const GeoPoint &position) const;

    /// The longitude is the one nearest to the centre's, so that it may lie beyond 180 degrees.
    /// @throws PositionError if the point is no image of a position.
    GeoPoint inverse(const Point &point) const;

    /// The plane's image of a shape, its edges densified. Closed rings stay closed, and an edge shared by two areas has
    /// the same corners in both, bit for bit.
    /// @throws PositionError if a corner can't be projected.
    Shape forward(const GeoShape &shape) const;

    /// The image of a straight longitude-latitude line through the positions, densified to `toleranceM` metres (at
    /// least a millimetre); in frames that keep straight edges straight the positions' images alone.
    /// @throws PositionError if a position can't be projected.
    LineString forward(const std::vector<GeoPoint> &line, double toleranceM) const;

    /// For people: "transverse Mercator at 42.270000 N 70.905000 W".
    const std::string &name() const;

    /// All parameters to the last digit: projections of the same definition give the same images.
    const std::string &definition() const;

private:
    class Transform;
    explicit Projection(std::shared_ptr<const Transform> transform);
    std::shared_ptr<const Transform> transform_;
};

/// Metres of a degree of longitude (x) and of latitude (y) at a latitude, on WGS-84: pi / 180 times the radii of
/// curvature, N cos(latitude) and M.
Point metresPerDegree(double latitudeDeg);

/// The chart's hazards in the plane.
std::vector<Hazard> projectHazards(const Chart &chart, const Projection &projection);

}  // namespace seahex
