#include "seahex/chart/Projection.h"

#include "EdgeDensifier.h"
#include "GdalDataset.h"

#include "seahex/chart/ChartError.h"

#include <ogr_spatialref.h>

#include <cmath>
#include <cstdio>
#include <mutex>
#include <utility>

namespace seahex
{
namespace
{

constexpr double EDGE_TOLERANCE_M = 0.25;

/// An inverse that does not lead back to within this is none.
constexpr double ROUND_TRIP_M = 1e-3;

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

OGRSpatialReference frameFrom(const std::string &definition)
{
    OGRSpatialReference frame;
    if (frame.importFromProj4(definition.c_str()) != OGRERR_NONE)
        throw PositionError("the frame '" + definition + "' can't be set up");
    frame.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return frame;
}

/// @return false for each point that has no image
std::vector<int> transform(OGRCoordinateTransformation &transformation, std::vector<Point> &points)
{
    std::vector<double> x(points.size());
    std::vector<double> y(points.size());
    std::vector<int> succeeded(points.size(), FALSE);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        x[i] = points[i].x();
        y[i] = points[i].y();
    }
    const DriverMessages quiet;
    transformation.Transform(static_cast<int>(points.size()), x.data(), y.data(), nullptr, succeeded.data());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        points[i] = Point(x[i], y[i]);
        succeeded[i] = succeeded[i] && points[i].allFinite();
    }
    return succeeded;
}

std::string shown(const Point &point, const char *unit)
{
    return "(" + std::to_string(point.x()) + ", " + std::to_string(point.y()) + ") " + unit;
}

}  // namespace

/// A pair of PROJ transformations with the lock that they need; none in the plate carree frame.
class Projection::Transform
{
public:
    Transform() : name_("plate carree (degrees)") {}

    explicit Transform(const GeoPoint &centre)
        : centreLongitudeDeg_(centre.longitudeDeg()), name_("transverse Mercator at " + toString(centre))
    {
        char definition[160];
        std::snprintf(definition, sizeof definition,
                      "+proj=tmerc +lat_0=%.17g +lon_0=%.17g +k=1 +x_0=0 +y_0=0 +ellps=WGS84 +units=m +no_defs",
                      centre.latitudeDeg(), centre.longitudeDeg());
        const OGRSpatialReference degrees = frameFrom("+proj=longlat +ellps=WGS84 +no_defs");
        const OGRSpatialReference metres = frameFrom(definition);
        toMetres_.reset(OGRCreateCoordinateTransformation(&degrees, &metres));
        toDegrees_.reset(OGRCreateCoordinateTransformation(&metres, &degrees));
        if (!toMetres_ || !toDegrees_)
            throw PositionError("no " + name_ + " can be set up");
    }

    bool isMetric() const { return toMetres_ != nullptr; }
    const std::string &name() const { return name_; }
    double centreLongitudeDeg() const { return centreLongitudeDeg_; }

    void forward(std::vector<Point> &points) const
    {
        if (!isMetric() || points.empty())
            return;
        const std::vector<Point> given = points;
        std::vector<int> succeeded;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            succeeded = transform(*toMetres_, points);
        }
        for (std::size_t i = 0; i < points.size(); ++i)
            if (!succeeded[i])
                throw PositionError("longitude, latitude " + shown(given[i], "degrees") + " has no image in a " +
                                    name_);
    }

    /// Longitude and latitude; the longitude is the one nearest to the centre's.
    Point inverse(const Point &point) const
    {
        std::vector<Point> points{point};
        if (isMetric())
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            std::vector<Point> back;
            bool good = transform(*toDegrees_, points).front();
            back = points;
            good = good && transform(*toMetres_, back).front() && (back.front() - point).norm() < ROUND_TRIP_M;
            if (!good)
                throw PositionError("point " + shown(point, "m") + " is no image of a position in a " + name_);
            points.front().x() += 360.0 * std::round((centreLongitudeDeg_ - points.front().x()) / 360.0);
        }
        return points.front();
    }

