// A chart, a vessel, a planner, a route: the program of the README. Run it in the project's folder.

#include <seahex/seahex.h>

int main()
{
    const seahex::Chart chart = seahex::readChart("maps/shangchuan.000");
    const seahex::ChartArena arena(chart, {});  // 1.2 m of draught, 0.5 m under the keel, cells of 20 m or so
    const auto start = seahex::GeoPoint::fromLatLon(21.635, 112.521);
    const auto goal = seahex::GeoPoint::fromLatLon(21.669, 112.901);

    ompl::geometric::SimpleSetup setup(seahex::planarSpace(*arena.occupancy()));
    seahex::useOccupancy(setup, arena.occupancy());
    seahex::setStartAndGoal(setup, arena.projection().forward(start), arena.projection().forward(goal));
    setup.setPlanner(std::make_shared<seahex::HexAStar>(setup.getSpaceInformation()));
    if (setup.solve(10.0) != ompl::base::PlannerStatus::EXACT_SOLUTION)
        return 1;

    const seahex::Route route = pullString(seahex::routeFromPath(setup.getSolutionPath()), *arena.occupancy());
    const seahex::GeoRoute written = toGeoRoute(route, arena.projection(), start, goal);
    if (seahex::WrittenRouteCheck(chart, arena).firstFault(written.waypoints))
        return 1;
    seahex::writeGeoJson("route.geojson", {&written});
    return 0;
}
