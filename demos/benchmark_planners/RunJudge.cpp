#include "RunJudge.h"

#include <seahex/io/GeoRoute.h>
#include <seahex/planning/RouteFromPath.h>
#include <seahex/route/RouteMetrics.h>
#include <seahex/world/SegmentValidity.h>

#include <cstdio>

namespace og = ompl::geometric;

namespace benchmark_planners
{

std::optional<double> RunJudge::judge(ompl::tools::Benchmark::RunProperties &run) const
{
    if (!setup_.haveExactSolutionPath())
        return std::nullopt;
    const og::PathGeometric &path = setup_.getSolutionPath();
    const bool valid = isValid(path);
    run["valid BOOLEAN"] = valid ? "1" : "0";
    if (!valid)
        return std::nullopt;

    const seahex::Route route = seahex::routeFromPath(path);
    const seahex::RouteMetrics metrics =
        seahex::measureRoute(route, *world_.arena->occupancy(), seahex::CountedLegs::All);
    const seahex::Projection &projection = world_.arena->projection();
    const seahex::GeoRoute written = seahex::toGeoRoute(
        route, projection, projection.inverse(route.waypoints().front()), projection.inverse(route.waypoints().back()));
    run["length REAL"] = logNumber(route.length());
    run["legs INTEGER"] = std::to_string(route.legCount());
    run["turns INTEGER"] = std::to_string(metrics.turns);
    run["turn angle REAL"] = logNumber(metrics.turnAngleDeg());
    run["least clearance REAL"] = logNumber(world_.check.leastClearanceM(written.waypoints));
    return route.length();
}

bool RunJudge::isValid(const og::PathGeometric &path) const
{
    const auto &problem = setup_.getProblemDefinition();
    const auto &si = setup_.getSpaceInformation();
    if (path.getStateCount() < 2 || !path.check() || !si->equalStates(path.getState(0), problem->getStartState(0)) ||
        !problem->getGoal()->isSatisfied(path.getState(path.getStateCount() - 1)))
        return false;
    const seahex::Route route = seahex::routeFromPath(path);
    for (std::size_t i = 0; i < route.legCount(); ++i)
        if (!seahex::isFree(*world_.arena->occupancy(), route.leg(i).from, route.leg(i).to))
            return false;
    return true;
}

std::string logNumber(double value)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text;
}

}  // namespace benchmark_planners
