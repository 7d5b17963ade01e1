#pragma once

#include <seahex/geometry/Point.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seahex
{

/// The surface over one cell of a grid: bilinear between the depths of its corners, over the unit square.
class BilinearPatch
{
public:
    BilinearPatch(double southWest, double southEast, double northWest, double northEast)
        : southWest_(southWest), southEast_(southEast), northWest_(northWest), northEast_(northEast)
    {
    }

    /// Are all four depths known?
    bool isKnown() const { return std::isfinite(southWest_ + southEast_ + northWest_ + northEast_); }

    double depth(const Point &p) const
    {
        const double south = (1.0 - p.x()) * southWest_ + p.x() * southEast_;
        const double north = (1.0 - p.x()) * northWest_ + p.x() * northEast_;
        return (1.0 - p.y()) * south + p.y() * north;
    }

    /// Where, between 0 and 1 of the way from a to b, depth minus `descent` times the way is least inside: the low
    /// point of the quadratic that the surface is along the line. Not a number, or beyond, if it has none there.
    double lowPoint(const Point &a, const Point &b, double descent) const
    {
        const Point by = b - a;
        const double east = southEast_ - southWest_;
        const double north = northWest_ - southWest_;
        const double twist = northEast_ - northWest_ - east;
        const double curvature = 2.0 * twist * by.x() * by.y();
        const double slope = (east + twist * a.y()) * by.x() + (north + twist * a.x()) * by.y() - descent;
        return curvature > 0.0 ? -slope / curvature : std::numeric_limits<double>::quiet_NaN();
    }

private:
    double southWest_;
    double southEast_;
    double northWest_;
    double northEast_;
};

}  // namespace seahex
