#include "seahex/world/Bathymetry.h"

#include "BilinearPatch.h"

#include "seahex/geometry/GridTraversal.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace seahex
{
namespace
{

constexpr double unknown = Bathymetry::unknownDepth;

BilinearPatch patchOf(const Bathymetry &bathymetry, std::int64_t column, std::int64_t row)
{
    return {bathymetry.nodeDepth(column, row), bathymetry.nodeDepth(column + 1, row),
            bathymetry.nodeDepth(column, row + 1), bathymetry.nodeDepth(column + 1, row + 1)};
}

/// The surface at a place given in steps, whose surroundings are known.
double knownDepth(const Bathymetry &bathymetry, const Point &steps)
{
    const NodeGrid &grid = bathymetry.grid();
    const std::int64_t column = std::min(static_cast<std::int64_t>(steps.x()), grid.columns() - 2);
    const std::int64_t row = std::min(static_cast<std::int64_t>(steps.y()), grid.rows() - 2);
    return patchOf(bathymetry, column, row).depth(steps - Point(static_cast<double>(column), static_cast<double>(row)));
}

/// Has every cell that a box (in steps) touches four known depths?
bool isKnown(const Bathymetry &bathymetry, const Point &low, const Point &high)
{
    const NodeGrid &grid = bathymetry.grid();
    const detail::CellRange columns(low.x(), high.x(), grid.columns() - 1);
    const detail::CellRange rows(low.y(), high.y(), grid.rows() - 1);
    for (std::int64_t row = rows.first; row <= rows.last + 1; ++row)
        for (std::int64_t column = columns.first; column <= columns.last + 1; ++column)
            if (bathymetry.nodeDepth(column, row) == Bathymetry::unknownDepth)
                return false;
    return true;
}

/// Where a box's surface can be least along one axis: at its ends and at the grid's lines between. The k-th of them.
class Stations
{
public:
    Stations(double low, double high)
        : low_(low), high_(high), firstLine_(std::floor(low) + 1.0),
          count_(2 + std::max<std::int64_t>(0, static_cast<std::int64_t>(std::ceil(high) - firstLine_)))
    {
    }

    std::int64_t count() const { return count_; }
    double at(std::int64_t k) const
    {
        return k == 0 ? low_ : k == count_ - 1 ? high_ : firstLine_ + static_cast<double>(k - 1);
    }

private:
    double low_;
    double high_;
    double firstLine_;
    std::int64_t count_;
};

bool isBefore(const Point3 &a, const Point3 &b)
{
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

Point3 atDatum(const Point &p)
{
    return {p.x(), p.y(), 0.0};
}

}  // namespace

float Bathymetry::notDeeper(double depthM)
{
    const auto nearest = static_cast<float>(depthM);
    return static_cast<double>(nearest) > depthM ? std::nextafter(nearest, unknownDepth) : nearest;
}

Bathymetry::Bathymetry(const NodeGrid &grid, std::vector<float> depthsM) : grid_(grid), depthsM_(std::move(depthsM))
{
    if (depthsM_.size() != static_cast<std::size_t>(grid.nodeCount()))
        throw std::length_error(std::to_string(depthsM_.size()) + " depths for " + std::to_string(grid.nodeCount()) +
                                " nodes");
    for (float &depth : depthsM_)
    {
        if (!std::isfinite(depth))
            depth = unknownDepth;
        greatestDepthM_ = std::max(greatestDepthM_, depth);
    }
}

double Bathymetry::depthAt(const Point &p) const
{
    if (!grid_.bounds().contains(p))
        return unknown;
    const Point steps = grid_.steps(p);
    return isKnown(*this, steps, steps) ? knownDepth(*this, steps) : unknown;
}

double Bathymetry::leastDepth(const Box &box) const
{
    const bool isBox = box.min.x() <= box.max.x() && box.min.y() <= box.max.y();
    if (!isBox || !grid_.bounds().contains(box.min) || !grid_.bounds().contains(box.max))
        return unknown;
    const Point low = grid_.steps(box.min);
    const Point high = grid_.steps(box.max);
    if (!isKnown(*this, low, high))
        return unknown;
    const Stations columns(low.x(), high.x());
    const Stations rows(low.y(), high.y());
    double least = std::numeric_limits<double>::infinity();
    for (std::int64_t j = 0; j < rows.count(); ++j)
        for (std::int64_t i = 0; i < columns.count(); ++i)
            least = std::min(least, knownDepth(*this, Point(columns.at(i), rows.at(j))));
    return least;
}

double Bathymetry::leastDepth(const std::vector<Point> &convexPolygon) const
{
    if (convexPolygon.empty())
        return unknown;
    // On its boundary, and at the nodes inside: along the grid's lines between them the surface is linear, and no point
    // inside a cell is lower than all around it.
    double least = std::numeric_limits<double>::infinity();
    double lowestRow = least;
    double highestRow = -least;
    for (std::size_t i = 0; i < convexPolygon.size(); ++i)
    {
        least = std::min(least, leastDepth(convexPolygon[i], convexPolygon[(i + 1) % convexPolygon.size()]));
        if (least == unknown)
            return unknown;
        const double row = grid_.steps(convexPolygon[i]).y();
        lowestRow = std::min(lowestRow, row);
        highestRow = std::max(highestRow, row);
    }
    for (auto row = static_cast<std::int64_t>(std::ceil(lowestRow)); static_cast<double>(row) <= highestRow; ++row)
    {
        const auto y = static_cast<double>(row);
        double west = std::numeric_limits<double>::infinity();
        double east = -west;
        for (std::size_t i = 0; i < convexPolygon.size(); ++i)
        {
            const Point a = grid_.steps(convexPolygon[i]);
            const Point b = grid_.steps(convexPolygon[(i + 1) % convexPolygon.size()]);
            if (std::min(a.y(), b.y()) > y || std::max(a.y(), b.y()) < y || a.y() == b.y())
                continue;
            const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
            west = std::min(west, x);
            east = std::max(east, x);
        }
        for (auto column = static_cast<std::int64_t>(std::ceil(west)); static_cast<double>(column) <= east; ++column)
            least = std::min<double>(least, nodeDepth(column, row));
    }
    return least;
}

double Bathymetry::leastDepth(const Point &a, const Point &b) const
{
    return leastWaterBelow(atDatum(a), atDatum(b));
}

double Bathymetry::leastWaterBelow(const Point3 &a, const Point3 &b, double enough) const
{
    if (!a.allFinite() || !b.allFinite())
        return unknown;
    if (isBefore(b, a))
        return leastWaterBelow(b, a, enough);
    double least = std::min(depthAt(horizontal(a)) - a.z(), depthAt(horizontal(b)) - b.z());
    if (least < enough || least == unknown)
        return least;

    const Point from = grid_.steps(horizontal(a));
    const Point by = grid_.steps(horizontal(b)) - from;
    const double descent = b.z() - a.z();
    forEachPassage(grid_, horizontal(a), horizontal(b),
                   [&](const GridPassage &passage)
                   {
                       const BilinearPatch patch = patchOf(*this, passage.column, passage.row);
                       if (!patch.isKnown())
                       {
                           least = unknown;
                           return false;
                       }
                       if (passage.leave < passage.enter)
                           return true;
                       const Point corner(static_cast<double>(passage.column), static_cast<double>(passage.row));
                       const auto inPatch = [&](double t)
                       {
                           const Point p = from + t * by - corner;
                           return Point(p.cwiseMax(Point::Zero()).cwiseMin(Point::Ones()));
                       };
                       const auto waterAt = [&](double t)
                       {
                           return patch.depth(inPatch(t)) - (a.z() + t * descent);
                       };
                       const double length = passage.leave - passage.enter;
                       const double low =
                           patch.lowPoint(inPatch(passage.enter), inPatch(passage.leave), length * descent);
                       least = std::min({least, waterAt(passage.enter), waterAt(passage.leave)});
                       if (low > 0.0 && low < 1.0)
                           least = std::min(least, waterAt(passage.enter + low * length));
                       return least >= enough;
                   });
    return least;
}

}  // namespace seahex
