#pragma once

#include "planning/LatticeQuery.h"
#include "planning/PathShortener.h"
#include "seahex/planning/LatticeAStar.h"

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace seahex
{

/// What shapes the work of a lattice planner.
struct SearchSettings
{
    JumpChoice jumps;
    Guidance guidance;
    bool anytime;
    bool smoothing;
    bool exact;
    bool direct;
    bool tracing;
};

/// On what it works.
struct SearchGround
{
    ompl::base::SpaceInformationPtr si;
    ompl::base::OptimizationObjectivePtr objective;
    Lattice lattice;
    std::shared_ptr<const Occupancy> chart;      ///< where the problem is one
    std::shared_ptr<const Occupancy> occupancy;  ///< the same within the space's bounds
    std::shared_ptr<ChartSearches> searches;     ///< of that occupancy, if it is of hexagons
};

/// The steps of a lattice planner, from a first answer to one that can't be bettered: searches in large cells or with
/// one ring, and with all rings, each followed by the shortening of its path. Can be interrupted anywhere, and goes on
/// there.
class AnytimeSearch
{
public:
    using Path = ompl::geometric::PathGeometric;
    using OnImprovement = std::function<void(const Path &, ompl::base::Cost)>;

    /// @param onImprovement  called with each path that is better than those before
    /// @param board  told about running searches; must live on
    AnytimeSearch(SearchGround ground, const SearchSettings &settings, ProgressBoard &board,
                  OnImprovement onImprovement);

    /// Begins with these states, which must live on; the best path so far is kept, as a path between some of them.
    void begin(std::vector<const ompl::base::State *> starts, std::vector<const ompl::base::State *> goals);

    /// Goes on until nothing is left to do, the cost threshold is met or the condition holds.
    void work(const ompl::base::PlannerTerminationCondition &stop);

    PlanningOutcome outcome() const;

    /// Was the best path found to be the shortest of the plane? Never where the space's bounds leave out cells: a valid
    /// path may go through the part of such a cell that lies within them.
    bool isProven() const { return isShortest_ && ground_.occupancy == ground_.chart; }

    /// nullptr if there is none.
    const std::shared_ptr<Path> &best() const { return best_; }
    ompl::base::Cost bestCost() const { return bestCost_; }

    /// From a start to the centre nearest to a goal of all that the last search reached; nullptr if it reached none.
    std::shared_ptr<Path> towardsGoal() const { return query_ ? query_->pathTowardsGoal() : nullptr; }

    /// The last search; nullptr if there was none.
    const LatticeQuery *query() const { return query_.get(); }
    std::vector<OffsetCoord> trace() const;

private:
    enum class Step
    {
        TrySteps,     // by steps between neighbours, where only the path counts; for a moment
        SearchLarge,  // in large cells, if there is no path yet
        SearchFirst,  // with one ring
        SearchSteps,  // by steps to the end, if there is still none
        SearchAll,    // with all
        Shorten,
        ProveEarly,  // where there is a path to improve on
        Prove        // find the true shortest path
    };

    bool compareDirectly(const ompl::base::PlannerTerminationCondition &stop);
    bool take(Step step, const ompl::base::PlannerTerminationCondition &stop);
    bool searchLarge(const ompl::base::PlannerTerminationCondition &stop);
    bool searchSteps(const ompl::base::PlannerTerminationCondition &stop, std::uint64_t mostExpansions);
    void offerRough(const std::vector<HexCoord> &cells);
    bool prove(const ompl::base::PlannerTerminationCondition &stop);
    bool search(int rings, const ompl::base::PlannerTerminationCondition &stop);
    bool shorten(const ompl::base::PlannerTerminationCondition &stop);
    LatticeQuestion question();
    bool isPlainLength();
    std::pair<HexCoord, HexCoord> endCells() const;
    bool endCellsAreFree() const;
    bool endsAreClear() const;
    void planSteps();
    void makeQuery();
    std::shared_ptr<Path> pathThrough(const std::vector<Point> &points) const;
    void offer(const std::shared_ptr<Path> &path);
    ompl::base::Cost leastCost() const;

    SearchGround ground_;
    SearchSettings settings_;
    ProgressBoard &board_;
    OnImprovement onImprovement_;
    PathShortener shortener_;
    std::vector<const ompl::base::State *> starts_;
    std::vector<const ompl::base::State *> goals_;
    std::size_t comparedPairs_ = 0;  // of a start and a goal
    std::vector<Step> steps_;
    std::size_t step_ = 0;  // the one that is next, or was interrupted
    bool isInStep_ = false;
    bool isShortest_ = false;  // of all through the cells searched
    bool areStepsBegun_ = false;
    std::size_t levelsLeft_ = 0;  // of large cells, the largest first
    std::unique_ptr<LatticeQuery> query_;
    std::vector<CellIndex> trace_;
    std::shared_ptr<Path> latticePath_;  // of the last search
    std::shared_ptr<Path> best_;
    ompl::base::Cost bestCost_;
};

}  // namespace seahex
