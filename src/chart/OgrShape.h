#pragma once

#include <seahex/geometry/Shape.h>

#include <ogr_geometry.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace seahex
{

/// Chords of an arc lie inside it by (1 - cos(step / 2)): a centimetre on a radius of a kilometre.
constexpr double ARC_STEP_DEG = 0.5;

/// A point of a sounding: where, and its third coordinate if it has one.
struct PointWithHeight
{
    Point position;
    bool hasHeight = false;
    double height = 0.0;
};

/// Names the object in a message. Asked only if there is a message, because a name takes longer to make than most
/// objects to read.
using Who = std::function<std::string()>;

/// The geometry as a Shape in the coordinates it has. Curves are linearised, collections flattened, heights dropped.
///
/// Degenerate parts lose nothing: a line of one point becomes a point, a ring of less than three corners a line. Rings
/// are closed if they are not.
/// @throws ChartDamaged if a coordinate is no longitude or latitude; ChartUnsupported for a geometry of unknown kind
Shape toShape(const OGRGeometry &geometry, const Who &who);

/// All points of a point or of any collection of points.
/// @throws ChartDamaged as above, and if the geometry holds anything but points
std::vector<PointWithHeight> pointsOf(const OGRGeometry &geometry, const Who &who);

/// The areas as OGR has them.
std::unique_ptr<OGRMultiPolygon> toOgr(const std::vector<Polygon> &areas);

}  // namespace seahex
