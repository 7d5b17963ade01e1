#include "seahex/chart/ChartArena.h"

#include "seahex/chart/CellsProvenance.h"
#include "seahex/geometry/SegmentDistance.h"
#include "seahex/geometry/SegmentSpans.h"
#include "seahex/world/KeptOccupancy.h"
#include "seahex/world/OccupancyBuilder.h"

#include <boost/geometry/algorithms/covered_by.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace bg = boost::geometry;

namespace seahex
{
namespace
{

constexpr double leastAutomaticPitchM = 20.0;
constexpr double automaticCells = 4e6;

Box boxOf(const Shape &shape)
{
    Box box;
    bool first = true;
    for (const Polygon &area : shape.areas)
        for (const Point &p : area.outer())
        {
            box.min = first ? p : Point(box.min.cwiseMin(p));
            box.max = first ? p : Point(box.max.cwiseMax(p));
            first = false;
        }
    return box;
}

/// Is the hazard within a distance of a point, or of the closed cell around it?
class NearTest
{
public:
    NearTest(const HexLattice &lattice, const Point &p, std::optional<HexCoord> cell)
        : lattice_(lattice), p_(cell ? lattice.centre(*cell) : p), cell_(cell)
    {
    }

    bool isNear(const Shape &shape, double radius) const
    {
        for (const Point &point : shape.points)
            if (isNear(point, point, radius))
                return true;
        bool near = false;
        forEachSegment(shape, [&](const Point &a, const Point &b) { near = near || isNear(a, b, radius); });
        return near || isInside(shape);
    }

    bool isInside(const Shape &shape) const
    {
        return std::any_of(shape.areas.begin(), shape.areas.end(),
                           [this](const Polygon &area) { return bg::covered_by(p_, area); });
    }

    bool isNear(const Point &a, const Point &b, double radius) const
    {
        if (!cell_)
            return distanceToSegment(p_, a, b) <= radius;
        const SegmentSpans spans(lattice_, a, b, radius);
        if (cell_->s < spans.firstRow() || cell_->s > spans.lastRow())
            return false;
        const RowSpan span = spans.span(cell_->s);
        const std::int64_t column = toOffset(*cell_).column;
        return column >= span.firstColumn && column <= span.lastColumn;
    }

private:
    const HexLattice &lattice_;
    Point p_;
    std::optional<HexCoord> cell_;
};

}  // namespace

ChartArena::ChartArena(const Chart &chart, const ArenaOptions &options)
    : vessel_(options.vessel), scope_(options.scope),
      projection_(options.projection ? *options.projection : Projection::transverseMercator(chart.bounds.centre()))
{
    const auto begin = std::chrono::steady_clock::now();
    if (!projection_.isMetric() && vessel_.marginM > 0.0)
        throw std::domain_error("a margin of " + std::to_string(vessel_.marginM) +
                                " m has no meaning in a frame of degrees");
    if (!projection_.isMetric() && scope_ != HazardScope::LandOnly)
        throw std::domain_error(
            "a frame of degrees can't keep clear of dangers, only of land: the radius around a danger is "
            "in metres");
    hazards_ = projectHazards(chart, projection_);
    coverage_ = projection_.forward(chart.coverage);
    for (const Hazard &hazard : hazards_)
        verdicts_.push_back(judge(*hazard.object, vessel_, scope_));

    const Box box = boxOf(coverage_);
    scale_ = projection_.largestScale(box);
    const HexLattice lattice =
        options.lattice ? *options.lattice
                        : HexLattice::covering(box, options.pitch != 0.0 ? options.pitch : automaticPitchM(box));
    if (options.cells.empty())
        occupancy_ = fill(lattice);
    else
        keepCells(chart, lattice, options.cells);
    buildMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

void ChartArena::keepCells(const Chart &chart, const HexLattice &lattice, const std::filesystem::path &file)
{
    KeptOccupancy kept =
        loadOrMake(file, cellsProvenance(chart, vessel_, scope_, projection_, lattice), [&] { return fill(lattice); });
    occupancy_ = std::move(kept.occupancy);
    isFromFile_ = kept.isFromFile;
    warnings_ = std::move(kept.warnings);
}

/// A distance on the ground as it must be kept in the plane; none in degrees.
double ChartArena::inPlane(double distanceM) const
{
    return projection_.isMetric() ? distanceM * scale_ : 0.0;
}

double ChartArena::radius(std::size_t hazard) const
{
    return keepOutRadiusM(*hazards_[hazard].object, vessel_);
}

template <class KnownLattice>
std::shared_ptr<const LatticeOccupancy<KnownLattice>> ChartArena::fillCells(const KnownLattice &lattice) const
{
    OccupancyBuilder builder(lattice);
    builder.blockOutside(coverage_.areas, inPlane(vessel_.marginM + growthM));
    for (std::size_t i = 0; i < hazards_.size(); ++i)
        if (verdicts_[i].blocks())
            builder.block(hazards_[i].shape, inPlane(radius(i) + growthM));
    return std::move(builder).build();
}

std::shared_ptr<const HexOccupancy> ChartArena::fill(const HexLattice &lattice) const
{
    return fillCells(lattice);
}

std::shared_ptr<const SquareOccupancy> ChartArena::fill(const SquareLattice &lattice) const
{
    return fillCells(lattice);
}

std::vector<std::string> ChartArena::explainCell(HexCoord cell) const
{
    return occupancy_->isFree(cell) ? std::vector<std::string>() : explain(occupancy_->lattice().centre(cell), cell);
}

std::vector<std::string> ChartArena::explainPoint(const Point &p) const
{
    return explain(p, std::nullopt);
}

std::vector<std::string> ChartArena::explain(const Point &p, std::optional<HexCoord> cell) const
{
    std::vector<std::string> reasons;
    const NearTest test(occupancy_->lattice(), p, cell);
    const double growth = cell ? growthM : 0.0;
    if (!test.isInside(coverage_))
        reasons.push_back("outside the coverage of the chart");
    else
    {
        const double margin = inPlane(vessel_.marginM + growth);
        bool atEdge = false;
        forEachSegment(coverage_,
                       [&](const Point &a, const Point &b) { atEdge = atEdge || test.isNear(a, b, margin); });
        if (atEdge)
            reasons.push_back("too near to the edge of the chart's coverage");
    }
    for (std::size_t i = 0; i < hazards_.size(); ++i)
        if (verdicts_[i].blocks() && test.isNear(hazards_[i].shape, inPlane(radius(i) + growth)))
            reasons.push_back(seahex::explain(*hazards_[i].object, vessel_, verdicts_[i]));
    return reasons;
}

double automaticPitchM(const Box &box)
{
    const Point extent = box.max - box.min;
    // a cell's area is root 3 / 2 times the square of its pitch
    return std::max(leastAutomaticPitchM, std::sqrt(extent.x() * extent.y() / automaticCells / (0.5 * std::sqrt(3.0))));
}

std::shared_ptr<const HexOccupancy> buildOccupancy(const Chart &chart, const Vessel &vessel, double pitchM)
{
    ArenaOptions options;
    options.vessel = vessel;
    options.pitch = pitchM;
    return ChartArena(chart, options).occupancy();
}

}  // namespace seahex
