// What the project's objectives make of routes, over many worlds.

#include <seahex/planning/HexAStar.h>
#include <seahex/planning/RouteFromPath.h>
#include <seahex/route/RouteMetrics.h>

#include "planning/MakeObjectives.h"
#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/PlanningWorlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

/// Islands of discs between two places far apart; empty where one of these lies on an island.
std::shared_ptr<const HexOccupancy> islands(Random &random, HexCoord start, HexCoord goal)
{
    const HexLattice lattice(Point(0, 0), 1.0, 40, 40);
    const Discs discs = randomDiscs(random, lattice.bounds(), 14);
    std::vector<HexCoord> blocked;
    forEachCell(lattice, 0,
                [&](HexCoord cell)
                {
                    if (!discs.isFree(lattice.centre(cell)))
                        blocked.push_back(cell);
                });
    const auto occupancy = occupancyWith(lattice, blocked);
    return occupancy->isFree(start) && occupancy->isFree(goal) ? occupancy : nullptr;
}

/// Medians over many worlds of what an objective makes of HexAStar's routes.
struct Medians
{
    std::size_t routes;
    double hazards;
    double turnAngleDeg;
    double lengthCells;
};

Medians mediansWith(const MakeObjective &make, SpaceKind kind, bool smoothing)
{
    const HexCoord start = toCube({2, 3});
    const HexCoord goal = toCube({37, 36});
    std::vector<double> hazards;
    std::vector<double> angles;
    std::vector<double> lengths;
    forEachSeed(60,
                [&](Random &random)
                {
                    const auto occupancy = islands(random, start, goal);
                    if (!occupancy)
                        return;
                    const auto si = chartSpace(occupancy, kind);
                    const auto problem =
                        problemBetween(si, occupancy->lattice().centre(start), occupancy->lattice().centre(goal));
                    problem->setOptimizationObjective(make(si, *occupancy));
                    const auto planner = plannerFor(problem);
                    planner->setSmoothing(smoothing);
                    if (planner->solve(20.0) != ob::PlannerStatus::EXACT_SOLUTION)
                        return;
                    const RouteMetrics metrics =
                        measureRoute(routeFromPath(*pathOf(problem)), *occupancy, CountedLegs::All);
                    hazards.push_back(static_cast<double>(metrics.potentialHazards));
                    angles.push_back(metrics.turnAngleDeg());
                    lengths.push_back(metrics.lengthCells);
                });
    const auto median = [](std::vector<double> values)
    {
        std::sort(values.begin(), values.end());
        return values.empty() ? 0.0 : values[values.size() / 2];
    };
    return {lengths.size(), median(hazards), median(angles), median(lengths)};
}

void record(const std::string &name, const Medians &medians)
{
    ::testing::Test::RecordProperty(
        name, std::to_string(medians.hazards) + " hazards, " + std::to_string(medians.turnAngleDeg) + " degrees, " +
                  std::to_string(medians.lengthCells) + " cells, " + std::to_string(medians.routes) + " routes");
}

ob::OptimizationObjectivePtr length(const ob::SpaceInformationPtr &si, const HexOccupancy &)
{
    return std::make_shared<ob::PathLengthOptimizationObjective>(si);
}

TEST(ObjectiveOfRoutes, WeightsAndClearanceKeepAwayFromCoasts)
{
    for (const bool smoothing : {false, true})
    {
        const std::string how = smoothing ? "_smoothed" : "";
        const Medians shortest = mediansWith(length, SpaceKind::Plane, smoothing);
        ASSERT_GT(shortest.routes, 25u);
        record("length" + how, shortest);
        for (const NamedObjective &named :
             {NamedObjective{"clearance", clearance}, NamedObjective{"along_line", safetyAlongLine},
              NamedObjective{"on_arrival", safetyOnArrival}})
        {
            const std::string name = named.name + how;
            const Medians safe = mediansWith(named.make, SpaceKind::Plane, smoothing);
            record(name, safe);
            if (name == "on_arrival_smoothed")
                continue;  // charged on arrival, straight lines may pass the coast for nothing
            EXPECT_LT(safe.hazards, 0.5 * shortest.hazards) << name;
            EXPECT_LT(safe.lengthCells, 1.3 * shortest.lengthCells) << name;
            EXPECT_EQ(safe.routes, shortest.routes);
        }
    }
}

TEST(ObjectiveOfRoutes, APriceOfTurnsMakesThemSmaller)
{
    const MakeObjective lengthAndTurns = [](const ob::SpaceInformationPtr &si, const HexOccupancy &)
    {
        return std::make_shared<WeightedSumObjective>(
            si,
            std::vector<WeightedSumObjective::Part>{{std::make_shared<ob::PathLengthOptimizationObjective>(si), 1.0},
                                                    {std::make_shared<TurnAngleObjective>(si), 1.0}});
    };
    // in the plane, where nobody asks for turns
    const Medians shortest = mediansWith(length, SpaceKind::Plane, false);
    const Medians straighter = mediansWith(lengthAndTurns, SpaceKind::Pose, false);
    record("length", shortest);
    record("length_and_turns", straighter);
    EXPECT_LT(straighter.turnAngleDeg, 0.9 * shortest.turnAngleDeg);
}

}  // namespace
}  // namespace seahex::test
