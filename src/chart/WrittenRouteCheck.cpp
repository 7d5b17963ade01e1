#include "seahex/chart/WrittenRouteCheck.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace seahex
{
namespace
{

// How far the densified image of a written leg may lie from its true line.
constexpr double lineToleranceM = 0.01;

std::vector<Hazard> edgeOf(const Shape &coverage)
{
    auto object = std::make_shared<HazardObject>();
    object->objectClass = "M_COVR";
    object->name = "edge of the chart's coverage";
    Hazard edge{object, {}};
    for (const Polygon &area : coverage.areas)
    {
        edge.shape.lines.emplace_back(area.outer().begin(), area.outer().end());
        for (const Ring &hole : area.inners())
            edge.shape.lines.emplace_back(hole.begin(), hole.end());
    }
    return {edge};
}

std::set<const HazardObject *> blockingObjects(const ChartArena &arena)
{
    std::set<const HazardObject *> objects;
    for (std::size_t i = 0; i < arena.hazards().size(); ++i)
        if (arena.verdicts()[i].blocks())
            objects.insert(arena.hazards()[i].object.get());
    return objects;
}

HazardIndex indexOf(const std::vector<Hazard> &hazards, const std::set<const HazardObject *> &objects)
{
    return HazardIndex(hazards, [&objects](const Hazard &hazard) { return objects.count(hazard.object.get()) > 0; });
}

/// What does not block but is worth a word where a route crosses it, also where only land counts. Quality areas cover
/// everything; their word is the report's.
bool deservesAWord(const Hazard &hazard, const Vessel &vessel)
{
    return hazard.object->rule != HazardRule::Quality && judge(*hazard.object, vessel).outcome == Outcome::Cost;
}

/// Calls visit(leg, a, b) for every straight piece of the waypoints' image in a frame, until it returns false.
template <class Visit>
void forEachPiece(const std::vector<GeoPoint> &waypoints, const Projection &projection, Visit &&visit)
{
    for (std::size_t leg = 0; leg + 1 < waypoints.size(); ++leg)
    {
        const LineString line = projection.forward({waypoints[leg], waypoints[leg + 1]}, lineToleranceM);
        for (std::size_t i = 0; i + 1 < line.size(); ++i)
            if (!visit(leg, line[i], line[i + 1]))
                return;
    }
}

}  // namespace

WrittenRouteCheck::WrittenRouteCheck(const Chart &chart, const ChartArena &arena)
    : arena_(arena), metric_(arena.projection().isMetric() ? arena.projection()
                                                           : Projection::transverseMercator(chart.bounds.centre())),
      ownHazards_(arena.projection().isMetric() ? std::vector<Hazard>() : projectHazards(chart, metric_)),
      coverageEdge_(edgeOf(arena.coverage())), edge_(coverageEdge_, [](const Hazard &) { return true; }),
      blocking_(indexOf(arena.hazards(), blockingObjects(arena))),
      blockingMetric_(indexOf(arena.projection().isMetric() ? arena.hazards() : ownHazards_, blockingObjects(arena))),
      cautions_(arena.projection().isMetric() ? arena.hazards() : ownHazards_,
                [&arena](const Hazard &hazard) { return deservesAWord(hazard, arena.vessel()); })
{
    if (!arena.projection().isMetric())
    {
        const double degree = 111320.0;  // metres, at most
        const double eastM = 0.5 * degree * (chart.bounds.eastDeg - chart.bounds.westDeg);
        scale_ = metric_.largestScale(Box{Point(-eastM, 0.0), Point(eastM, 0.0)});
        return;
    }
    scale_ = arena.scale();
    for (std::size_t i = 0; i < arena.hazards().size(); ++i)
        if (arena.verdicts()[i].blocks())
            largestRadiusM_ = std::max(largestRadiusM_, keepOutRadiusM(*arena.hazards()[i].object, arena.vessel()));
}

std::optional<LegFault> WrittenRouteCheck::firstFault(const std::vector<GeoPoint> &waypoints) const
{
    const double perMetre = arena_.projection().isMetric() ? scale_ : 0.0;  // of the arena's plane
    std::optional<LegFault> fault;
    forEachPiece(waypoints, arena_.projection(),
                 [&](std::size_t leg, const Point &a, const Point &b)
                 {
                     for (const HazardIndex::Near &near : blocking_.within(a, b, largestRadiusM_ * perMetre))
                         if (near.distance <= keepOutRadiusM(*near.hazard->object, arena_.vessel()) * perMetre)
                             fault = LegFault{leg, "comes too near to " + describe(*near.hazard->object)};
                     if (!fault && !edge_.within(a, b, arena_.vessel().marginM * perMetre).empty())
                         fault = LegFault{leg, "comes too near to the edge of the chart's coverage"};
                     return !fault;
                 });
    return fault;
}

double WrittenRouteCheck::leastClearanceM(const std::vector<GeoPoint> &waypoints) const
{
    double least = std::numeric_limits<double>::infinity();
    forEachPiece(waypoints, metric_,
                 [&](std::size_t, const Point &a, const Point &b)
                 {
                     least = std::min(least, blockingMetric_.nearest(a, b).distance);
                     return least > 0.0;
                 });
    return least / scale_;
}

std::vector<const HazardObject *> WrittenRouteCheck::crossedCautions(const std::vector<GeoPoint> &waypoints) const
{
    std::vector<const HazardObject *> crossed;
    forEachPiece(waypoints, metric_,
                 [&](std::size_t, const Point &a, const Point &b)
                 {
                     for (const HazardIndex::Near &near : cautions_.within(a, b, ChartArena::growthM))
                         if (std::find(crossed.begin(), crossed.end(), near.hazard->object.get()) == crossed.end())
                             crossed.push_back(near.hazard->object.get());
                     return true;
                 });
    return crossed;
}

}  // namespace seahex
