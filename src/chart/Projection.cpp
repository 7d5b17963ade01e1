#include "seahex/chart/Projection.h"

#include "EdgeDensifier.h"
#include "GdalDataset.h"

#include "seahex/chart/ChartError.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <optional>
#include <utility>

namespace seahex
{
namespace
{

constexpr double EDGE_TOLERANCE_M = 0.25;

/// Beyond, metres at the middle latitude say nothing of the next parallel.
constexpr double FARTHEST_MIDDLE_DEG = 85.0;

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

/// A latitude or longitude with all its digits.
std::string exactly(double degrees)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", degrees);
    return text;
}

/// The parameters that say where a frame lies, as PROJ writes them.
std::string originAt(const GeoPoint &position)
{
    return "+lat_0=" + exactly(position.latitudeDeg()) + " +lon_0=" + exactly(position.longitudeDeg());
}

std::string shown(const Point &point, const char *unit)
{
    return "(" + std::to_string(point.x()) + ", " + std::to_string(point.y()) + ") " + unit;
}

}  // namespace

/// A pair of PROJ transformations with the lock that they need, or a scale each way; neither in the plate carree frame.
class Projection::Transform
{
public:
    static std::shared_ptr<const Transform> plateCarree() { return std::make_shared<Transform>(); }

    static std::shared_ptr<const Transform> scaled(const GeoPoint &middle)
    {
        auto transform = std::make_shared<Transform>();
        transform->centre_ = Point(middle.longitudeDeg(), middle.latitudeDeg());
        transform->metresPerDegree_ = seahex::metresPerDegree(middle.latitudeDeg());
        transform->name_ = "local equirectangular frame at " + toString(middle);
        transform->definition_ = "local equirectangular " + originAt(middle);
        return transform;
    }

    static std::shared_ptr<const Transform> transverseMercator(const GeoPoint &centre)
    {
        auto transform = std::make_shared<Transform>();
        transform->setUp(centre);
        return transform;
    }

    bool isMetric() const { return isBent() || metresPerDegree_; }
    /// Are straight edges bent?
    bool isBent() const { return toMetres_ != nullptr; }
    const std::optional<Point> &metresPerDegree() const { return metresPerDegree_; }
    const std::string &name() const { return name_; }
    const std::string &definition() const { return definition_; }
    const Point &centre() const { return centre_; }

    void forward(std::vector<Point> &points) const
    {
        if (metresPerDegree_)
            for (Point &p : points)
            {
                p.x() -= 360.0 * std::round((p.x() - centre_.x()) / 360.0);
                p = (p - centre_).cwiseProduct(*metresPerDegree_);
            }
        if (!isBent() || points.empty())
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
        if (metresPerDegree_)
        {
            Point lonLat = centre_ + point.cwiseQuotient(*metresPerDegree_);
            lonLat.x() += 360.0 * std::round((centre_.x() - lonLat.x()) / 360.0);
            return lonLat;
        }
        std::vector<Point> points{point};
        if (isBent())
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            std::vector<Point> back;
            bool good = transform(*toDegrees_, points).front();
            back = points;
            good = good && transform(*toMetres_, back).front() && (back.front() - point).norm() < ROUND_TRIP_M;
            if (!good)
                throw PositionError("point " + shown(point, "m") + " is no image of a position in a " + name_);
            points.front().x() += 360.0 * std::round((centre_.x() - points.front().x()) / 360.0);
        }
        return points.front();
    }

private:
    void setUp(const GeoPoint &centre)
    {
        centre_ = Point(centre.longitudeDeg(), centre.latitudeDeg());
        name_ = "transverse Mercator at " + toString(centre);
        definition_ = "+proj=tmerc " + originAt(centre) + " +k=1 +x_0=0 +y_0=0 +ellps=WGS84 +units=m +no_defs";
        const OGRSpatialReference degrees = frameFrom("+proj=longlat +ellps=WGS84 +no_defs");
        const OGRSpatialReference metres = frameFrom(definition_);
        toMetres_.reset(OGRCreateCoordinateTransformation(&degrees, &metres));
        toDegrees_.reset(OGRCreateCoordinateTransformation(&metres, &degrees));
        if (!toMetres_ || !toDegrees_)
            throw PositionError("no " + name_ + " can be set up");
    }

    mutable std::mutex mutex_;
    Transformation toMetres_;
    Transformation toDegrees_;
    std::optional<Point> metresPerDegree_;
    Point centre_ = Point::Zero();  // longitude, latitude
    std::string name_ = "plate carree (degrees)";
    std::string definition_ = name_;
};

