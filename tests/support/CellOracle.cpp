#include "support/CellOracle.h"

#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/SquareLattice.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seahex::test
{
namespace
{

using Vector = LongVector;

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

std::array<Vector, 6> cornersOf(const HexLattice &lattice)
{
    const long double w = lattice.pitch() / 2.0L;
    const long double h = w / root3;
    return {{{0, 2 * h}, {-w, h}, {-w, -h}, {0, -2 * h}, {w, -h}, {w, h}}};
}

std::array<Vector, 4> cornersOf(const SquareLattice &lattice)
{
    const long double w = lattice.pitch() / 2.0L;
    return {{{-w, w}, {-w, -w}, {w, -w}, {w, w}}};
}

/// In pitches from the lattice's north-west corner, southward.
Vector centreInPitches(HexCoord cell)
{
    const auto q = static_cast<long double>(cell.q);
    const auto s = static_cast<long double>(cell.s);
    return {1 + q + s / 2, (1 + 1.5L * s) / root3};
}

Vector centreInPitches(OffsetCoord cell)
{
    return {static_cast<long double>(cell.column) + 0.5L, static_cast<long double>(cell.row) + 0.5L};
}

}  // namespace

template <class LatticeType>
CellOracle<LatticeType>::CellOracle(const LatticeType &lattice)
    : pitch_(lattice.pitch()), northWest_{lattice.northWest().x(), lattice.northWest().y()},
      corners_(cornersOf(lattice))
{
}

template <class LatticeType>
LongVector CellOracle<LatticeType>::centre(Cell cell) const
{
    const Vector p = centreInPitches(cell);
    return {northWest_.x + pitch_ * p.x, northWest_.y - pitch_ * p.y};
}

template <class LatticeType>
long double CellOracle<LatticeType>::distance(const Point &from, const Point &to, Cell cell) const
{
    // everything relative to the centre, where the cell is convex and contains the origin
    const Vector c = centre(cell);
    const Vector a = Vector{from.x(), from.y()} - c;
    const Vector b = Vector{to.x(), to.y()} - c;
    long double distance = std::numeric_limits<long double>::infinity();
    bool inside = true;
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
        const Vector u = corners_[i];
        const Vector v = corners_[(i + 1) % corners_.size()];
        inside = inside && cross(v - u, a - u) >= 0;
        if (meet(a, b, u, v))
            return 0;
        distance =
            std::min({distance, distanceToSegment(a, u, v), distanceToSegment(b, u, v), distanceToSegment(u, a, b)});
    }
    return inside ? 0 : distance;
}

template <class LatticeType>
bool CellOracle<LatticeType>::isCentreInside(const Polygon &polygon, Cell cell) const
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

template <class LatticeType>
long double CellOracle<LatticeType>::distanceToRings(const Polygon &polygon, Cell cell) const
{
    Shape rings;
    rings.areas = {polygon};
    long double least = std::numeric_limits<long double>::infinity();
    forEachSegment(rings, [&](const Point &a, const Point &b) { least = std::min(least, distance(a, b, cell)); });
    return least;
}

template <class LatticeType>
long double CellOracle<LatticeType>::distance(const Shape &shape, Cell cell) const
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

template class CellOracle<HexLattice>;
template class CellOracle<SquareLattice>;

}  // namespace seahex::test
