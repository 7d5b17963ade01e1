#pragma once

#include "seahex/planning/PlanarEmbedding.h"
#include "seahex/search/AStar.h"
#include "seahex/search/Guidance.h"
#include "seahex/search/HexJumps.h"
#include "seahex/search/SearchCounters.h"
#include "seahex/world/HexOccupancy.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <vector>

namespace seahex
{

/// What HexAStar is asked: from which states to which, on which lattice, at what cost.
struct LatticeQuestion
{
    ompl::base::SpaceInformationPtr si;
    ompl::base::OptimizationObjectivePtr objective;
    HexLattice lattice;
    /// If given, the problem's validity is that of this occupancy, which is read directly; otherwise `si` is asked.
    std::shared_ptr<const HexOccupancy> occupancy;
    std::vector<const ompl::base::State *> starts;  ///< valid ones; owned by the planner
    std::vector<const ompl::base::State *> goals;
    int rings = 1;
    bool allJumps = false;
    Guidance guidance = Guidance::Distance;
    std::vector<CellIndex> *trace = nullptr;  ///< if given, collects the expanded cells in order
};

/// One search in progress, whatever graph and weight it runs on.
class LatticeQuery
{
public:
    virtual ~LatticeQuery() = default;

    /// Is any start, any goal joined to a cell? Known once run() was not stopped.
    virtual bool hasStart() const = 0;
    virtual bool hasGoal() const = 0;

    /// Joins starts and goals to their cells and searches, until found, exhausted or told to stop; goes on where it
    /// was.
    virtual SearchStatus run(const ompl::base::PlannerTerminationCondition &stop) = 0;

    /// The path found: a start state, centres, a goal state. nullptr if there is none.
    virtual std::shared_ptr<ompl::geometric::PathGeometric> path() const = 0;

    virtual SearchCounters counters() const = 0;
};

/// Chooses graph and weight for a question. Asks the problem nothing yet.
///
/// On an occupancy a state joins the centre of its own cell, which is free and convex. Elsewhere it joins every centre
/// within one ring that a valid motion reaches.
std::unique_ptr<LatticeQuery> makeLatticeQuery(const LatticeQuestion &question);

}  // namespace seahex
