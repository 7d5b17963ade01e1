#include "support/HexOracle.h"

#include <algorithm>
#include <cmath>

namespace seahex::test
{
namespace
{

using Vector = HexOracle::Vector;

const long double root3 = std::sqrt(3.0L);

Vector operator-(Vector a, Vector b)
{
    return {a.x - b.x, a.y - b.y};
}

long double dot(Vector a, Vector b)
{
    return a.x * b.x + a.y * b.y;
}

long double cross(Vector a, Vector b)
{
    return a.x * b.y - a.y * b.x;
}

long double distanceToSegment(Vector p, Vector a, Vector b)
{
    const Vector d = b - a;
    const long double square = dot(d, d);
    const long double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0L, 1.0L) : 0.0L;
    return std::hypot(p.x - a.x - t * d.x, p.y - a.y - t * d.y);
}

/// True if the segments a b and c d meet, save where both lie on one line: then their ends tell.
bool meet(Vector a, Vector b, Vector c, Vector d)
{
    const auto apart = [](Vector p, Vector q, Vector u, Vector v)
    {
        const long double atU = cross(q - p, u - p);
        const long double atV = cross(q - p, v - p);
        return (atU > 0 && atV > 0) || (atU < 0 && atV < 0) || (atU == 0 && atV == 0);
    };
    return !apart(a, b, c, d) && !apart(c, d, a, b);
}

}  // namespace

HexOracle::HexOracle(const HexLattice &lattice)
    : pitch_(lattice.pitch()), northWest_{lattice.northWest().x(), lattice.northWest().y()}
{
    const long double side = pitch_ / root3;
    for (std::size_t i = 0; i < 6; ++i)
    {
        const long double x[6] = {0, -1, -1, 0, 1, 1};
        const long double y[6] = {2, 1, -1, -2, -1, 1};
        corners_[i] = {x[i] * pitch_ / 2, y[i] * side / 2};
    }
}

HexOracle::Vector HexOracle::centre(HexCoord cell) const
{
    const auto q = static_cast<long double>(cell.q);
    const auto s = static_cast<long double>(cell.s);
    return {northWest_.x + pitch_ * (1 + q + s / 2), northWest_.y - pitch_ / root3 * (1 + 1.5L * s)};
}

long double HexOracle::distance(const Point &from, const Point &to, HexCoord cell) const
{
    // everything relative to the centre, where the cell is convex and contains the origin
    const Vector c = centre(cell);
    const Vector a = Vector{from.x(), from.y()} - c;
    const Vector b = Vector{to.x(), to.y()} - c;
    long double distance = std::numeric_limits<long double>::infinity();
    bool inside = true;
    for (std::size_t i = 0; i < 6; ++i)
    {
        const Vector u = corners_[i];
        const Vector v = corners_[(i + 1) % 6];
        inside = inside && cross(v - u, a - u) >= 0;
        if (meet(a, b, u, v))
            return 0;
        distance =
            std::min({distance, distanceToSegment(a, u, v), distanceToSegment(b, u, v), distanceToSegment(u, a, b)});
    }
    return inside ? 0 : distance;
}

bool HexOracle::isCentreInside(const Polygon &polygon, HexCoord cell) const
{
    const Vector c = centre(cell);
    bool inside = false;
    const auto walk = [&](const Ring &ring)
    {
        for (std::size_t i = 1; i < ring.size(); ++i)
        {
            const Vector a = Vector{ring[i - 1].x(), ring[i - 1].y()} - c;
            const Vector b = Vector{ring[i].x(), ring[i].y()} - c;
            if ((a.y > 0) != (b.y > 0) && (cross(a, b) > 0) == (b.y > a.y))
                inside = !inside;
        }
    };
    walk(polygon.outer());
    for (const Ring &hole : polygon.inners())
        walk(hole);
    return inside;
}

long double HexOracle::distanceToRings(const Polygon &polygon, HexCoord cell) const
{
    Shape rings;
    rings.areas = {polygon};
    long double least = std::numeric_limits<long double>::infinity();
    forEachSegment(rings, [&](const Point &a, const Point &b) { least = std::min(least, distance(a, b, cell)); });
    return least;
}

long double HexOracle::distance(const Shape &shape, HexCoord cell) const
{
    long double least = std::numeric_limits<long double>::infinity();
    for (const Point &p : shape.points)
        least = std::min(least, distance(p, cell));
    forEachSegment(shape, [&](const Point &a, const Point &b) { least = std::min(least, distance(a, b, cell)); });
    for (const Polygon &area : shape.areas)
        if (isCentreInside(area, cell))
            return 0;
    return least;
}

}  // namespace seahex::test
