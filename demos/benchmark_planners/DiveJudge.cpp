#include "DiveJudge.h"

#include <algorithm>
#include <cmath>

namespace benchmark_planners
{
namespace
{

using seahex::Point3;

constexpr double micrometre = 1e-6;

}  // namespace

DiveVerdict DiveJudge::judge(const std::vector<Point3> &dive) const
{
    DiveVerdict verdict;
    const double dx = seabed_.grid().spacing().x();
    const double dy = seabed_.grid().spacing().y();
    for (std::size_t i = 0; i < dive.size(); ++i)
    {
        look(dive[i], verdict);
        if (i == 0)
            continue;
        const Point3 &from = dive[i - 1];
        const Point3 by = dive[i] - from;
        const double cells = std::hypot(by.x() / dx, by.y() / dy);
        if (!std::isfinite(cells))
            return {false, verdict.leastWaterM};
        const auto steps = static_cast<std::int64_t>(std::ceil(10.0 * cells));
        for (std::int64_t k = 1; k < steps; ++k)
            look(from + by * (static_cast<double>(k) / static_cast<double>(steps)), verdict);
    }
    return verdict;
}

void DiveJudge::look(const Point3 &p, DiveVerdict &verdict) const
{
    const double water = seabedAt(p.x(), p.y()) - p.z();
    const bool isFree = water >= limits_.clearanceM - micrometre && p.z() >= limits_.ceilingM - micrometre &&
                        p.z() <= limits_.deepestM + micrometre;
    verdict.isSafe = verdict.isSafe && isFree;
    verdict.leastWaterM =
        std::isnan(water) ? -std::numeric_limits<double>::infinity() : std::min(verdict.leastWaterM, water);
}

/// Linear along the cell's western and eastern side, and linear between the two. Not a number outside the nodes; not
/// finite where a node has no depth.
double DiveJudge::seabedAt(double x, double y) const
{
    const seahex::NodeGrid &grid = seabed_.grid();
    const double east = (x - grid.southWest().x()) / grid.spacing().x();
    const double north = (y - grid.southWest().y()) / grid.spacing().y();
    const double slack = micrometre / grid.spacing().minCoeff();
    if (!(east >= -slack && north >= -slack && east <= static_cast<double>(grid.columns() - 1) + slack &&
          north <= static_cast<double>(grid.rows() - 1) + slack))
        return std::numeric_limits<double>::quiet_NaN();
    const auto column = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(east)), 0, grid.columns() - 2);
    const auto row = std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(north)), 0, grid.rows() - 2);
    const auto node = [&](std::int64_t c, std::int64_t r)
    {
        const float depth = seabed_.nodeDepth(c, r);
        return std::isfinite(depth) ? static_cast<double>(depth) : std::numeric_limits<double>::quiet_NaN();
    };
    const double u = east - static_cast<double>(column);
    const double v = north - static_cast<double>(row);
    const double west = node(column, row) + v * (node(column, row + 1) - node(column, row));
    const double other = node(column + 1, row) + v * (node(column + 1, row + 1) - node(column + 1, row));
    return west + u * (other - west);
}

}  // namespace benchmark_planners
