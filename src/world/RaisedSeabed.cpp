#include "seahex/world/RaisedSeabed.h"

#include "seahex/geometry/SquareLattice.h"
#include "seahex/world/OccupancyBuilder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

namespace seahex
{
namespace
{

/// In steps of the grid its cells are squares, whatever its spacing. A touch in metres that rounding there would miss
/// is within this.
constexpr double ROUNDING_STEPS = 1e-6;

/// The shape in steps from the grid's first node.
Shape inSteps(Shape shape, const NodeGrid &grid)
{
    const auto convert = [&grid](auto &points)
    {
        for (Point &p : points)
            p = (p - grid.southWest()).cwiseQuotient(grid.spacing());
    };
    convert(shape.points);
    for (LineString &line : shape.lines)
        convert(line);
    for (Polygon &area : shape.areas)
    {
        convert(area.outer());
        for (Ring &hole : area.inners())
            convert(hole);
    }
    return shape;
}

SquareLattice cellsOf(const NodeGrid &grid)
{
    return {Point(0.0, static_cast<double>(grid.rows() - 1)), 1.0, grid.columns() - 1, grid.rows() - 1};
}

/// For each node, is it a corner of a touched cell?
std::vector<bool> cornersOf(const SquareOccupancy &touched, const NodeGrid &grid)
{
    std::vector<bool> corners(static_cast<std::size_t>(grid.nodeCount()), false);
    for (std::int64_t row = 0; row + 1 < grid.rows(); ++row)
        for (std::int64_t column = 0; column + 1 < grid.columns(); ++column)
            if (touched.isBlocked(OffsetCoord{column, grid.rows() - 2 - row}))
                for (const std::int64_t node : {row * grid.columns() + column, (row + 1) * grid.columns() + column})
                {
                    corners[static_cast<std::size_t>(node)] = true;
                    corners[static_cast<std::size_t>(node) + 1] = true;
                }
    return corners;
}

}  // namespace

std::shared_ptr<const Bathymetry> raisedSeabed(const Bathymetry &seabed, const std::vector<LyingObject> &objects,
                                               double heightM)
{
    if (!(heightM >= 0.0) || !std::isfinite(heightM))
        throw std::domain_error("a seabed can't be raised by " + std::to_string(heightM) + " m");
    const NodeGrid &grid = seabed.grid();
    constexpr double notKnown = std::numeric_limits<double>::infinity();
    std::map<double, OccupancyBuilder<SquareLattice>> byLeastDepth;
    for (const LyingObject &object : objects)
    {
        const bool isKnown = object.leastDepthM && std::isfinite(*object.leastDepthM);
        byLeastDepth.try_emplace(isKnown ? *object.leastDepthM : notKnown, cellsOf(grid))
            .first->second.block(inSteps(object.shape, grid),
                                 object.radius / grid.spacing().minCoeff() + ROUNDING_STEPS);
    }

    std::vector<float> depthsM;
    depthsM.reserve(static_cast<std::size_t>(grid.nodeCount()));
    for (std::int64_t row = 0; row < grid.rows(); ++row)
        for (std::int64_t column = 0; column < grid.columns(); ++column)
            depthsM.push_back(seabed.nodeDepth(column, row));
    // from the seabed as it was: where objects lie across each other, the height counts once
    for (const auto &[leastDepthM, builder] : byLeastDepth)
    {
        const std::vector<bool> corners = cornersOf(*builder.build(), grid);
        for (std::size_t i = 0; i < depthsM.size(); ++i)
            if (corners[i])
            {
                const auto column = static_cast<std::int64_t>(i) % grid.columns();
                const auto row = static_cast<std::int64_t>(i) / grid.columns();
                const double bare = seabed.nodeDepth(column, row);
                depthsM[i] = std::min(depthsM[i], Bathymetry::notDeeper(std::min(bare, leastDepthM) - heightM));
            }
    }
    return std::make_shared<const Bathymetry>(grid, std::move(depthsM));
}

}  // namespace seahex
