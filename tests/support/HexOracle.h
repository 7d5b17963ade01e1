#pragma once

#include <seahex/geometry/HexCoord.h>
#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/Shape.h>

#include <array>
#include <limits>

namespace seahex::test
{

/// What tests hold the geometry against: plain code, cell by cell, in long double or in integers, that shares nothing
/// with the library but the definition of the lattice (HexLattice's origin and pitch, HexCoord's axes).
class HexOracle
{
public:
    struct Vector
    {
        long double x;
        long double y;
    };

    explicit HexOracle(const HexLattice &lattice);

    Vector centre(HexCoord cell) const;

    /// Distance between a closed segment and a closed cell.
    long double distance(const Point &a, const Point &b, HexCoord cell) const;
    long double distance(const Point &p, HexCoord cell) const { return distance(p, p, cell); }

    /// Distance between points, lines and filled areas and a closed cell. Inside is what an odd number of ring edges
    /// separates from infinity: for rings that do not cross, the polygon less its holes.
    long double distance(const Shape &shape, HexCoord cell) const;

    /// True if the cell's centre lies inside the polygon, by the same rule.
    bool isCentreInside(const Polygon &polygon, HexCoord cell) const;

    /// Distance between the rings of a polygon and a closed cell.
    long double distanceToRings(const Polygon &polygon, HexCoord cell) const;

private:
    long double pitch_;
    Vector northWest_;
    std::array<Vector, 6> corners_;  // relative to the centre
};

/// True if the segment between two centres touches the closed cell: exact, in integers of type Int, which must hold 20
/// times the square of the largest coordinate.
///
/// In cube coordinates times 3 corners are integers: a corner lies midway between three centres. A cell is where the
/// three differences q - r, r - s, s - q are at most 3 in size. Segment and cell are apart exactly if one of these
/// differences tells them apart, or all corners lie strictly on one side of the segment.
template <class Int>
bool touchesExactly(HexCoord a, HexCoord b, HexCoord cell)
{
    const Int aq = 3 * (Int(a.q) - Int(cell.q));
    const Int as = 3 * (Int(a.s) - Int(cell.s));
    const Int bq = 3 * (Int(b.q) - Int(cell.q));
    const Int bs = 3 * (Int(b.s) - Int(cell.s));
    const auto apart = [](const Int &atA, const Int &atB)
    {
        return (atA > 3 && atB > 3) || (atA < -3 && atB < -3);
    };
    if (apart(2 * aq + as, 2 * bq + bs) || apart(-aq - 2 * as, -bq - 2 * bs) || apart(as - aq, bs - bq))
        return false;
    static constexpr int corners[6][2] = {{2, -1}, {1, -2}, {-1, -1}, {-2, 1}, {-1, 2}, {1, 1}};
    bool left = false;
    bool right = false;
    for (const auto &corner : corners)
    {
        const Int side = (bq - aq) * (corner[1] - as) - (bs - as) * (corner[0] - aq);
        left = left || side >= 0;
        right = right || side <= 0;
    }
    return left && right;
}

/// Calls visit(cell) for each cell of the lattice's rectangle and of `margin` rows and columns around it.
template <class Visit>
void forEachCell(const HexLattice &lattice, std::int64_t margin, Visit &&visit)
{
    for (std::int64_t row = -margin; row < lattice.rows() + margin; ++row)
        for (std::int64_t column = -margin; column < lattice.columns() + margin; ++column)
            visit(toCube({column, row}));
}

}  // namespace seahex::test
