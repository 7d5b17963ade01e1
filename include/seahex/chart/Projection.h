#pragma once

#include <seahex/chart/Chart.h>
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

    /// Longitude and latitude as they are. Unit: degree.
    static Projection plateCarree();

    bool isMetric() const;

    /// Largest distance in metres between a projected edge and its densified image; 0 in the plate carree frame, which
    /// keeps straight edges straight.
    double edgeToleranceM() const;

    /// Most metres of the plane to a metre on the ground, at points up to `farthestEastM` east or west of the centre:
    /// the plane is stretched away from its meridian. Multiply by it what must not be less on the ground, divide by it
    /// what is measured in the plane. 1 in the plate carree frame.
    double largestScale(double farthestEastM) const;

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
    /// least a millimetre); in the plate carree frame the positions as they are.
    /// @throws PositionError if a position can't be projected.
    LineString forward(const std::vector<GeoPoint> &line, double toleranceM) const;

    /// For people: "transverse Mercator at 42.270000 N 70.905000 W".
    const std::string &name() const;

private:
    class Transform;
    explicit Projection(std::shared_ptr<const Transform> transform);
    std::shared_ptr<const Transform> transform_;
};

/// The chart's hazards in the plane.
std::vector<Hazard> projectHazards(const Chart &chart, const Projection &projection);

}  // namespace seahex
