#pragma once

#include <seahex/geometry/Point.h>

#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/core/tag.hpp>
#include <boost/geometry/core/tags.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/mpl/int.hpp>

#include <cstddef>
#include <vector>

namespace boost::geometry::traits
{

template <>
struct tag<seahex::Point>
{
    using type = point_tag;
};

template <>
struct coordinate_type<seahex::Point>
{
    using type = double;
};

template <>
struct coordinate_system<seahex::Point>
{
    using type = cs::cartesian;
};

template <>
struct dimension<seahex::Point> : boost::mpl::int_<2>
{
};

template <std::size_t Dimension>
struct access<seahex::Point, Dimension>
{
    static double get(const seahex::Point &p) { return p[Dimension]; }
    static void set(seahex::Point &p, double value) { p[Dimension] = value; }
};

}  // namespace boost::geometry::traits

namespace seahex
{

using LineString = boost::geometry::model::linestring<Point>;

/// Rings are closed (the last point repeats the first); no orientation is promised.
using Polygon = boost::geometry::model::polygon<Point, false, true>;
using Ring = Polygon::ring_type;

/// The geometry of one chart object: any mix of points, lines and areas, all of one frame.
struct Shape
{
    std::vector<Point> points;
    std::vector<LineString> lines;
    std::vector<Polygon> areas;

    bool empty() const { return points.empty() && lines.empty() && areas.empty(); }
};

/// A Shape whose coordinates are x = longitude, y = latitude in degrees, WGS-84. A type of its own, so that degrees and
/// metres can't be mixed unseen.
struct GeoShape
{
    Shape lonLat;
};

/// Area of a closed ring, positive if it runs counter-clockwise.
inline double signedArea(const Ring &ring)
{
    double twice = 0.0;
    for (std::size_t i = 1; i < ring.size(); ++i)
    {
        const Point a = ring[i - 1] - ring.front();
        const Point b = ring[i] - ring.front();
        twice += a.x() * b.y() - b.x() * a.y();
    }
    return 0.5 * twice;
}

/// Calls visit(a, b) for every straight segment of the shape: lines, and the rings of areas. Points are not visited.
template <class Visit>
void forEachSegment(const Shape &shape, Visit &&visit)
{
    const auto walk = [&visit](const auto &line)
    {
        for (std::size_t i = 1; i < line.size(); ++i)
            visit(line[i - 1], line[i]);
    };
    for (const LineString &line : shape.lines)
        walk(line);
    for (const Polygon &area : shape.areas)
    {
        walk(area.outer());
        for (const Ring &hole : area.inners())
            walk(hole);
    }
}

}  // namespace seahex
