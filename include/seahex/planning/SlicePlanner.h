#pragma once

#include <seahex/planning/PlanningOutcome.h>
#include <seahex/slices/SliceSearch.h>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace seahex
{

class EndStates;
class SliceQuery;
class SpaceJudge;
struct SliceProgress;

/// What a planner on slices chose, by its own criterion F.
struct SliceSelection
{
    std::vector<Eigen::Vector3d> points;  ///< start, one point of every plane, goal
    SliceFigures figures;                 ///< of these points
    std::vector<Eigen::Vector3d> kept;    ///< those of the points that the optimisation left; all of them without it
    SliceFigures keptFigures;             ///< of the straight legs between these
};

/// Where a search over slices found no way on, between one start and one goal.
struct SliceDeadEnd
{
    std::size_t start;  ///< number of the start, in the order in which valid ones were given
    std::size_t goal;   ///< number of the goal
    int plane;          ///< no way was found to this plane; the start is in plane 0
    int planes;         ///< the goal is in the last of so many
};

/// What planners on slices share: LayeredPlanner and AntColony, so that a comparison of the two is one of their
/// searches. For problems in R^3 (z vertical, up or down) with bounds.
///
/// **Slices.** From each start to each goal, vertical planes stand across the axis at equal distances (setSlices,
/// setAxis), the first through the start, the last through the goal. The problem's checker is asked for each point of
/// the grid on them (setAcross, setLevels): blocked are those that are invalid or out of bounds, and with setInflate
/// those next above and below them. A path has one point of every plane, chosen for F = K F1 + (1 - K) F2: length in
/// vehicle lengths, danger by the share of blocked neighbours ([Xu] eq. 1-5). It never turns back along the axis and
/// never leaves the grid, so a problem may have paths and its slices none. Where start and goal are one above the
/// other along the axis, the only path tried is the straight motion.
///
/// **Validity.** Every motion of a path was found valid by checkMotion(), in its direction. [Xu] looks at grid points
/// only; where a leg between free points is invalid, it is not used here, and after that optimisation too (setOptimise)
/// asks for each motion that it puts in place of others.
///
/// **Answers.** Any objective will do, but it does not guide the search: F does. It decides between the paths found:
/// those of several pairs of starts and goals, before and after the optimisation, and a better one that takes the
/// place of another. Pairs that by the objective's estimate can't be better than the best path are skipped. Each
/// improvement is told to the intermediate-solution callback, and the best path is kept. selection() has the best by F.
///
/// **Status** and the rest of the contract as with LatticeAStar: EXACT_SOLUTION, INVALID_START, INVALID_GOAL,
/// UNRECOGNIZED_GOAL_TYPE, else TIMEOUT, also where every pair ended in a dead end: outcome() and deadEnds() tell. The
/// termination condition is looked at every 16 calls of the user's code, or before each motion where one takes more.
/// A later call goes on where the one before it stopped. A goal region with no end of samples is represented by its
/// first 100. An exception of the user's code clears the planner and passes through.
///
/// **Progress properties**, safe to read from any thread at any time: "best cost REAL", "points INTEGER" (grid points
/// asked for), "legs INTEGER" (motions asked for). Planner data are the starts and the paths found.
class SlicePlanner : public ompl::base::Planner
{
public:
    ~SlicePlanner() override;

    /// @throws ompl::Exception if the slices would have more than 10^6 points in all
    void setup() override;
    void clear() override;
    /// Clears the planner if the problem is another one.
    void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &pdef) override;
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
    using ompl::base::Planner::solve;
    /// States are the planner's and live until clear() or a change of settings; weights are the objective's.
    void getPlannerData(ompl::base::PlannerData &data) const override;

    // Setters throw ompl::Exception for values out of range.

    /// Number of planes, those of start and goal included: 2 to 1000, 25 by default.
    void setSlices(unsigned int planes);
    unsigned int getSlices() const { return static_cast<unsigned int>(resolution_.planes); }

    /// Grid points of a plane across: 2 to 1000, 25 by default.
    void setAcross(unsigned int points);
    unsigned int getAcross() const { return static_cast<unsigned int>(resolution_.across); }

    /// Levels of the grid, from the least z of the bounds to the greatest: 2 to 1000, 25 by default.
    void setLevels(unsigned int levels);
    unsigned int getLevels() const { return static_cast<unsigned int>(resolution_.levels); }

    /// "course" (start to goal, the default), "x" or "y".
    void setAxis(const std::string &axis);
    void setAxis(SliceAxis axis);
    std::string getAxis() const;

    /// Side of the square of neighbours that danger is counted in, r of [Xu]: 3, 5, 7 or 9; 3 by default.
    void setNeighbourhood(unsigned int side);
    unsigned int getNeighbourhood() const { return static_cast<unsigned int>(criterion_.neighbourhood); }

    /// K of [Xu], the weight of length against danger, 0 to 1: 0.5 by default.
    void setLengthWeight(double weight);
    double getLengthWeight() const { return criterion_.lengthWeight; }

    /// By which lengths are divided in F, in the unit of the space: positive, 1 by default.
    void setVehicleLength(double length);
    double getVehicleLength() const { return criterion_.vehicleLength; }

    /// Block the points next above and below blocked ones. On by default.
    void setInflate(bool inflate);
    bool getInflate() const { return inflate_; }

    /// Drop points that a straight motion can skip, from the goal backwards (BackwardDropping). On by default.
    void setOptimise(bool optimise);
    bool getOptimise() const { return optimise_; }

    PlanningOutcome outcome() const { return outcome_; }
    /// Of all pairs of starts and goals so far.
    const std::vector<SliceDeadEnd> &deadEnds() const { return deadEnds_; }
    /// The best by F of what was found so far; empty if nothing was, or only straight motions where there are no
    /// slices.
    const std::optional<SliceSelection> &selection() const { return selection_; }

protected:
    /// @throws ompl::Exception if the space is not R^3
    SlicePlanner(const ompl::base::SpaceInformationPtr &si, const std::string &name);

    virtual std::unique_ptr<SliceSearch> makeSearch(const SliceProblem &problem) const = 0;

    /// To be called when what makeSearch() makes has changed.
    void forgetSearch();
    /// @throws ompl::Exception if the value is not from low to high
    void requireRange(const std::string &parameter, double value, double low, double high) const;

private:
    void declareParameters();
    void declareProgress();
    PlanningOutcome plan(const ompl::base::PlannerTerminationCondition &ptc);
    void addQueries();
    bool work(SpaceJudge &judge);
    bool isHopeless(const SliceQuery &query) const;
    void take(const SliceQuery &query);
    bool isGoodEnough() const;
    ompl::base::PlannerStatus tell();

    SliceResolution resolution_;
    SliceAxis axis_ = SliceAxis::Course;
    SliceCriterion criterion_;
    bool inflate_ = true;
    bool optimise_ = true;

    ompl::base::OptimizationObjectivePtr problemObjective_;
    ompl::base::OptimizationObjectivePtr objective_;  // the problem's or, if it has none, path length

    std::unique_ptr<EndStates> ends_;
    std::vector<std::unique_ptr<SliceQuery>> queries_;  // one a pair of start and goal
    std::size_t pairedStarts_ = 0;                      // all of these and all of those have a query
    std::size_t pairedGoals_ = 0;
    std::vector<std::shared_ptr<ompl::geometric::PathGeometric>> paths_;  // that were found, for planner data
    std::shared_ptr<ompl::geometric::PathGeometric> best_;
    ompl::base::Cost bestCost_;
    std::optional<SliceSelection> selection_;
    std::vector<SliceDeadEnd> deadEnds_;
    std::unique_ptr<SliceProgress> progress_;
    PlanningOutcome outcome_ = PlanningOutcome::None;
};

}  // namespace seahex
