#pragma once

#include <seahex/geometry/PrismLattice.h>
#include <seahex/planning/PlanningOutcome.h>
#include <seahex/search/SearchCounters.h>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

class EndStates;
class PrismSearch;
struct ProgressBoard;
struct SliceProgress;

/// A* on hexagonal prisms, for problems in R^3 (z vertical, up or down) with bounds: HexAStar with layers of depth, and
/// with a vehicle that climbs and dives no steeper than it can.
///
/// **Lattice.** Hexagons in the plane (setCellSize) times layers (setLayerThickness), with the jumps of up to three
/// rings (setRings) within a layer and to those next to it, no steeper than the climb (setClimb); see PrismMoves. It is
/// laid over the box of starts and goals with a margin of a quarter of its diagonal; while it has no path, the margin
/// grows, up to the bounds of the space. So a path that leads around something far away may be missed where a longer
/// one nearer by is found. Over a seabed (SeabedValidityChecker and SeabedMotionValidator of one arena, see
/// useDiveArena) the arena is read directly, with layers from its ceiling to the deepest start or goal: deeper there is
/// no water that is not free above as well. **Any other problem** is asked through its own checker and motion
/// validator, lazily, each motion in its direction, with layers from bound to bound. Starts and goals are joined to all
/// nodes nearby that a valid motion within the climb reaches.
///
/// **Answers.** A straight motion from a start to a goal, where it is valid; else the shortest path of the first
/// lattice that has one, and that path pulled taut (setSmoothing) by valid motions that keep the climb. Each
/// improvement is told to the intermediate-solution callback, and the best path is kept. Length guides the search,
/// whatever the objective; of the paths found the objective's best is the answer. The climb is kept to a billionth.
///
/// **Status** and the rest of the contract as with LatticeAStar: EXACT_SOLUTION, INVALID_START, INVALID_GOAL,
/// UNRECOGNIZED_GOAL_TYPE, else TIMEOUT, also for an exhausted search; ask outcome(). It is Exhausted, too, where a
/// lattice would have more than 10^8 nodes (10^7 where the problem must be asked), and a warning says so. The
/// termination condition is looked at every 100 expansions, and every 16 calls of the user's code, or before each
/// motion where one takes more. A later call goes on where the one before it stopped. A goal region with no end of
/// samples is represented by its first 100. An exception of the user's code clears the planner and passes through.
///
/// **Progress properties**, safe to read from any thread at any time: "best cost REAL", "expanded INTEGER" (nodes, by
/// all searches since clear()), "open INTEGER". Planner data are the starts and the paths found.
class PrismAStar : public ompl::base::Planner
{
public:
    /// @throws ompl::Exception if the space is not R^3
    explicit PrismAStar(const ompl::base::SpaceInformationPtr &si);
    ~PrismAStar() override;

    void setup() override;
    void clear() override;
    /// Clears the planner if the problem is another one.
    void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &pdef) override;
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
    using ompl::base::Planner::solve;
    /// States are the planner's and live until clear() or a change of settings; weights are the objective's.
    void getPlannerData(ompl::base::PlannerData &data) const override;

    // Setters throw ompl::Exception for values out of range.

    /// Rings of jumps, 1 to 3; 2 by default.
    void setRings(unsigned int rings);
    unsigned int getRings() const { return rings_; }

    /// Pitch of the hexagons, in the space's unit; 0 (default): a 200th of the larger side of the box searched.
    void setCellSize(double pitch);
    double getCellSize() const { return cellSize_; }

    /// From a layer to the next, at most; they are spread evenly. 0 (default): as high as the climb reaches in one
    /// pitch, but at least four steps in all; 16 steps where the climb is not limited. Layers that are farther apart
    /// than the vehicle climbs in its longest jump can't be changed.
    void setLayerThickness(double thickness);
    double getLayerThickness() const { return layerThickness_; }

    /// How much the vehicle climbs or dives in a unit of way over ground, the tangent of its steepest slope; 0
    /// (default): as much as it likes, straight up and down too.
    void setClimb(double climb);
    double getClimb() const { return climb_; }

    /// Shorten what the search found. On by default.
    void setSmoothing(bool smoothing);
    bool getSmoothing() const { return smoothing_; }

    PlanningOutcome outcome() const { return outcome_; }
    /// The lattice searched last; empty if none was.
    std::optional<PrismLattice> lattice() const;
    /// Of the search on it.
    SearchCounters counters() const;

private:
    void declareParameters();
    void declareProgress();
    void requireNotNegative(const std::string &parameter, double value) const;
    void forgetSearch();
    PlanningOutcome plan(const ompl::base::PlannerTerminationCondition &ptc);
    void beginSearch();
    ompl::base::PlannerStatus tell();

    unsigned int rings_ = 2;
    double cellSize_ = 0.0;
    double layerThickness_ = 0.0;
    double climb_ = 0.0;
    bool smoothing_ = true;

    ompl::base::OptimizationObjectivePtr problemObjective_;
    ompl::base::OptimizationObjectivePtr objective_;  // the problem's or, if it has none, path length

    std::unique_ptr<EndStates> ends_;
    std::unique_ptr<PrismSearch> search_;
    std::vector<std::shared_ptr<ompl::geometric::PathGeometric>> paths_;  // that were found, for planner data
    std::unique_ptr<ProgressBoard> board_;
    std::unique_ptr<SliceProgress> progress_;
    PlanningOutcome outcome_ = PlanningOutcome::None;
};

}  // namespace seahex
