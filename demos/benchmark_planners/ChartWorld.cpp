#include "ChartWorld.h"

#include "Fingerprint.h"
#include "Roster.h"

#include <seahex/io/GeoRoute.h>
#include <seahex/planning/RouteFromPath.h>
#include <seahex/planning/Setup.h>
#include <seahex/route/RouteMetrics.h>
#include <seahex/world/SegmentValidity.h>

namespace og = ompl::geometric;

namespace benchmark_planners
{
namespace
{

using RunProperties = ompl::tools::Benchmark::RunProperties;

std::string fingerprintOf(const seahex::HexOccupancy &occupancy)
{
    Fingerprint fingerprint;
    fingerprint.add(occupancy.lattice().northWest().x());
    fingerprint.add(occupancy.lattice().northWest().y());
    fingerprint.add(occupancy.lattice().pitch());
    for (const std::uint64_t word : occupancy.words())
        fingerprint.add(word);
    return fingerprint.text();
}

}  // namespace

ChartWorld::ChartWorld(std::shared_ptr<const seahex::Chart> chart, std::shared_ptr<const seahex::ChartArena> arena,
                       std::vector<demos::Pair> pairs)
    : chart_(std::move(chart)), arena_(std::move(arena)), check_(*chart_, *arena_), pairs_(std::move(pairs))
{
}

PairFacts ChartWorld::pair(unsigned number) const
{
    const demos::Pair &pair = pairs_[number - 1];
    return {arena_->projection().inverse(pair.start), arena_->projection().inverse(pair.goal), pair.courseDeg(),
            pair.distance()};
}

std::unique_ptr<og::SimpleSetup> ChartWorld::makeSetup(unsigned pair) const
{
    auto setup = std::make_unique<og::SimpleSetup>(seahex::planarSpace(*arena_->occupancy()));
    seahex::useOccupancy(*setup, arena_->occupancy());
    seahex::setStartAndGoal(*setup, pairs_[pair - 1].start, pairs_[pair - 1].goal);
    return setup;
}

std::shared_ptr<RecordedPlanner> ChartWorld::makePlanner(const std::string &name, unsigned, std::uint32_t,
                                                         const ompl::base::SpaceInformationPtr &si) const
{
    return makeFromRoster(name, si);
}

bool ChartWorld::isSafe(const og::PathGeometric &path, RunProperties &) const
{
    const seahex::Route route = seahex::routeFromPath(path);
    for (std::size_t i = 0; i < route.legCount(); ++i)
        if (!seahex::isFree(*arena_->occupancy(), route.leg(i).from, route.leg(i).to))
            return false;
    return true;
}

double ChartWorld::measure(const og::PathGeometric &path, RunProperties &run) const
{
    const seahex::Route route = seahex::routeFromPath(path);
    const seahex::RouteMetrics metrics = seahex::measureRoute(route, *arena_->occupancy(), seahex::CountedLegs::All);
    const seahex::Projection &projection = arena_->projection();
    const seahex::GeoRoute written = seahex::toGeoRoute(
        route, projection, projection.inverse(route.waypoints().front()), projection.inverse(route.waypoints().back()));
    run["length REAL"] = logNumber(route.length());
    run["legs INTEGER"] = std::to_string(route.legCount());
    run["turns INTEGER"] = std::to_string(metrics.turns);
    run["turn angle REAL"] = logNumber(metrics.turnAngleDeg());
    run["least clearance REAL"] = logNumber(check_.leastClearanceM(written.waypoints));
    return route.length();
}

nlohmann::ordered_json ChartWorld::description() const
{
    nlohmann::ordered_json charts = nlohmann::ordered_json::array();
    for (const seahex::CellReport &cell : chart_->cells)
        charts.push_back(cell.name);
    const seahex::HexOccupancy &occupancy = *arena_->occupancy();
    const seahex::Vessel &vessel = arena_->vessel();
    return {{"charts", charts},
            {"draught_m", vessel.draughtM},
            {"ukc_m", vessel.underKeelClearanceM},
            {"margin_m", vessel.marginM},
            {"pitch_m", toMillionths(occupancy.lattice().pitch())},
            {"columns", occupancy.lattice().columns()},
            {"rows", occupancy.lattice().rows()},
            {"blocked", occupancy.blockedCount()},
            {"fingerprint", fingerprintOf(occupancy)}};
}

}  // namespace benchmark_planners
