#pragma once

#include "planning/PrismQuery.h"
#include "planning/ProgressBoard.h"
#include "seahex/planning/PlanningOutcome.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

/// What shapes the work of PrismAStar.
struct PrismSettings
{
    int rings;
    double cellSize;   ///< 0: by the box
    double thickness;  ///< 0: by the climb and the depth
    bool smoothing;
};

/// The steps of PrismAStar: straight motions between starts and goals, then searches in boxes around them that grow
/// until one has a path, then that path pulled taut. Can be interrupted anywhere, and goes on there.
class PrismSearch
{
public:
    using Path = ompl::geometric::PathGeometric;
    using OnImprovement = std::function<void(const std::shared_ptr<Path> &, ompl::base::Cost)>;

    /// @param onImprovement  called with each path that is better than those before
    /// @param board, progress  told about the work; must live on
    PrismSearch(PrismGround ground, ompl::base::OptimizationObjectivePtr objective, const PrismSettings &settings,
                ProgressBoard &board, SliceProgress &progress, OnImprovement onImprovement);

    /// Begins with these states, which must live on; the best path so far is kept.
    void begin(const std::vector<ompl::base::State *> &starts, const std::vector<ompl::base::State *> &goals);

    /// Goes on until nothing is left to do, the cost threshold is met or the condition holds.
    void work(const ompl::base::PlannerTerminationCondition &stop);

    PlanningOutcome outcome() const;
    /// nullptr if there is none.
    const std::shared_ptr<Path> &best() const { return best_; }
    ompl::base::Cost bestCost() const { return bestCost_; }
    /// Of the last search; empty if there was none.
    std::optional<PrismLattice> lattice() const;
    SearchCounters counters() const { return query_ ? query_->counters() : SearchCounters(); }

private:
    enum class Stage
    {
        Straight,
        Searching,
        Pulling,
        Done
    };

    bool compareStraight(SpaceJudge &judge);
    bool search(SpaceJudge &judge);
    bool pull(SpaceJudge &judge);
    bool isGoodEnough() const;
    std::optional<PrismLattice> nextLattice();
    double thicknessFor(double pitch, double range) const;
    void tellBoard();
    void offer(const std::vector<Point3> &points);

    PrismGround ground_;
    ompl::base::OptimizationObjectivePtr objective_;
    PrismSettings settings_;
    ProgressBoard &board_;
    SliceProgress &progress_;
    OnImprovement onImprovement_;

    std::vector<const ompl::base::State *> starts_;
    std::vector<const ompl::base::State *> goals_;
    Stage stage_ = Stage::Straight;
    std::size_t comparedPairs_ = 0;
    bool mayBeBettered_ = false;  // by pairs that no straight motion joins
    double margin_ = 0.0;         // of the next box; 0 before the first
    bool isWhole_ = false;        // the last box was all there is
    std::unique_ptr<PrismQuery> query_;
    std::uint64_t expandedBefore_ = 0;  // by the searches before
    std::vector<Point3> latticePath_;
    std::vector<bool> answers_;  // while it is pulled
    std::shared_ptr<Path> best_;
    ompl::base::Cost bestCost_;
};

}  // namespace seahex
