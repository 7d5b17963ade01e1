#include "seahex/geometry/SegmentSpans.h"

#include <algorithm>
#include <cmath>
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

/// The corner of a cell that goes farthest along a normal which does not point west. By symmetry it lies in the
/// eastern half: a hexagon's at its shoulder or its tip.
Point farthestCorner(bool isHex, double w, double halfHeight, const Point &normal)
{
    const double sign = normal.y() < 0.0 ? -1.0 : 1.0;
    const double northward = halfHeight * std::abs(normal.y());
    if (isHex && northward > w * normal.x() + 0.5 * northward)
        return {0.0, sign * halfHeight};
    return {w, sign * (isHex ? 0.5 * halfHeight : halfHeight)};
}

/// Half the width of hexagon + disc at a distance of t above or below its centre; negative beyond its ends.
double halfHexWidth(double w, double side, double reach, double t)
{
    // A quarter of the rounded hexagon: level side, corner arc, slanted side, arc about the tip. Each piece lies in the
    // set, so the largest of those that reach this height is the boundary.
    if (t <= 0.5 * side)
        return w + reach;
    double width = -1.0;
    const double aboveShoulder = t - 0.5 * side;
    if (aboveShoulder <= reach)
        width = w + std::sqrt((reach - aboveShoulder) * (reach + aboveShoulder));
    const double slanted = (t - 0.5 * side - halfRoot3 * reach) / (0.5 * side);
    if (slanted >= 0.0 && slanted <= 1.0)
        width = std::max(width, w * (1.0 - slanted) + 0.5 * reach);
    const double aboveTip = t - side;
    if (std::abs(aboveTip) <= reach)
        width = std::max(width, std::sqrt((reach - aboveTip) * (reach + aboveTip)));
    return width;
}

/// The same of square + disc.
double halfSquareWidth(double w, double reach, double t)
{
    const double beyond = t - w;
    if (beyond <= 0.0)
        return w + reach;
    return beyond <= reach ? w + std::sqrt((reach - beyond) * (reach + beyond)) : -1.0;
}

}  // namespace

double traversalTolerance(const Lattice &lattice, const Point &a, const Point &b)
{
    return 1e-9 * std::max({largestCoordinate(a), largestCoordinate(b), largestCoordinate(lattice.northWest()),
                            lattice.pitch()});
}

SegmentSpans::SegmentSpans(const Lattice &lattice, const Point &a, const Point &b, double radius)
    : isHex_(lattice.hexagons() != nullptr), pitch_(lattice.pitch()), halfHeight_(lattice.halfHeight()),
      firstY_(halfHeight_), rowStep_(lattice.rowStep()), tolerance_(traversalTolerance(lattice, a, b))
{
    // Half of the tolerance is spent here on being a superset; the other half covers nearly level segments and
    // rounding.
    reach_ = radius + 0.5 * tolerance_;

    // One order of the ends for both directions, so that all arithmetic below is the same.
    const bool swapped = b.y() > a.y() || (b.y() == a.y() && b.x() < a.x());
    const Point &north = swapped ? b : a;
    const Point &south = swapped ? a : b;
    const Point &origin = lattice.northWest();
    low_ = Point(north.x() - origin.x(), origin.y() - north.y());
    high_ = Point(south.x() - origin.x(), origin.y() - south.y());

    // The cell's corner, pushed out by the disc, that goes farthest along the segment's normal. Its mirror image goes
    // farthest the other way.
    const Point d = high_ - low_;
    const double length = d.norm();
    const Point normal = length > 0.0 ? Point(d.y() / length, -d.x() / length) : Point(1.0, 0.0);
    support_ = farthestCorner(isHex_, 0.5 * pitch_, halfHeight_, normal) + reach_ * normal;

    if (a.allFinite() && b.allFinite() && std::isfinite(radius))
    {
        firstRow_ = toIndex(std::ceil((low_.y() - halfHeight_ - reach_ - firstY_) / rowStep_));
        lastRow_ = toIndex(std::floor((high_.y() + halfHeight_ + reach_ - firstY_) / rowStep_));
    }
}

double SegmentSpans::halfWidth(double offset) const
{
    const double w = 0.5 * pitch_;
    const double t = std::abs(offset);
    return isHex_ ? halfHexWidth(w, halfHeight_, reach_, t) : halfSquareWidth(w, reach_, t);
}

RowSpan SegmentSpans::span(std::int64_t row) const
{
    const double y = firstY_ + rowStep_ * static_cast<double>(row);
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
    const double first = isHex_ && (row & 1) == 0 ? 1.0 : 0.5;  // centre of column 0, in pitches
    return {row, toIndex(std::ceil(west / pitch_ - first)), toIndex(std::floor(east / pitch_ - first))};
}

}  // namespace seahex
