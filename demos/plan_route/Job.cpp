#include "Job.h"

#include "Navigable.h"
#include "common/Arena.h"
#include "common/ChengScenario.h"
#include "common/Failure.h"
#include "common/PlannerCatalogue.h"

#include <seahex/chart/WrittenRouteCheck.h>
#include <seahex/planning/HexAStar.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/RouteFromPath.h>
#include <seahex/planning/Setup.h>
#include <seahex/route/RouteSmoother.h>
#include <seahex/route/StringPulling.h>
#include <seahex/search/TautSearch.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace plan_route
{

using demos::Exit;
using demos::Failure;
using demos::plain;

namespace
{

/// Start and goal with as much around them as lies between them, and a dozen miles at least: a voyage's waters.
seahex::GeoBox voyageBox(const Options &options)
{
    const auto [south, north] = std::minmax({options.from.latitudeDeg(), options.to.latitudeDeg()});
    const auto [west, east] = std::minmax({options.from.longitudeDeg(), options.to.longitudeDeg()});
    const double around = std::max({north - south, east - west, 0.2});
    return {west - around, south - around, east + around, north + around};
}

std::shared_ptr<const seahex::ChartArena> makeArena(const Options &options, const seahex::Chart &chart)
{
    seahex::ArenaOptions arena;
    arena.vessel = options.vessel;
    arena.pitch = options.pitch;
    arena.cells = options.cells;
    if (options.chengScenario)
    {
        if (options.pitch != 0.0)
            demos::checkCellCount(options.pitch,
                                  demos::cheng2020::columns * demos::cheng2020::rows *
                                      std::pow(demos::cheng2020::publishedPitchDeg() / options.pitch, 2));
        arena.projection = seahex::Projection::plateCarree();
        arena.lattice = demos::cheng2020::lattice(options.pitch);
        arena.scope = seahex::HazardScope::LandOnly;
    }
    return demos::makeArena(chart, arena);
}

/// OMPL counts nanoseconds in 64 bits: beyond 292 years it would stop at once.
constexpr double longestS = 1e9;

/// The planner's path; counters and trace go into the result.
seahex::Route search(const Options &options, Result &result)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(options.seed);
    const auto &occupancy = result.arena->occupancy();
    og::SimpleSetup setup(seahex::planarSpace(*occupancy));
    const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
    if (options.metric == seahex::LengthMetric::Lattice)
        setup.setOptimizationObjective(std::make_shared<seahex::LatticeLengthObjective>(si, occupancy->lattice()));
    seahex::useOccupancy(setup, occupancy);
    seahex::setStartAndGoal(setup, result.arena->projection().forward(options.from),
                            result.arena->projection().forward(options.to));
    const ob::PlannerPtr planner = demos::makePlanner(options.planner, si);
    setup.setPlanner(planner);
    auto *hex = dynamic_cast<seahex::HexAStar *>(planner.get());
    if (hex != nullptr)
    {
        hex->setRings(options.rings);
        hex->setGuidance(options.guidance);
        hex->setAllJumps(options.chengScenario);
        hex->setSmoothing(false);  // that is done here, so that both routes can be told
        hex->setTracing(!options.picture.empty());
    }
    setup.setup();

    const auto begin = std::chrono::steady_clock::now();
    const ob::PlannerStatus status = planner->solve(std::min(options.timeS, longestS));
    result.searchMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    if (hex != nullptr)
    {
        result.expanded = hex->counters().expanded;
        result.searchMs = hex->searchMs();
        result.isImprovable = hex->outcome() == seahex::PlanningOutcome::Improvable;
        for (const seahex::OffsetCoord cell : hex->trace())
            result.trace.push_back(occupancy->layout().index(cell));
        if (hex->outcome() == seahex::PlanningOutcome::Exhausted)
            throw Failure(Exit::NoRoute,
                          "no route at a cell size of " + plain(occupancy->lattice().pitch()) +
                              (options.chengScenario ? " degrees" : " m") +
                              ": start and goal lie in separate waters; a finer --pitch may open a passage");
    }
    if (status != ob::PlannerStatus::EXACT_SOLUTION)
        throw Failure(Exit::OutOfTime, options.planner + " found no route within " + plain(options.timeS) + " s (" +
                                           status.asString() + "); more --time may help");
    return seahex::routeFromPath(setup.getSolutionPath());
}

MeasuredRoute measure(const Options &options, const Result &result, const seahex::WrittenRouteCheck &check,
                      const seahex::Route &route, seahex::CountedLegs counted)
{
    MeasuredRoute measured;
    measured.plane = route;
    measured.written = seahex::toGeoRoute(route, result.arena->projection(), options.from, options.to);
    measured.metrics = seahex::measureRoute(route, *result.arena->occupancy(), counted);
    measured.metrics.lengthM = seahex::rhumbLengthM(measured.written);
    measured.metrics.minClearanceM = check.leastClearanceM(measured.written.waypoints);
    measured.crosses = check.crossedCautions(measured.written.waypoints);
    return measured;
}

/// The shortest route of the plane, if it is found before the time is over; empty if not, or if the given one is as
/// short. Tells whether it is proven then that no route is shorter.
seahex::Route shortest(const Options &options, const seahex::HexOccupancy &occupancy, const seahex::Route &known,
                       bool &isProven)
{
    constexpr std::uint64_t pollInterval = 1000;
    const auto end =
        std::chrono::steady_clock::now() + std::chrono::duration<double>(std::min(options.timeS, longestS));
    const double length = seahex::lengthOf(known.waypoints());
    seahex::TautSearch search(occupancy);
    search.begin(known.waypoints().front(), known.waypoints().back(), length);
    if (search.run([end] { return std::chrono::steady_clock::now() >= end; }, pollInterval) ==
        seahex::SearchStatus::Stopped)
        return {};
    seahex::Route route = search.route();
    isProven = search.isOptimal(route.waypoints().empty() ? length : seahex::lengthOf(route.waypoints()));
    return route;
}

/// The path pulled taut, or the shortest route of all; the path itself where neither is better as written.
void smooth(const Options &options, const seahex::WrittenRouteCheck &check, Result &result)
{
    const seahex::HexOccupancy &occupancy = *result.arena->occupancy();
    const seahex::Route pulled = seahex::pullString(result.raw.plane, occupancy);
    std::vector<seahex::Route> candidates;
    bool isProven = false;
    if (options.exact)
        if (seahex::Route route = shortest(options, occupancy, pulled, isProven); !route.waypoints().empty())
            candidates.push_back(std::move(route));
    candidates.push_back(pulled);
    for (std::size_t i = 0; i < candidates.size() && !result.smoothed; ++i)
    {
        MeasuredRoute smoothed = measure(options, result, check, candidates[i], seahex::CountedLegs::All);
        // Shorter in the plane may be longer on the ellipsoid where the gain is tiny; a written leg may come nearer to
        // a hazard than the line it was made from. Either way the path itself is the better route.
        constexpr double rounding = 1e-7;  // of written positions, as a share of the length
        if (smoothed.metrics.lengthM > result.raw.metrics.lengthM * (1.0 + rounding) ||
            check.firstFault(smoothed.written.waypoints))
            continue;
        result.isProvenShortest = isProven && i == 0;
        result.smoothed = std::move(smoothed);
    }
    if (!result.smoothed)
        result.smoothed = measure(options, result, check, result.raw.plane, seahex::CountedLegs::All);
}

void planOnChart(const Options &options, demos::Progress &progress, Result &result)
{
    progress.stage("filling cells");
    result.arena = makeArena(options, *result.chart);
    result.startCell = navigableCell(*result.chart, *result.arena, options.from, "start");
    result.goalCell = navigableCell(*result.chart, *result.arena, options.to, "goal");

    progress.stage("searching with " + options.planner);
    const seahex::Route path = search(options, result);
    progress.stage("smoothing and checking");
    const seahex::WrittenRouteCheck check(*result.chart, *result.arena);
    const bool onCentres = options.planner == "HexAStar";
    result.raw = measure(options, result, check, path,
                         onCentres ? seahex::CountedLegs::BetweenCentres : seahex::CountedLegs::All);
    if (const auto fault = check.firstFault(result.raw.written.waypoints))
        throw Failure(Exit::NoRoute, "leg " + std::to_string(fault->leg + 1) + " of the path as written " +
                                         fault->what + "; no route is given");
    if (options.smoothing)
        smooth(options, check, result);
}

}  // namespace

Result planRoute(const Options &options, demos::Progress &progress)
{
    Result result;
    progress.stage("reading the chart");
    result.chart = demos::readChart(options.charts, voyageBox(options));
    try
    {
        planOnChart(options, progress, result);
    }
    catch (Failure &failure)
    {
        std::vector<std::string> warnings = demos::warningsOf(*result.chart);
        if (result.arena)
            warnings.insert(warnings.end(), result.arena->warnings().begin(), result.arena->warnings().end());
        failure.setWarnings(warnings);
        throw;
    }
    catch (const seahex::PositionError &error)
    {
        throw Failure(Exit::Chart, std::string("the chart can't be planned on as a whole: ") + error.what());
    }
    return result;
}

}  // namespace plan_route
