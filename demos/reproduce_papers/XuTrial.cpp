#include "XuTrial.h"

#include "common/SpaceTrack.h"

#include <seahex/planning/AntColony.h>
#include <seahex/planning/DiveSetup.h>
#include <seahex/planning/LayeredPlanner.h>
#include <seahex/slices/HeightMap.h>

#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <algorithm>
#include <chrono>

namespace ob = ompl::base;

namespace reproduce_papers
{
namespace
{

using seahex::Point3;

constexpr int size = 25;
const Point3 startAsPublished(1.0, 8.0, 6.0);  // z upwards
const Point3 goalAsPublished(25.0, 23.0, 10.0);

/// Heights become depths below height 25.
Point3 inWater(const Point3 &asPublished)
{
    return {asPublished.x(), asPublished.y(), size - asPublished.z()};
}

std::shared_ptr<const seahex::Bathymetry> terrainOf(std::uint32_t seed)
{
    const seahex::HeightMap hills = seahex::randomHills(size, seed, {startAsPublished, goalAsPublished});
    std::vector<float> depths;
    for (int y = 1; y <= size; ++y)
        for (int x = 1; x <= size; ++x)
            depths.push_back(static_cast<float>(size - hills.at(x, y)));
    return std::make_shared<const seahex::Bathymetry>(
        seahex::NodeGrid(seahex::Point(1.0, 1.0), seahex::Point(1.0, 1.0), size, size), std::move(depths));
}

/// The paper's cube, so that slices have its levels.
ob::StateSpacePtr cube()
{
    ob::RealVectorBounds bounds(3);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
        bounds.setLow(axis, axis == 2 ? 0.0 : 1.0);
        bounds.setHigh(axis, axis == 2 ? size - 1.0 : static_cast<double>(size));
    }
    auto space = std::make_shared<ob::RealVectorStateSpace>(3);
    space->setBounds(bounds);
    return space;
}

std::shared_ptr<seahex::SlicePlanner> makePlanner(const DiveMethod &method, const ob::SpaceInformationPtr &si,
                                                  std::uint32_t seed)
{
    std::shared_ptr<seahex::SlicePlanner> planner;
    if (method.search == DiveMethod::Search::Ants)
    {
        const auto ants = std::make_shared<seahex::AntColony>(si);
        ants->setSeed(seed);
        planner = ants;
    }
    else
    {
        const auto layered = std::make_shared<seahex::LayeredPlanner>(si);
        layered->setMode(method.search == DiveMethod::Search::Greedy ? seahex::LayeredPlanner::Mode::Greedy
                                                                     : seahex::LayeredPlanner::Mode::Exact);
        planner = layered;
    }
    planner->setAxis(seahex::SliceAxis::X);
    planner->setOptimise(method.isOptimised);
    return planner;
}

std::optional<MeasuredDive> dive(const DiveMethod &method, const std::shared_ptr<const seahex::DiveArena> &arena,
                                 std::uint32_t seed)
{
    ompl::geometric::SimpleSetup setup(cube());
    seahex::useDiveArena(setup, arena);
    seahex::setStartAndGoal(setup, inWater(startAsPublished), inWater(goalAsPublished));
    const auto planner = makePlanner(method, setup.getSpaceInformation(), seed);
    setup.setPlanner(planner);
    setup.setup();
    const auto begin = std::chrono::steady_clock::now();
    const ob::PlannerStatus status = planner->solve(ob::plannerNonTerminatingCondition());
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
    if (status != ob::PlannerStatus::EXACT_SOLUTION || !planner->selection())
        return std::nullopt;
    const seahex::SliceSelection &selection = *planner->selection();
    const seahex::SliceFigures &figures = method.isOptimised ? selection.keptFigures : selection.figures;
    const demos::TrackMeasures track = demos::measureTrack(selection.kept);
    return MeasuredDive{selection.kept,      figures.length,       figures.danger, figures.total,
                        track.courseChanges, track.courseAngleDeg, taken.count()};
}

}  // namespace

bool XuTrial::isComplete() const
{
    return std::all_of(dives.begin(), dives.end(), [](const auto &found) { return found.has_value(); });
}

XuTrial runXuTrial(std::uint32_t seed)
{
    XuTrial trial;
    trial.terrain = terrainOf(seed);
    const auto arena = std::make_shared<const seahex::DiveArena>(trial.terrain, seahex::DiveLimits{0.0, 0.0});
    for (std::size_t i = 0; i < diveMethods.size(); ++i)
        trial.dives[i] = dive(diveMethods[i], arena, seed);
    return trial;
}

}  // namespace reproduce_papers
