#include "OgrShape.h"

#include "seahex/chart/ChartError.h"

#include <cmath>
#include <memory>

namespace seahex
{
namespace
{

constexpr double MAX_LATITUDE_DEG = 90.0;
constexpr double MAX_LONGITUDE_DEG = 360.0;

/// What is not a number compares false.
bool isPosition(double longitudeDeg, double latitudeDeg)
{
    return std::abs(latitudeDeg) <= MAX_LATITUDE_DEG && std::abs(longitudeDeg) <= MAX_LONGITUDE_DEG;
}

Point checkedPoint(double longitudeDeg, double latitudeDeg, const Who &who)
{
    if (!isPosition(longitudeDeg, latitudeDeg))
        throw ChartDamaged(who() + " has a coordinate that is no position: longitude " + std::to_string(longitudeDeg) +
                           ", latitude " + std::to_string(latitudeDeg) + " degrees");
    return Point(longitudeDeg, latitudeDeg);
}

template <class Path>
Path pathOf(const OGRSimpleCurve &curve, const Who &who)
{
    Path path;
    if (curve.IsEmpty())
        return path;
    const auto count = static_cast<std::size_t>(curve.getNumPoints());
    path.reserve(count + 1);  // for the corner that closes a ring
    path.resize(count);
    constexpr int stride = sizeof(Point);
    curve.getPoints(&path.front().x(), stride, &path.front().y(), stride);
    for (const Point &p : path)
        if (!isPosition(p.x(), p.y()))
            checkedPoint(p.x(), p.y(), who);
    return path;
}

/// A ring, closed; or less than three corners, left for addDegenerate().
Ring ringOf(const OGRLinearRing &curve, const Who &who)
{
    Ring ring = pathOf<Ring>(curve, who);
    if (ring.size() > 1 && ring.front() != ring.back())
        ring.push_back(ring.front());
    return ring;
}

constexpr std::size_t LEAST_RING_SIZE = 4;

void addPath(LineString line, Shape &shape)
{
    if (line.size() == 1)
        shape.points.push_back(line.front());
    else if (line.size() > 1)
        shape.lines.push_back(std::move(line));
}

void addPolygon(const OGRPolygon &polygon, const Who &who, Shape &shape)
{
    const OGRLinearRing *exterior = polygon.getExteriorRing();
    if (exterior == nullptr || exterior->IsEmpty())
        return;
    Ring outer = ringOf(*exterior, who);
    if (outer.size() < LEAST_RING_SIZE)
    {
        addPath(LineString(outer.begin(), outer.end()), shape);
        return;
    }
    Polygon area;
    area.outer() = std::move(outer);
    for (int i = 0; i < polygon.getNumInteriorRings(); ++i)
    {
        // A hole of less than three corners is none.
        Ring hole = ringOf(*polygon.getInteriorRing(i), who);
        if (hole.size() >= LEAST_RING_SIZE)
            area.inners().push_back(std::move(hole));
    }
    shape.areas.push_back(std::move(area));
}

void addGeometry(const OGRGeometry &geometry, const Who &who, Shape &shape);

void addCurved(const OGRGeometry &geometry, const Who &who, Shape &shape)
{
    const std::unique_ptr<OGRGeometry> linear(geometry.getLinearGeometry(ARC_STEP_DEG));
    if (!linear || linear->hasCurveGeometry())
        throw ChartUnsupported(
            who() + " has a curve of a kind that can't be made of straight pieces: " + geometry.getGeometryName());
    addGeometry(*linear, who, shape);
}

void addGeometry(const OGRGeometry &geometry, const Who &who, Shape &shape)
{
    if (geometry.IsEmpty())
        return;
    if (geometry.hasCurveGeometry())
        return addCurved(geometry, who, shape);
    switch (wkbFlatten(geometry.getGeometryType()))
    {
        case wkbPoint:
            shape.points.push_back(checkedPoint(geometry.toPoint()->getX(), geometry.toPoint()->getY(), who));
            break;
        case wkbLineString:
            addPath(pathOf<LineString>(*geometry.toLineString(), who), shape);
            break;
        case wkbPolygon:
        case wkbTriangle:
            addPolygon(*geometry.toPolygon(), who, shape);
            break;
        case wkbMultiPoint:
        case wkbMultiLineString:
        case wkbMultiPolygon:
        case wkbMultiCurve:
        case wkbMultiSurface:
        case wkbGeometryCollection:
            for (const OGRGeometry *part : *geometry.toGeometryCollection())
                addGeometry(*part, who, shape);
            break;
        case wkbPolyhedralSurface:
        case wkbTIN:
            for (const OGRPolygon *part : *geometry.toPolyhedralSurface())
                addPolygon(*part, who, shape);
            break;
        default:
            throw ChartUnsupported(who() + " has a geometry of an unknown kind: " + geometry.getGeometryName());
    }
}

void addPoints(const OGRGeometry &geometry, const Who &who, std::vector<PointWithHeight> &points)
{
    if (geometry.IsEmpty())
        return;
    switch (wkbFlatten(geometry.getGeometryType()))
    {
        case wkbPoint:
        {
            const OGRPoint &point = *geometry.toPoint();
            points.push_back({checkedPoint(point.getX(), point.getY(), who), point.Is3D() != FALSE, point.getZ()});
            break;
        }
        case wkbMultiPoint:
        case wkbGeometryCollection:
            for (const OGRGeometry *part : *geometry.toGeometryCollection())
                addPoints(*part, who, points);
            break;
        default:
            throw ChartDamaged(who() + " is a sounding, but its geometry is no point: " + geometry.getGeometryName());
    }
}

std::unique_ptr<OGRLinearRing> toOgr(const Ring &ring)
{
    auto copy = std::make_unique<OGRLinearRing>();
    copy->setNumPoints(static_cast<int>(ring.size()), FALSE);
    for (std::size_t i = 0; i < ring.size(); ++i)
        copy->setPoint(static_cast<int>(i), ring[i].x(), ring[i].y());
    return copy;
}

std::unique_ptr<OGRPolygon> toOgr(const Polygon &area)
{
    auto copy = std::make_unique<OGRPolygon>();
    copy->addRingDirectly(toOgr(area.outer()).release());
    for (const Ring &hole : area.inners())
        copy->addRingDirectly(toOgr(hole).release());
    return copy;
}

}  // namespace

Shape toShape(const OGRGeometry &geometry, const Who &who)
{
    Shape shape;
    addGeometry(geometry, who, shape);
    return shape;
}

std::vector<PointWithHeight> pointsOf(const OGRGeometry &geometry, const Who &who)
{
    std::vector<PointWithHeight> points;
    addPoints(geometry, who, points);
    return points;
}

std::unique_ptr<OGRMultiPolygon> toOgr(const std::vector<Polygon> &areas)
{
    auto all = std::make_unique<OGRMultiPolygon>();
    for (const Polygon &area : areas)
        all->addGeometryDirectly(toOgr(area).release());
    return all;
}

}  // namespace seahex
