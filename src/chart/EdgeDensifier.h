#pragma once

#include <seahex/geometry/Point.h>

#include <functional>
#include <vector>

namespace seahex
{

/// Turns points of longitude and latitude into points of the plane, in place.
using ProjectPoints = std::function<void(std::vector<Point> &)>;

/// Projects paths that are straight in longitude and latitude, with as many corners added as keep every straight piece
/// in the plane within a tolerance of the true edge.
///
/// An edge is bisected in longitude and latitude until the images of its quarter points lie near the chord and it is
/// short enough that nothing between them can hide. It is bisected from its lexicographically smaller end, so that an
/// edge shared by two areas gets the same corners in both, bit for bit.
class EdgeDensifier
{
public:
    /// @param toleranceM  metres; anything below a millimetre is taken as a millimetre
    /// @param centreLongitudeDeg  central meridian of the projection
    EdgeDensifier(ProjectPoints project, double toleranceM, double centreLongitudeDeg);

    /// The images of the paths; each keeps its first and last point.
    std::vector<std::vector<Point>> project(const std::vector<std::vector<Point>> &paths) const;

private:
    struct Edge;
    struct Piece;

    bool needsLook(const Point &geoA, const Point &geoB, const Point &a, const Point &b) const;
    void bend(std::vector<Edge> &edges) const;
    bool isStraightEnough(const Piece &piece, const Point *samples) const;

    ProjectPoints project_;
    double toleranceM_;
    double centreLongitudeDeg_;
};

}  // namespace seahex
