#include "seahex/geometry/HexTraversal.h"

#include <limits>

namespace seahex
{
namespace
{

const double halfRoot3 = 0.5 * std::sqrt(3.0);

double largestCoordinate(const Point &p)
{
    return p.cwiseAbs().maxCoeff();
}

/// Far beyond any lattice a row or column is only known to be far.
std::int64_t toIndex(double value)
{
    constexpr double farthest = 0x1p60;
    return static_cast<std::int64_t>(std::clamp(value, -farthest, farthest));
}

}  // namespace

double traversalTolerance(const HexLattice &lattice, const Point &a, const Point &b)
{
    return 1e-9 * std::max({largestCoordinate(a), largestCoordinate(b), largestCoordinate(lattice.northWest()),
                            lattice.pitch()});
}

SegmentSpans::SegmentSpans(const HexLattice &lattice, const Point &a, const Point &b, double radius)
    : pitch_(lattice.pitch()), side_(lattice.side()), tolerance_(traversalTolerance(lattice, a, b))
{
    // Half of the tolerance is spent here on being a superset; the other half covers nearly level segments and
    // rounding.
    reach_ = radius + 0.5 * tolerance_;

    // One order of the ends for both directions, so that all arithmetic below is the same.
    const bool swapped = b.y() > a.y() || (b.y() == a.y() && b.x() < a.x());
    const Point &north = swapped ? b : a;
    const Point &south = swapped ? a : b;
    low_ = Point(north.x() - lattice.northWest().x(), lattice.northWest().y() - north.y());
    high_ = Point(south.x() - lattice.northWest().x(), lattice.northWest().y() - south.y());

    // The hexagon's corner, pushed out by the disc, that goes farthest along the segment's normal. Its mirror image
    // goes farthest the other way.
    const Point d = high_ - low_;
    const double length = d.norm();
    const Point normal = length > 0.0 ? Point(d.y() / length, -d.x() / length) : Point(1.0, 0.0);
    const double w = 0.5 * pitch_;
    Point corner(w, 0.5 * side_);
    for (const Point &other : {Point(w, -0.5 * side_), Point(0.0, side_), Point(0.0, -side_)})
        if (std::abs(normal.dot(other)) > std::abs(normal.dot(corner)))
            corner = other;
    if (normal.dot(corner) < 0.0)
        corner = -corner;
    support_ = corner + reach_ * normal;

    const double above = (low_.y() - side_ - reach_) / side_;
    const double below = (high_.y() + side_ + reach_) / side_;
    firstRow_ = toIndex(std::ceil((above - 1.0) / 1.5));
    lastRow_ = toIndex(std::floor((below - 1.0) / 1.5));
}

double SegmentSpans::halfWidth(double offset) const
{
    // A quarter of the rounded hexagon: level side, corner arc, slanted side, arc about the tip. Each piece lies in the
    // set, so the largest of those that reach this height is the boundary.
    const double t = std::abs(offset);
    const double w = 0.5 * pitch_;
    if (t <= 0.5 * side_)
        return w + reach_;
    double width = -1.0;
    const double aboveShoulder = t - 0.5 * side_;
    if (aboveShoulder <= reach_)
        width = w + std::sqrt((reach_ - aboveShoulder) * (reach_ + aboveShoulder));
    const double slanted = (t - 0.5 * side_ - halfRoot3 * reach_) / (0.5 * side_);
    if (slanted >= 0.0 && slanted <= 1.0)
        width = std::max(width, w * (1.0 - slanted) + 0.5 * reach_);
    const double aboveTip = t - side_;
    if (std::abs(aboveTip) <= reach_)
        width = std::max(width, std::sqrt((reach_ - aboveTip) * (reach_ + aboveTip)));
    return width;
}

RowSpan SegmentSpans::span(std::int64_t row) const
{
    const double y = side_ * (1.0 + 1.5 * static_cast<double>(row));
    double west = std::numeric_limits<double>::infinity();
    double east = -west;
    const auto include = [&west, &east](double from, double to)
    {
        west = std::min(west, from);
        east = std::max(east, to);
    };

    const double atLow = halfWidth(y - low_.y());
    const double atHigh = halfWidth(y - high_.y());
    if (high_.y() - low_.y() <= 0.5 * tolerance_)
    {
        // level within the tolerance: the wider end everywhere
        const double width = std::max(atLow, atHigh);
        if (width >= 0.0)
            include(std::min(low_.x(), high_.x()) - width, std::max(low_.x(), high_.x()) + width);
    }
    else
    {
        if (atLow >= 0.0)
            include(low_.x() - atLow, low_.x() + atLow);
        if (atHigh >= 0.0)
            include(high_.x() - atHigh, high_.x() + atHigh);
        for (const double sign : {1.0, -1.0})
        {
            const double t = (y - low_.y() - sign * support_.y()) / (high_.y() - low_.y());
            if (t >= 0.0 && t <= 1.0)
            {
                const double x = low_.x() + sign * support_.x() + t * (high_.x() - low_.x());
                include(x, x);
            }
        }
    }
    if (east < west)
        return {row, 0, -1};
    const double first = (row & 1) != 0 ? 0.5 : 1.0;  // centre of column 0, in pitches
    return {row, toIndex(std::ceil(west / pitch_ - first)), toIndex(std::floor(east / pitch_ - first))};
}

namespace
{

__extension__ using Wide = __int128;

Wide floorDivide(Wide a, Wide b)
{
    const Wide quotient = a / b;
    return quotient * b != a && ((a < 0) != (b < 0)) ? quotient - 1 : quotient;
}

}  // namespace

RowSpan touchedSpan(HexCoord a, HexCoord b, std::int64_t row)
{
    // An affine image of the plane in which all is integer: centres at (2 q + s, 3 s), corners at (0, +-2), (+-1, +-1).
    // Touching does not change under an affine map. The span is that of segment + hexagon, whose outline runs along the
    // six copies of the segment that are shifted by a corner.
    static constexpr int corner[6][2] = {{0, 2}, {0, -2}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}};
    if (a.s > b.s)
        std::swap(a, b);
    const Wide ax = 2 * Wide(a.q) + a.s;
    const Wide dx = 2 * Wide(b.q) + b.s - ax;
    const Wide dy = 3 * (Wide(b.s) - a.s);
    const Wide up = 3 * (Wide(row) - a.s);
    Wide west;
    Wide east;
    if (dy == 0)
    {
        west = std::min(ax, ax + dx);
        east = std::max(ax, ax + dx);
    }
    else
    {
        west = row == a.s ? ax : row == b.s ? ax + dx : ax + std::max<Wide>(dx, 0) + 2 + (dx < 0 ? -dx : 0);
        east = row == a.s ? ax : row == b.s ? ax + dx : ax + std::min<Wide>(dx, 0) - 2 - (dx > 0 ? dx : 0);
        for (const auto &c : corner)
        {
            const Wide t = up - c[1];
            if (t < 0 || t > dy)
                continue;
            west = std::min(west, ax + c[0] - floorDivide(-dx * t, dy));
            east = std::max(east, ax + c[0] + floorDivide(dx * t, dy));
        }
    }
    // a centre's x has the parity of its row
    const Wide firstQ = -floorDivide(row - west, 2);
    const Wide lastQ = floorDivide(east - row, 2);
    const std::int64_t shift = (row + (row & 1)) / 2;
    return {row, static_cast<std::int64_t>(firstQ) + shift, static_cast<std::int64_t>(lastQ) + shift};
}

}  // namespace seahex
