#include "seahex/route/RouteSmoother.h"

#include "seahex/route/StringPulling.h"
#include "seahex/world/SegmentValidity.h"

namespace seahex
{

Route pullString(const Route &route, const SegmentPredicate &isValid, double spacing)
{
    return route.legCount() < 2 ? route : Route(pulledTaut(route.waypoints(), isValid, spacing));
}

Route pullString(const Route &route, const Occupancy &occupancy)
{
    return pullString(
        route, [&occupancy](const Point &a, const Point &b) { return isFree(occupancy, a, b); },
        0.5 * occupancy.lattice().pitch());
}

}  // namespace seahex
