#pragma once

#include "planning/JumpChoice.h"
#include "planning/ProgressBoard.h"
#include "seahex/geometry/CellLayout.h"
#include "seahex/geometry/Lattice.h"
#include "seahex/search/AStar.h"
#include "seahex/search/Guidance.h"
#include "seahex/search/SearchCounters.h"
#include "seahex/world/Occupancy.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

class ChartSearches;

/// What a lattice planner is asked: from which states to which, on which lattice, at what cost.
struct LatticeQuestion
{
    ompl::base::SpaceInformationPtr si;
    ompl::base::OptimizationObjectivePtr objective;
    Lattice lattice;
    /// If given, the problem's validity is that of this occupancy, and states join the centre of their own cell, which
    /// is free and convex. Elsewhere they join every centre within one ring that a valid motion reaches; states of a
    /// HexStateSpace are centres.
    std::shared_ptr<const Occupancy> occupancy;
    /// Read the occupancy; otherwise `si` is asked, with the same result.
    bool direct = true;
    std::vector<const ompl::base::State *> starts;  ///< valid ones; owned by the planner
    std::vector<const ompl::base::State *> goals;
    JumpChoice jumps;  ///< with the most rings that useRings() will ask for
    Guidance guidance = Guidance::Distance;
    std::vector<CellIndex> *trace = nullptr;  ///< if given, collects the expanded cells of the search, in order
    ProgressBoard *board = nullptr;           ///< if given, told about the search while it runs
    bool tellsBound = false;                  ///< tell the board the lower bound of the search with all rings
    /// Where turns are charged, tell apart with which heading a cell is reached, if the memory lasts.
    bool knowsHeadings = true;
    /// If given, searches of the same occupancy whose memory may be used.
    ChartSearches *searches = nullptr;
};

/// Is it about path length in the plane or in cells, by safe jumps on the hexagons of a chart that is read, from one
/// start to one goal, guided as the planner likes? That is what LengthSearch is made for.
bool suitsLengthSearch(const LatticeQuestion &question);

/// By what a vertex of a search is known.
struct VertexName
{
    VertexName(OffsetCoord where, std::size_t heading = 0) : cell(where), way(heading) {}

    OffsetCoord cell;
    std::size_t way;  ///< where a search tells headings apart: the jump that led there; 0 elsewhere

    friend bool operator==(const VertexName &a, const VertexName &b) { return a.cell == b.cell && a.way == b.way; }
};

/// A cell that a search reached, or a cell with a heading.
struct TreeVertex
{
    VertexName name;
    Point position;
    double heading;
    std::optional<VertexName> parent;  ///< empty where a start joins the lattice
    const ompl::base::State *start;    ///< that start, or nullptr
    bool isStart;                      ///< the start is this very vertex
    bool isExpanded;
};

/// A goal whose cell a search reached.
struct GoalVertex
{
    VertexName from;
    const ompl::base::State *goal;
    bool isCentre;  ///< the goal is that very vertex
};

/// One search in progress, whatever graph and weight it runs on.
class LatticeQuery
{
public:
    virtual ~LatticeQuery() = default;

    /// Is any start, any goal joined to a cell? Known once run() was not stopped.
    virtual bool hasStart() const = 0;
    virtual bool hasGoal() const = 0;

    /// Begins the search anew with the jumps of the first rings; joints and answers of the user's code are kept.
    virtual void useRings(int rings) = 0;

    /// Joins starts and goals to their cells and searches, until found, exhausted or told to stop; goes on where it
    /// was.
    virtual SearchStatus run(const ompl::base::PlannerTerminationCondition &stop) = 0;

    /// The path found: a start state, centres, a goal state. nullptr if there is none.
    virtual std::shared_ptr<ompl::geometric::PathGeometric> path() const = 0;

    /// From a start to the centre nearest to a goal of all that were reached. nullptr if none was.
    virtual std::shared_ptr<ompl::geometric::PathGeometric> pathTowardsGoal() const = 0;

    virtual SearchCounters counters() const = 0;

    /// No path of the lattice is cheaper than this, as far as the search has come; empty if the guidance's bound is not
    /// admissible or the legs' costs are not what the path's cost is made of.
    virtual std::optional<double> lowerBound() const = 0;

    virtual void forEachVertex(const std::function<void(const TreeVertex &)> &visit) const = 0;
    /// The joints of goals whose cell was reached.
    virtual void forEachReachedGoal(const std::function<void(const GoalVertex &)> &visit) const = 0;
};

/// Chooses graph and weight for a question. Asks the problem nothing yet.
std::unique_ptr<LatticeQuery> makeLatticeQuery(const LatticeQuestion &question);

}  // namespace seahex