Projection::Projection(std::shared_ptr<const Transform> transform) : transform_(std::move(transform)) {}

Projection Projection::transverseMercator(const GeoPoint &centre)
{
    return Projection(Transform::transverseMercator(centre));
}

Projection Projection::localEquirectangular(const GeoPoint &middle)
{
    if (std::abs(middle.latitudeDeg()) > FARTHEST_MIDDLE_DEG)
        throw PositionError("a local equirectangular frame at " + toString(middle) + " is too near to a pole");
    return Projection(Transform::scaled(middle));
}

Projection Projection::plateCarree()
{
    return Projection(Transform::plateCarree());
}

bool Projection::isMetric() const
{
    return transform_->isMetric();
}

double Projection::largestScale(const Box &box) const
{
    if (transform_->isBent())
    {
        // On a sphere the scale is cosh(x / R). The smallest radius of curvature of WGS-84, along the meridian at the
        // equator, gives a bound for the ellipsoid.
        constexpr double smallestRadiusM = 6335439.0;
        return std::cosh(std::max(std::abs(box.min.x()), std::abs(box.max.x())) / smallestRadiusM);
    }
    const std::optional<Point> &here = transform_->metresPerDegree();
    if (!here)
        return 1.0;
    // A degree of longitude is shortest farthest from the equator, one of latitude nearest to it.
    const double south = transform_->centre().y() + box.min.y() / here->y();
    const double north = transform_->centre().y() + box.max.y() / here->y();
    const double farthest = std::min(std::max(std::abs(south), std::abs(north)), 90.0);
    const double nearest = south * north <= 0.0 ? 0.0 : std::min(std::abs(south), std::abs(north));
    return std::max(here->x() / metresPerDegree(farthest).x(), here->y() / metresPerDegree(nearest).y());
}

double Projection::edgeToleranceM() const
{
    return transform_->isBent() ? EDGE_TOLERANCE_M : 0.0;
}

const std::string &Projection::name() const
{
    return transform_->name();
}

const std::string &Projection::definition() const
{
    return transform_->definition();
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
    const auto project = [this](std::vector<Point> &points)
    {
        transform_->forward(points);
    };
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
    if (transform_->isBent())
        paths = EdgeDensifier(project, EDGE_TOLERANCE_M, transform_->centre().x()).project(paths);
    else
        std::for_each(paths.begin(), paths.end(), project);

    auto next = paths.begin();
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
    if (!transform_->isBent())
    {
        transform_->forward(path);
        return LineString(path.begin(), path.end());
    }
    const EdgeDensifier densifier([this](std::vector<Point> &points) { transform_->forward(points); }, toleranceM,
                                  transform_->centre().x());
    const std::vector<Point> image = densifier.project({path}).front();
    return LineString(image.begin(), image.end());
}

Point metresPerDegree(double latitudeDeg)
{
    constexpr double equatorM = 6378137.0;  // WGS-84
    constexpr double flattening = 1.0 / 298.257223563;
    constexpr double eccentricitySquared = flattening * (2.0 - flattening);
    constexpr double degree = 3.14159265358979323846 / 180.0;
    const double sine = std::sin(latitudeDeg * degree);
    const double root = std::sqrt(1.0 - eccentricitySquared * sine * sine);
    const double across = equatorM / root;
    const double along = equatorM * (1.0 - eccentricitySquared) / (root * root * root);
    return degree * Point(across * std::cos(latitudeDeg * degree), along);
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
