#include "DiveWorld.h"

#include "DiveRoster.h"
#include "Fingerprint.h"
#include "common/SpaceTrack.h"

#include <seahex/planning/DiveSetup.h>
#include <seahex/planning/DiveStates.h>

#include <cmath>

namespace og = ompl::geometric;

namespace benchmark_planners
{
namespace
{

using RunProperties = ompl::tools::Benchmark::RunProperties;

std::vector<seahex::Point3> positionsOf(const og::PathGeometric &path)
{
    std::vector<seahex::Point3> positions;
    for (std::size_t i = 0; i < path.getStateCount(); ++i)
        positions.push_back(seahex::positionInWater(path.getState(static_cast<unsigned int>(i))));
    return positions;
}

std::string fingerprintOf(const seahex::Bathymetry &seabed)
{
    const seahex::NodeGrid &grid = seabed.grid();
    Fingerprint fingerprint;
    for (const double number : {grid.southWest().x(), grid.southWest().y(), grid.spacing().x(), grid.spacing().y()})
        fingerprint.add(number);
    for (std::int64_t row = 0; row < grid.rows(); ++row)
        for (std::int64_t column = 0; column < grid.columns(); ++column)
            fingerprint.add(static_cast<double>(seabed.nodeDepth(column, row)));
    return fingerprint.text();
}

/// null for a depth without limit: JSON has no infinity
nlohmann::ordered_json finiteOrNull(double value)
{
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

DiveWorld::DiveWorld(std::string name, std::shared_ptr<const seahex::DiveArena> arena,
                     const seahex::Projection &projection, std::vector<demos::DivePair> pairs)
    : name_(std::move(name)), arena_(std::move(arena)), projection_(projection), pairs_(std::move(pairs)),
      judge_(*arena_->seabed(), arena_->limits())
{
}

PairFacts DiveWorld::pair(unsigned number) const
{
    const demos::DivePair &pair = pairs_[number - 1];
    const demos::Pair onChart = pair.onChart();
    return {projection_.inverse(onChart.start), projection_.inverse(onChart.goal), onChart.courseDeg(),
            onChart.distance(), DiveFacts{pair.start.z(), pair.goal.z(), pair.isSeabedInTheWay}};
}

std::unique_ptr<og::SimpleSetup> DiveWorld::makeSetup(unsigned pair) const
{
    auto setup = std::make_unique<og::SimpleSetup>(seahex::diveSpace(*arena_));
    seahex::useDiveArena(*setup, arena_);
    seahex::setStartAndGoal(*setup, pairs_[pair - 1].start, pairs_[pair - 1].goal);
    return setup;
}

std::shared_ptr<RecordedPlanner> DiveWorld::makePlanner(const std::string &name, unsigned pair, std::uint32_t seed,
                                                        const ompl::base::SpaceInformationPtr &si) const
{
    demos::DivePlannerSettings settings;
    settings.seed = seed;
    settings.vehicleLengthM = demos::sliceDistanceM(pairs_[pair - 1].start, pairs_[pair - 1].goal, settings.slices);
    return makeFromDiveRoster(name, si, settings);
}

bool DiveWorld::isSafe(const og::PathGeometric &path, RunProperties &run) const
{
    const bool isSafe = judge_.judge(positionsOf(path)).isSafe;
    run["unsafe BOOLEAN"] = isSafe ? "0" : "1";
    return isSafe;
}

double DiveWorld::measure(const og::PathGeometric &path, RunProperties &run) const
{
    const std::vector<seahex::Point3> dive = positionsOf(path);
    const demos::TrackMeasures track = demos::measureTrack(dive);
    run["length REAL"] = logNumber(track.length);
    run["legs INTEGER"] = std::to_string(dive.size() - 1);
    run["turns INTEGER"] = std::to_string(track.courseChanges);
    run["turn angle REAL"] = logNumber(track.courseAngleDeg);
    run["least clearance REAL"] = logNumber(judge_.judge(dive).leastWaterM);
    return track.length;
}

nlohmann::ordered_json DiveWorld::description() const
{
    const seahex::NodeGrid &grid = arena_->seabed()->grid();
    const seahex::DiveLimits &limits = arena_->limits();
    return {{"seabed", name_},
            {"columns", grid.columns()},
            {"rows", grid.rows()},
            {"spacing_m", {toMillionths(grid.spacing().x()), toMillionths(grid.spacing().y())}},
            {"greatest_depth_m", toMillionths(static_cast<double>(arena_->seabed()->greatestDepth()))},
            {"clearance_m", limits.clearanceM},
            {"ceiling_m", limits.ceilingM},
            {"deepest_m", finiteOrNull(limits.deepestM)},
            {"fingerprint", fingerprintOf(*arena_->seabed())}};
}

}  // namespace benchmark_planners
