#include "seahex/geometry/SquareLattice.h"

#include "geometry/LatticeChecks.h"

#include <algorithm>

namespace seahex
{

SquareLattice::SquareLattice(const Point &northWest, double pitch, std::int64_t columns, std::int64_t rows)
    : northWest_(northWest), pitch_(pitch), columns_(columns), rows_(rows)
{
    requireLattice(northWest, pitch, columns, rows);
}

SquareLattice SquareLattice::covering(const Box &box, double pitch)
{
    const Point extent = extentToCover(box, pitch);
    const double columns = std::floor(extent.x() / pitch) + 1.0;
    const double rows = std::floor(extent.y() / pitch) + 1.0;
    requireCellCount(pitch, columns, rows);
    return SquareLattice(Point(box.min.x(), box.max.y()), pitch, static_cast<std::int64_t>(columns),
                         static_cast<std::int64_t>(rows));
}

Box SquareLattice::bounds() const
{
    const double width = pitch_ * static_cast<double>(columns_);
    const double height = pitch_ * static_cast<double>(rows_);
    return {Point(northWest_.x(), northWest_.y() - height), Point(northWest_.x() + width, northWest_.y())};
}

OffsetCoord SquareLattice::cellAt(const Point &p) const
{
    return {toCoordinate(std::floor((p.x() - northWest_.x()) / pitch_)),
            toCoordinate(std::floor((northWest_.y() - p.y()) / pitch_))};
}

std::array<Point, 4> SquareLattice::corners(OffsetCoord cell) const
{
    const Point c = centre(cell);
    const double w = 0.5 * pitch_;
    return {Point(c.x() - w, c.y() + w), Point(c.x() - w, c.y() - w), Point(c.x() + w, c.y() - w),
            Point(c.x() + w, c.y() + w)};
}

double SquareLattice::distance(const Point &p, OffsetCoord cell) const
{
    const Point beyond = (p - centre(cell)).cwiseAbs() - Point::Constant(0.5 * pitch_);
    return beyond.cwiseMax(0.0).norm();
}

}  // namespace seahex