private:
    mutable std::mutex mutex_;
    Transformation toMetres_;
    Transformation toDegrees_;
    double centreLongitudeDeg_ = 0.0;
    std::string name_;
};

Projection::Projection(std::shared_ptr<const Transform> transform) : transform_(std::move(transform)) {}

Projection Projection::transverseMercator(const GeoPoint &centre)
{
    return Projection(std::make_shared<const Transform>(centre));
}

Projection Projection::plateCarree()
{
    return Projection(std::make_shared<const Transform>());
}

bool Projection::isMetric() const
{
    return transform_->isMetric();
}

double Projection::largestScale(double farthestEastM) const
{
    // On a sphere the scale is cosh(x / R). The smallest radius of curvature of WGS-84, along the meridian at the
    // equator, gives a bound for the ellipsoid.
    constexpr double smallestRadiusM = 6335439.0;
    return isMetric() ? std::cosh(farthestEastM / smallestRadiusM) : 1.0;
}

double Projection::edgeToleranceM() const
{
    return isMetric() ? EDGE_TOLERANCE_M : 0.0;
}

const std::string &Projection::name() const
{
    return transform_->name();
}

Point Projection::forward(const GeoPoint &position) const
{
    std::vector<Point> points{Point(position.longitudeDeg(), position.latitudeDeg())};
    transform_->forward(points);
    return points.front();
}

GeoPoint Projection::inverse(const Point &point) const
{
    const Point lonLat = transform_->inverse(point);
    return GeoPoint::fromLonLat(lonLat.x(), lonLat.y());
}

Shape Projection::forward(const GeoShape &shape) const
{
    if (!isMetric())
        return shape.lonLat;
    std::vector<std::vector<Point>> paths;
    for (const LineString &line : shape.lonLat.lines)
        paths.emplace_back(line.begin(), line.end());
    for (const Polygon &area : shape.lonLat.areas)
    {
        paths.emplace_back(area.outer().begin(), area.outer().end());
        for (const Ring &hole : area.inners())
            paths.emplace_back(hole.begin(), hole.end());
    }

    Shape image;
    image.points = shape.lonLat.points;
    transform_->forward(image.points);
    const EdgeDensifier densifier([this](std::vector<Point> &points) { transform_->forward(points); }, EDGE_TOLERANCE_M,
                                  transform_->centreLongitudeDeg());
    const std::vector<std::vector<Point>> images = densifier.project(paths);

    auto next = images.begin();
    for (std::size_t i = 0; i < shape.lonLat.lines.size(); ++i, ++next)
        image.lines.emplace_back(next->begin(), next->end());
    for (const Polygon &area : shape.lonLat.areas)
    {
        Polygon &copy = image.areas.emplace_back();
        copy.outer().assign(next->begin(), next->end());
        ++next;
        for (std::size_t i = 0; i < area.inners().size(); ++i, ++next)
            copy.inners().emplace_back(next->begin(), next->end());
    }
    return image;
}

LineString Projection::forward(const std::vector<GeoPoint> &line, double toleranceM) const
{
    std::vector<Point> path;
    path.reserve(line.size());
    for (const GeoPoint &position : line)
        path.emplace_back(position.longitudeDeg(), position.latitudeDeg());
    if (!isMetric())
        return LineString(path.begin(), path.end());
    const EdgeDensifier densifier([this](std::vector<Point> &points) { transform_->forward(points); }, toleranceM,
                                  transform_->centreLongitudeDeg());
    const std::vector<Point> image = densifier.project({path}).front();
    return LineString(image.begin(), image.end());
}

std::vector<Hazard> projectHazards(const Chart &chart, const Projection &projection)
{
    std::vector<Hazard> hazards;
    hazards.reserve(chart.hazards.size());
    for (const GeoHazard &hazard : chart.hazards)
        hazards.push_back({hazard.object, projection.forward(hazard.shape)});
    return hazards;
}

}  // namespace seahex
