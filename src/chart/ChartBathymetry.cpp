#include "seahex/chart/ChartBathymetry.h"

#include "ContourMarks.h"
#include "SoundingSurface.h"

#include "seahex/chart/ChartError.h"
#include "seahex/chart/HazardCatalogue.h"
#include "seahex/geometry/SegmentSpans.h"
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

constexpr float UNKNOWN = Bathymetry::unknownDepth;
constexpr float NO_LIMIT = std::numeric_limits<float>::infinity();

/// DRVAL1 of a depth area that does not give it: S-52's DEPARE03 takes it as drying.
constexpr double UNKNOWN_DEPTH_AREA_M = -1.0;

constexpr double MOST_CELLS = 1e8;

/// The corners of cells and the nodes of the grid are the same places but for rounding.
constexpr double ROUNDING_M = 1e-6;

/// The least of the depths that touch each cell.
class LeastByCell
{
public:
    explicit LeastByCell(const SquareLattice &lattice)
        : lattice_(lattice), least_(static_cast<std::size_t>(lattice.cellCount()), NO_LIMIT)
    {
    }

    /// Lowers every cell within a radius of the shapes, all of one depth.
    void lower(const std::vector<const Shape *> &shapes, float depth, double radius)
    {
        bool anyEdge = false;
        for (const Shape *shape : shapes)
        {
            for (const Point &p : shape->points)
                lowerAround(p, depth, radius);
            anyEdge = anyEdge || !shape->lines.empty() || !shape->areas.empty();
        }
        if (!anyEdge)
            return;
        OccupancyBuilder<SquareLattice> builder(lattice_);
        for (const Shape *shape : shapes)
            builder.block(*shape, radius);
        lowerBlocked(*builder.build(), depth);
    }

    void lowerBlocked(const SquareOccupancy &touched, float depth)
    {
        for (std::int64_t row = 0; row < lattice_.rows(); ++row)
            for (std::int64_t column = 0; column < lattice_.columns(); ++column)
                if (touched.isBlocked(OffsetCoord{column, row}))
                    lower(column, row, depth);
    }

    float at(std::int64_t column, std::int64_t row) const
    {
        return least_[static_cast<std::size_t>(row * lattice_.columns() + column)];
    }

private:
    void lower(std::int64_t column, std::int64_t row, float depth)
    {
        float &least = least_[static_cast<std::size_t>(row * lattice_.columns() + column)];
        least = std::min(least, depth);
    }

    void lowerAround(const Point &p, float depth, double radius)
    {
        const SegmentSpans spans(lattice_, p, p, radius);
        const std::int64_t last = std::min(spans.lastRow(), lattice_.rows() - 1);
        for (std::int64_t row = std::max<std::int64_t>(spans.firstRow(), 0); row <= last; ++row)
        {
            const RowSpan span = spans.span(row);
            const std::int64_t lastColumn = std::min(span.lastColumn, lattice_.columns() - 1);
            for (std::int64_t column = std::max<std::int64_t>(span.firstColumn, 0); column <= lastColumn; ++column)
                lower(column, row, depth);
        }
    }

    SquareLattice lattice_;
    std::vector<float> least_;
};

/// The chart's shapes by the depth that they say, shallowest first.
struct Sorted
{
    std::map<float, std::vector<const Shape *>> least;   // depth areas by DRVAL1
    std::map<float, std::vector<const Shape *>> limits;  // what a depth may not exceed; minus infinity: unknown
    std::vector<PlaneSounding> soundings;
};

bool hidesTheSeabed(const HazardObject &object)
{
    const HazardClass *row = findHazardClass(object.objectClass);
    return object.rule == HazardRule::ChartGap ||
           (object.rule == HazardRule::Always && row != nullptr && row->groupOne);
}

float depthOr(const std::optional<double> &depthM, float otherwise)
{
    return depthM && std::isfinite(*depthM) ? Bathymetry::notDeeper(*depthM) : otherwise;
}

Sorted sortByDepth(const std::vector<Hazard> &hazards, const std::vector<PlaneContour> &contours)
{
    Sorted sorted;
    for (const PlaneContour &contour : contours)
        sorted.limits[Bathymetry::notDeeper(contour.depthM)].push_back(&contour.shape);
    for (const Hazard &hazard : hazards)
    {
        const HazardObject &object = *hazard.object;
        if (object.rule == HazardRule::DepthArea)
        {
            const float least = depthOr(object.value("DRVAL1"), Bathymetry::notDeeper(UNKNOWN_DEPTH_AREA_M));
            sorted.least[least].push_back(&hazard.shape);
            sorted.limits[std::max(least, depthOr(object.value("DRVAL2"), least))].push_back(&hazard.shape);
        }
        else if (object.rule == HazardRule::Sounding)
        {
            const float depth = depthOr(object.value("DEPTH"), UNKNOWN);
            sorted.limits[depth].push_back(&hazard.shape);
            for (const Point &p : hazard.shape.points)
                if (std::isfinite(depth))
                    sorted.soundings.push_back({p, static_cast<double>(depth)});
        }
        else if (object.rule == HazardRule::Danger || object.rule == HazardRule::MarineFarm)
            sorted.limits[depthOr(object.value("VALSOU"), UNKNOWN)].push_back(&hazard.shape);
        else if (hidesTheSeabed(object))
            sorted.limits[UNKNOWN].push_back(&hazard.shape);
    }
    return sorted;
}

