#include "seahex/geometry/HexLattice.h"

#include "geometry/LatticeChecks.h"
#include "seahex/geometry/SegmentDistance.h"

#include <algorithm>
#include <cmath>

namespace seahex
{
namespace
{

const double root3 = std::sqrt(3.0);

}  // namespace

HexLattice::HexLattice(const Point &northWest, double pitch, std::int64_t columns, std::int64_t rows)
    : northWest_(northWest), pitch_(pitch), side_(pitch / root3), columns_(columns), rows_(rows)
{
    requireLattice(northWest, pitch, columns, rows);
}

HexLattice HexLattice::covering(const Box &box, double pitch)
{
    const Point extent = extentToCover(box, pitch);
    const double side = pitch / root3;
    // Odd rows end half a cell before even ones, and rows meet in a zigzag half a side deep.
    const double columns = std::floor(extent.x() / pitch + 0.5) + 1.0;
    const double rows = std::floor((extent.y() + 0.5 * side) / (1.5 * side)) + 1.0;
    requireCellCount(pitch, columns, rows);
    return HexLattice(Point(box.min.x() - 0.5 * pitch, box.max.y() + 0.5 * side), pitch,
                      static_cast<std::int64_t>(columns), static_cast<std::int64_t>(rows));
}

Box HexLattice::bounds() const
{
    const double width = pitch_ * (static_cast<double>(columns_) + (rows_ > 1 ? 0.5 : 0.0));
    const double west = northWest_.x() + (rows_ > 1 ? 0.0 : 0.5 * pitch_);
    const double height = side_ * (1.5 * static_cast<double>(rows_) + 0.5);
    return {Point(west, northWest_.y() - height), Point(west + width, northWest_.y())};
}

HexCoord HexLattice::cellAt(const Point &p) const
{
    // Fractional cube coordinates, rounded each by itself; then the one that was rounded farthest is replaced, so that
    // the three sum to 0 again. That is the nearest centre, hence the cell.
    const double s = ((northWest_.y() - p.y()) / side_ - 1.0) / 1.5;
    const double q = (p.x() - northWest_.x()) / pitch_ - 1.0 - 0.5 * s;
    const double r = -q - s;
    double qRounded = std::round(q);
    double sRounded = std::round(s);
    const double rRounded = std::round(r);
    const double qError = std::abs(qRounded - q);
    const double sError = std::abs(sRounded - s);
    const double rError = std::abs(rRounded - r);
    if (qError > sError && qError > rError)
        qRounded = -rRounded - sRounded;
    else if (sError > rError)
        sRounded = -qRounded - rRounded;
    return {toCoordinate(qRounded), toCoordinate(sRounded)};
}

std::array<Point, 6> HexLattice::corners(HexCoord cell) const
{
    const Point c = centre(cell);
    const double w = 0.5 * pitch_;
    const double h = 0.5 * side_;
    return {Point(c.x(), c.y() + side_), Point(c.x() - w, c.y() + h), Point(c.x() - w, c.y() - h),
            Point(c.x(), c.y() - side_), Point(c.x() + w, c.y() - h), Point(c.x() + w, c.y() + h)};
}

double HexLattice::distance(const Point &p, HexCoord cell) const
{
    // by symmetry only the north-east quarter of the cell matters
    const Point d = (p - centre(cell)).cwiseAbs();
    const double w = 0.5 * pitch_;
    const Point east(w, 0.5 * side_);
    const Point tip(0.0, side_);
    const bool inside = d.x() <= w && d.y() + d.x() / root3 <= side_;
    if (inside)
        return 0.0;
    return std::min(distanceToSegment(d, Point(w, 0.0), east), distanceToSegment(d, east, tip));
}

}  // namespace seahex
