#include "Sea.h"

#include <seahex/planning/HexAStar.h>
#include <seahex/planning/LatticeLengthObjective.h>
#include <seahex/planning/RouteFromPath.h>
#include <seahex/planning/SafetyWeightObjective.h>
#include <seahex/planning/Setup.h>
#include <seahex/planning/SquareAStar.h>

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <cmath>

namespace ob = ompl::base;

namespace reproduce_papers
{
namespace
{

std::shared_ptr<seahex::LatticeAStar> makePlanner(const Method &method, const ob::SpaceInformationPtr &si)
{
    std::shared_ptr<seahex::LatticeAStar> planner;
    if (method.cells == Cells::Hexagons)
    {
        auto hexagons = std::make_shared<seahex::HexAStar>(si);
        hexagons->setRings(method.rings);
        hexagons->setAnytime(false);
        hexagons->setAllJumps(true);  // as published
        planner = hexagons;
    }
    else
    {
        auto squares = std::make_shared<seahex::SquareAStar>(si);
        squares->setNeighbours(method.neighbours);
        planner = squares;
    }
    planner->setGuidance(method.guidance);
    planner->setJumps(method.jumps);
    planner->setSmoothing(false);
    return planner;
}

}  // namespace

double edgeOfEqualArea(double pitch)
{
    return pitch * std::sqrt(0.5 * std::sqrt(3.0));
}

Sea::Sea(const seahex::ChartArena &arena, const seahex::HexLattice &hexagons, const seahex::SquareLattice &squares)
    : grounds_{
          makeGround(arena.fill(hexagons)), makeGround(arena.fill(squares)),
          makeGround(arena.fill(seahex::SquareLattice::covering(squares.bounds(), edgeOfEqualArea(hexagons.pitch()))))}
{
}

Sea::Ground Sea::makeGround(std::shared_ptr<const seahex::Occupancy> occupancy)
{
    ompl::geometric::SimpleSetup setup(seahex::planarSpace(*occupancy));
    seahex::useOccupancy(setup, occupancy);
    const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
    si->setup();
    Ground ground{occupancy, si, {}};
    ground.objectives[Cost::Length] = std::make_shared<ob::PathLengthOptimizationObjective>(si);
    ground.objectives[Cost::Steps] = std::make_shared<seahex::LatticeLengthObjective>(si, occupancy->lattice());
    ground.objectives[Cost::Sailing] =
        std::make_shared<seahex::SafetyWeightObjective>(si, *occupancy, seahex::SafetyCharge::OnArrival);
    return ground;
}

std::optional<Answer> Sea::plan(const Method &method, const seahex::Point &start, const seahex::Point &goal,
                                bool isTraced) const
{
    const Ground &ground = grounds_[index(method.cells)];
    const auto problem = std::make_shared<ob::ProblemDefinition>(ground.si);
    const seahex::PlanarEmbedding embedding(ground.si->getStateSpace().get());
    ob::ScopedState<> from(ground.si);
    ob::ScopedState<> to(ground.si);
    embedding.place(from.get(), start);
    embedding.place(to.get(), goal);
    problem->setStartAndGoalStates(from, to);
    problem->setOptimizationObjective(ground.objectives.at(method.cost));

    const std::shared_ptr<seahex::LatticeAStar> planner = makePlanner(method, ground.si);
    planner->setTracing(isTraced);
    planner->setProblemDefinition(problem);
    planner->setup();
    planner->solve(ob::plannerNonTerminatingCondition());
    if (planner->outcome() != seahex::PlanningOutcome::Found)
        return std::nullopt;
    Answer answer;
    answer.path = seahex::routeFromPath(*problem->getSolutionPath()->as<ompl::geometric::PathGeometric>());
    answer.counters = planner->counters();
    answer.searchMs = planner->searchMs();
    for (const seahex::OffsetCoord cell : planner->trace())
        answer.expanded.push_back(ground.occupancy->layout().index(cell));
    return answer;
}

}  // namespace reproduce_papers
