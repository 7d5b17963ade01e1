#include "seahex/route/RouteMetrics.h"

#include "seahex/geometry/LatticeNorm.h"
#include "seahex/geometry/SegmentSpans.h"

#include <cmath>
#include <set>

namespace seahex
{
namespace
{

constexpr double pi = 3.14159265358979323846;

Route countedPart(const Route &route, CountedLegs counted)
{
    const std::vector<Point> &all = route.waypoints();
    if (counted == CountedLegs::All || all.size() < 3)
        return counted == CountedLegs::All ? route : Route();
    return Route(std::vector<Point>(all.begin() + 1, all.end() - 1));
}

double latticeLength(const Route &route, const Lattice &lattice, CountedLegs counted)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < route.legCount(); ++i)
    {
        const Leg leg = route.leg(i);
        // between centres of hexagons D is a whole number, and is counted as such
        sum += counted == CountedLegs::BetweenCentres
                   ? latticeDistance(lattice.cellAt(leg.from), lattice.cellAt(leg.to), lattice)
                   : latticeNorm(leg.to - leg.from, lattice);
    }
    return sum;
}

void countTurns(const Route &route, RouteMetrics &metrics)
{
    bool hasHeading = false;
    double heading = 0.0;
    for (std::size_t i = 0; i < route.legCount(); ++i)
    {
        const Leg leg = route.leg(i);
        if (leg.length() == 0.0)
            continue;
        const double change = std::abs(std::remainder(leg.heading() - heading, 2.0 * pi));
        if (hasHeading && change > leastTurnRad)
        {
            ++metrics.turns;
            metrics.turnAngleRad += change;
        }
        // A run of tiny changes is a bend all the same: the heading is that of the last leg that turned.
        if (!hasHeading || change > leastTurnRad)
            heading = leg.heading();
        hasHeading = true;
    }
}

std::int64_t countPotentialHazards(const Route &route, const Occupancy &occupancy)
{
    const Lattice &lattice = occupancy.lattice();
    std::set<OffsetCoord> hazards;
    for (std::size_t i = 0; i < route.legCount(); ++i)
        forEachTouchedCell(lattice, route.leg(i).from, route.leg(i).to,
                           [&](OffsetCoord cell)
                           {
                               for (const OffsetCoord next : lattice.neighbours(cell))
                                   if (lattice.contains(next) && occupancy.isBlocked(next))
                                       hazards.insert(next);
                               return true;
                           });
    return static_cast<std::int64_t>(hazards.size());
}

}  // namespace

double RouteMetrics::turnAngleDeg() const
{
    return turnAngleRad * 180.0 / pi;
}

RouteMetrics measureRoute(const Route &route, const Occupancy &occupancy, CountedLegs counted)
{
    RouteMetrics metrics;
    metrics.lengthCells = route.length() / occupancy.lattice().pitch();
    const Route part = countedPart(route, counted);
    metrics.lengthLattice = latticeLength(part, occupancy.lattice(), counted);
    countTurns(part, metrics);
    metrics.potentialHazards = countPotentialHazards(route, occupancy);
    return metrics;
}

}  // namespace seahex
