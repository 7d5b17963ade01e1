#include "Job.h"

#include "Ends.h"
#include "common/Failure.h"

#include <seahex/planning/DiveSetup.h>
#include <seahex/planning/DiveStates.h>
#include <seahex/planning/PrismAStar.h>
#include <seahex/planning/SlicePlanner.h>

#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <chrono>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace plan_dive
{

using demos::Exit;
using demos::Failure;
using demos::plain;

namespace
{

/// OMPL counts nanoseconds in 64 bits: beyond 292 years it would stop at once.
constexpr double longestS = 1e9;

std::string deadEndOf(const Options &options, const seahex::SlicePlanner &planner)
{
    std::string where;
    if (!planner.deadEnds().empty())
    {
        const seahex::SliceDeadEnd &end = planner.deadEnds().front();
        where = ": no way on to slice " + std::to_string(end.plane + 1) + " of " + std::to_string(end.planes);
    }
    const bool isExact = options.planner == "LayeredPlanner";
    return "no dive found by " + options.planner + " on slices of " + std::to_string(options.settings.across) + " x " +
           std::to_string(options.settings.levels) + " points" + where + "; " +
           (isExact ? "more --slices, --across and --levels, or another --planner, may find one"
                    : "LayeredPlanner looks at all paths on these slices");
}

/// What only planners on slices know. @throws Failure if they have searched all and found nothing
void askSlices(const Options &options, const seahex::SlicePlanner &planner, Result &result)
{
    if (planner.outcome() == seahex::PlanningOutcome::Exhausted)
        throw Failure(Exit::NoRoute, deadEndOf(options, planner));
    result.isImprovable = planner.outcome() == seahex::PlanningOutcome::Improvable;
    if (planner.selection())
        result.figures = planner.selection()->keptFigures;
}

/// What only PrismAStar knows. @throws Failure if it has searched all and found nothing
void askPrisms(const Options &options, const seahex::PrismAStar &planner, Result &result)
{
    using seahex::PlanningOutcome;
    result.isImprovable = planner.outcome() == PlanningOutcome::Improvable;
    const double climb = options.settings.climb;
    const std::string within = climb > 0.0 ? " within a climb of " + plain(climb) : "";
    if (planner.outcome() == PlanningOutcome::InvalidStart || planner.outcome() == PlanningOutcome::InvalidGoal)
        throw Failure(Exit::NoRoute, std::string("no dive found by PrismAStar: no node near the ") +
                                         (planner.outcome() == PlanningOutcome::InvalidStart ? "start" : "goal") +
                                         " is reached" + within + "; a smaller --cell-size or --layer may find one");
    if (planner.outcome() != PlanningOutcome::Exhausted)
        return;
    const std::optional<seahex::PrismLattice> lattice = planner.lattice();
    throw Failure(Exit::NoRoute, "no dive found by PrismAStar" + within +
                                     (lattice ? " on cells of " + plain(lattice->plane().pitch()) + " m in " +
                                                    std::to_string(lattice->layers()) + " layers"
                                              : ", whose nodes would be too many") +
                                     "; other sizes by --cell-size and --layer" +
                                     (climb > 0.0 ? ", or a steeper --climb," : "") + " may find one");
}

/// The climb over ground as the plane has it, where a metre over ground may be more.
double climbInPlane(double climb, const Seabed &seabed)
{
    return climb / seabed.projection.largestScale(seabed.depths->grid().bounds());
}

void search(const Options &options, const std::shared_ptr<const seahex::DiveArena> &arena, const seahex::Point3 &start,
            const seahex::Point3 &goal, Result &result)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    ompl::RNG::setSeed(std::max(options.settings.seed, 1U));
    og::SimpleSetup setup(seahex::diveSpace(*arena));
    seahex::useDiveArena(setup, arena);
    seahex::setStartAndGoal(setup, start, goal);
    demos::DivePlannerSettings settings = options.settings;
    if (settings.vehicleLengthM == 0.0)
        settings.vehicleLengthM = demos::sliceDistanceM(start, goal, settings.slices);
    settings.climb = climbInPlane(settings.climb, result.seabed);
    const ob::PlannerPtr planner = demos::makeDivePlanner(options.planner, setup.getSpaceInformation(), settings);
    setup.setPlanner(planner);
    setup.setup();

    const auto begin = std::chrono::steady_clock::now();
    const ob::PlannerStatus status = planner->solve(std::min(options.timeS, longestS));
    result.searchMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    if (const auto *slices = dynamic_cast<const seahex::SlicePlanner *>(planner.get()))
        askSlices(options, *slices, result);
    if (const auto *prisms = dynamic_cast<const seahex::PrismAStar *>(planner.get()))
        askPrisms(options, *prisms, result);
    if (status != ob::PlannerStatus::EXACT_SOLUTION)
        throw Failure(Exit::OutOfTime, options.planner + " found no dive within " + plain(options.timeS) + " s (" +
                                           status.asString() + "); more --time may help");
    for (const ob::State *state : setup.getSolutionPath().getStates())
        result.dive.push_back(seahex::positionInWater(state));
}

}  // namespace

Result planDive(const Options &options, demos::Progress &progress)
{
    progress.stage("reading the seabed");
    Seabed seabed = readSeabed(options);
    try
    {
        const auto asked = makeDiveArena(seabed, options.limits, 0.0);
        const auto planned = makeDiveArena(seabed, options.limits, writingInHandM);
        const seahex::Point3 start = endInWater(seabed, *planned, options.from, "start");
        const seahex::Point3 goal = endInWater(seabed, *planned, options.to, "goal");
        Result result{seabed, asked, {}, {}, {}, {}, std::nullopt};
        progress.stage("searching with " + options.planner);
        search(options, planned, start, goal, result);
        progress.stage("checking");
        result.track = demos::measureTrack(result.dive);
        result.written = writtenDive(result.dive, seabed, options.from, options.to);
        result.measures = measureWritten(result.written, seabed, *asked, options.settings.climb);
        if (result.measures.faultyLeg)
            throw Failure(Exit::NoRoute, "leg " + std::to_string(*result.measures.faultyLeg) +
                                             " of the dive as written does not keep the limits; no dive is given");
        return result;
    }
    catch (Failure &failure)
    {
        failure.setWarnings(seabed.warnings());
        throw;
    }
    catch (const seahex::PositionError &error)
    {
        throw Failure(Exit::Chart, std::string("the seabed can't be planned on as a whole: ") + error.what());
    }
}

}  // namespace plan_dive
