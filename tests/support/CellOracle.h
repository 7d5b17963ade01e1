#pragma once

#include <seahex/geometry/Shape.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

namespace seahex::test
{

/// A vector of the plane in long double.
struct LongVector
{
    long double x;
    long double y;
};

/// What tests hold the geometry against: plain code, cell by cell, in long double, that shares nothing with the library
/// but the definition of the lattice (origin, pitch and the axes of its cells). See HexOracle and SquareOracle.
template <class LatticeType>
class CellOracle
{
public:
    using Cell = typename LatticeType::Cell;
    using Vector = LongVector;

    explicit CellOracle(const LatticeType &lattice);

    Vector centre(Cell cell) const;

    /// Distance between a closed segment and a closed cell.
    long double distance(const Point &a, const Point &b, Cell cell) const;
    long double distance(const Point &p, Cell cell) const { return distance(p, p, cell); }

    /// Distance between points, lines and filled areas and a closed cell. Inside is what an odd number of ring edges
    /// separates from infinity: for rings that do not cross, the polygon less its holes.
    long double distance(const Shape &shape, Cell cell) const;

    /// True if the cell's centre lies inside the polygon, by the same rule.
    bool isCentreInside(const Polygon &polygon, Cell cell) const;

    /// Distance between the rings of a polygon and a closed cell.
    long double distanceToRings(const Polygon &polygon, Cell cell) const;

private:
    static constexpr std::size_t cornerCount = std::tuple_size_v<decltype(std::declval<LatticeType>().corners({}))>;

    long double pitch_;
    Vector northWest_;
    std::array<Vector, cornerCount> corners_;  // relative to the centre, counter-clockwise
};

/// Calls visit(cell) for each cell of the lattice's rectangle and of `margin` rows and columns around it.
template <class LatticeType, class Visit>
void forEachCell(const LatticeType &lattice, std::int64_t margin, Visit &&visit)
{
    for (std::int64_t row = -margin; row < lattice.rows() + margin; ++row)
        for (std::int64_t column = -margin; column < lattice.columns() + margin; ++column)
            visit(LatticeType::cell({column, row}));
}

}  // namespace seahex::test