std::vector<PlaneContour> projectContours(const Chart &chart, const Projection &projection)
{
    std::vector<PlaneContour> contours;
    for (const DepthContour &contour : chart.contours)
        contours.push_back({contour.depthM, projection.forward(contour.shape)});
    return contours;
}

/// Soundings and contours as one surface at the nodes of a grid.
std::vector<float> estimate(std::vector<PlaneSounding> soundings, const std::vector<PlaneContour> &contours,
                            const NodeGrid &grid)
{
    const std::vector<PlaneSounding> marks = contourMarks(contours, grid);
    soundings.insert(soundings.end(), marks.begin(), marks.end());
    return soundingSurface(soundings, grid);
}

Box boxOf(const Shape &coverage)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Box box{Point(infinity, infinity), Point(-infinity, -infinity)};
    for (const Polygon &area : coverage.areas)
        for (const Point &p : area.outer())
            box = {box.min.cwiseMin(p), box.max.cwiseMax(p)};
    return box;
}

SquareLattice cellsOver(const Box &box, double spacingM)
{
    if (!(spacingM > 0.0) || !std::isfinite(spacingM))
        throw std::domain_error("nodes " + std::to_string(spacingM) + " m apart make no grid");
    const Point cells = (box.max - box.min) / spacingM;
    if (!(cells.x() * cells.y() <= MOST_CELLS))
        throw std::domain_error("nodes " + std::to_string(spacingM) + " m apart are too many for this chart");
    return SquareLattice::covering(box, spacingM);
}

}  // namespace

std::shared_ptr<const Bathymetry> chartBathymetry(const Chart &chart, const Projection &projection, double spacingM,
                                                  ChartDepths depths)
{
    if (!projection.isMetric())
        throw std::domain_error("the bathymetry of a chart needs a frame in metres");
    const std::vector<Hazard> hazards = projectHazards(chart, projection);
    const std::vector<PlaneContour> contours = projectContours(chart, projection);
    const Shape coverage = projection.forward(chart.coverage);
    const Box box = boxOf(coverage);
    const SquareLattice lattice = cellsOver(box, spacingM);
    const double radius = projection.edgeToleranceM() * projection.largestScale(box) + ROUNDING_M;
    const Sorted sorted = sortByDepth(hazards, contours);

    LeastByCell least(lattice);
    LeastByCell limit(lattice);
    for (const auto &[depth, shapes] : sorted.least)
        least.lower(shapes, depth, radius);
    for (const auto &[depth, shapes] : sorted.limits)
        limit.lower(shapes, depth, radius);
    OccupancyBuilder<SquareLattice> outside(lattice);
    outside.blockOutside(coverage.areas, radius);
    limit.lowerBlocked(*outside.build(), UNKNOWN);

    const Box bounds = lattice.bounds();
    const NodeGrid grid(bounds.min, Point(spacingM, spacingM), lattice.columns() + 1, lattice.rows() + 1);
    std::vector<float> surface;
    if (depths == ChartDepths::Interpolated)
        surface = estimate(sorted.soundings, contours, grid);
    std::vector<float> nodes(static_cast<std::size_t>(grid.nodeCount()), NO_LIMIT);
    const auto indexOf = [&grid](std::int64_t column, std::int64_t row)
    {
        return static_cast<std::size_t>(row * grid.columns() + column);
    };
    bool anyKnown = false;
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
        {
            const std::int64_t south = lattice.rows() - 1 - row;  // the cell's southern nodes
            const std::size_t corners[4] = {indexOf(column, south), indexOf(column + 1, south),
                                            indexOf(column, south + 1), indexOf(column + 1, south + 1)};
            float depth = least.at(column, row);
            if (!std::isfinite(depth))
                depth = UNKNOWN;  // no depth area at all
            else if (!surface.empty())
            {
                float lowest = NO_LIMIT;
                for (const std::size_t corner : corners)
                    lowest = std::isnan(surface[corner]) ? UNKNOWN : std::min(lowest, surface[corner]);
                depth = std::max(depth, lowest);
            }
            depth = std::min(depth, limit.at(column, row));
            anyKnown = anyKnown || std::isfinite(depth);
            for (const std::size_t corner : corners)
                nodes[corner] = std::min(nodes[corner], depth);
        }
    if (!anyKnown)
        throw ChartEmpty("no cell of " + std::to_string(spacingM) + " m lies wholly in water of known depth");
    return std::make_shared<const Bathymetry>(grid, std::move(nodes));
}

}  // namespace seahex
