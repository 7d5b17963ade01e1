#include "seahex/geometry/HexLattice.h"

#include "seahex/geometry/SegmentDistance.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace seahex
{
namespace
{

const double root3 = std::sqrt(3.0);

/// A whole number as an integer; numbers beyond 2^60, and what is none, become +-2^60, so that sums of coordinates
/// hold.
std::int64_t toCoordinate(double number)
{
    constexpr std::int64_t limit = std::int64_t{1} << 60;
    if (!(number > -static_cast<double>(limit)))
        return -limit;
    return number < static_cast<double>(limit) ? static_cast<std::int64_t>(number) : limit;
}

}  // namespace

HexLattice::HexLattice(const Point &northWest, double pitch, std::int64_t columns, std::int64_t rows)
    : northWest_(northWest), pitch_(pitch), side_(pitch / root3), columns_(columns), rows_(rows)
{
    if (!std::isfinite(pitch) || pitch <= 0.0)
        throw std::domain_error("pitch must be positive, not " + std::to_string(pitch));
    if (!northWest.allFinite())
        throw std::domain_error("the lattice's origin is not a number");
    if (columns <= 0 || rows <= 0)
        throw std::domain_error("a lattice needs at least one column and one row, not " + std::to_string(columns) +
                                " x " + std::to_string(rows));
}

HexLattice HexLattice::covering(const Box &box, double pitch)
{
    if (!std::isfinite(pitch) || pitch <= 0.0)
        throw std::domain_error("pitch must be positive, not " + std::to_string(pitch));
    const Point extent = box.max - box.min;
    if (!extent.allFinite() || extent.x() < 0.0 || extent.y() < 0.0)
        throw std::domain_error("the box to be covered is empty or not finite");
    const double side = pitch / root3;
    // Odd rows end half a cell before even ones, and rows meet in a zigzag half a side deep.
    const double columns = std::floor(extent.x() / pitch + 0.5) + 1.0;
    const double rows = std::floor((extent.y() + 0.5 * side) / (1.5 * side)) + 1.0;
    if (columns * rows > std::ldexp(1.0, 40))
        throw std::domain_error("a pitch of " + std::to_string(pitch) + " would need " +
                                std::to_string(columns * rows) + " cells: at most 2^40");
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
