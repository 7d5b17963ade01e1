#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/search/Guidance.h>
#include <seahex/search/SearchCounters.h>
#include <seahex/world/HexOccupancy.h>

#include <ompl/base/Planner.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace seahex
{

class LatticeQuery;

/// How the last solve() of a lattice planner ended. PlannerStatus has no word for an exhausted lattice before OMPL 1.6.
enum class PlanningOutcome
{
    None,          ///< not asked yet
    Found,         ///< the best path of the lattice
    Exhausted,     ///< no path at this cell size; a finer lattice may have one
    OutOfTime,     ///< stopped by the termination condition; solve() again continues
    InvalidStart,  ///< no start is valid and joined to a cell
    InvalidGoal    ///< no goal is valid and joined to a cell
};

/// A* on a lattice of hexagons with ring expansion [Cheng2020], for any problem in R^2 or SE(2).
///
/// **On a chart** (OccupancyValidityChecker and OccupancyMotionValidator of one occupancy, see useOccupancy) the search
/// runs on that occupancy's own lattice and reads its bits; cells whose centre lies outside the space's bounds are left
/// out. A state joins the centre of its own cell. **With no chart** the planner lays a lattice over the space's bounds
/// and asks the problem's own checker and motion validator, lazily, each cell and each motion once (motions must be as
/// valid there as back); start and goal join every centre within one ring that a valid motion reaches. In SE(2) the yaw
/// at each centre is the course of the leg that led there; a motion that does not hold with the yaw of the path's leg
/// before it is taken out of the lattice, and the search begins again.
///
/// The path is start, centres, goal; a start and a goal in one cell are joined directly if that motion is valid. It is
/// the cheapest of the lattice for the problem's optimisation objective (path length if it has none; the planner never
/// writes one into the problem), if the guidance's bound is admissible; see Guidance for the published one. Any
/// objective of OMPL's will do: costs, their sum and their order are the objective's; for path length and
/// LatticeLengthObjective, which add up along a line, they are known beforehand and the bound is exact. In SE(2) the
/// search minimises the cost of legs with their final yaw, which leaves turns to the order of expansion.
///
/// All starts and goals of the problem take part, and the best pair wins; a goal region with no end of samples, and no
/// GoalStates, is represented by its first 100. A goal state that is invalid is told at once; other regions are waited
/// for as PlannerInputStates does. Starts and goals may be added between calls of solve(); after other changes to a
/// problem call clear(), as for any planner. Another problem, objective or occupancy is noticed.
///
/// "No path" holds for this cell size only, so an exhausted search returns TIMEOUT, never INFEASIBLE; ask outcome().
/// The termination condition is looked at every 500 expansions, and every 16 calls of a user's checker or validator.
class HexAStar : public ompl::base::Planner
{
public:
    /// @throws ompl::Exception if the space is neither R^2 nor SE(2)
    explicit HexAStar(const ompl::base::SpaceInformationPtr &si);
    ~HexAStar() override;

    /// @throws ompl::Exception if the lattice of a problem with no chart would have more than 10^6 cells
    void setup() override;
    void clear() override;
    /// Clears the planner if the problem is another one.
    void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &pdef) override;
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
    using ompl::base::Planner::solve;
    /// The states and motions of the last solve()'s solution; the states are the planner's.
    void getPlannerData(ompl::base::PlannerData &data) const override;

    /// 1, 2 or 3 rings: 6, 18 or 36 successors; 3 by default. @throws ompl::Exception otherwise
    void setRings(int rings);
    int getRings() const { return rings_; }

    void setGuidance(Guidance guidance);
    /// By name: none, distance, cheng, tie_break. @throws ompl::Exception for another
    void setGuidance(const std::string &name);
    std::string getGuidance() const { return toString(guidance_); }

    /// Try every successor of a ring, also those that repeat shorter collinear jumps (JumpSet::All). Only matters where
    /// the objective is a length; others always use all.
    void setAllJumps(bool all);
    bool getAllJumps() const { return allJumps_; }

    /// Pitch of the lattice where there is no chart, in the space's unit; 0 (default): a 200th of the largest extent.
    /// @throws ompl::Exception if negative or not a number
    void setCellSize(double pitch);
    double getCellSize() const { return requestedCellSize_; }

    /// Pitch of the lattice in use; 0 before setup().
    double cellSize() const { return lattice_ ? lattice_->pitch() : 0.0; }
    /// The lattice in use; empty before setup().
    const std::optional<HexLattice> &lattice() const { return lattice_; }

    PlanningOutcome outcome() const { return outcome_; }
    const SearchCounters &counters() const { return counters_; }
    /// Wall time of the last solve(), joints and lattice search included, milliseconds.
    double searchMs() const { return searchMs_; }

    /// Record the expanded cells (off by default).
    void setTracing(bool tracing);
    /// The cells of the last query in the order of expansion, if tracing is on.
    const std::vector<HexCoord> &trace() const { return trace_; }

private:
    void declareParameters();
    bool isOutdated() const;
    void collectStarts();
    void collectGoals(const ompl::base::PlannerTerminationCondition &ptc);
    PlanningOutcome plan(const ompl::base::PlannerTerminationCondition &ptc);
    PlanningOutcome searchLattice(const ompl::base::PlannerTerminationCondition &ptc);
    bool joinDirectly(const ompl::base::PlannerTerminationCondition &ptc);
    void startQuery();
    void addSolution();
    void forgetQuery();
    void freeStates();

    int rings_ = 3;
    Guidance guidance_ = Guidance::Distance;
    bool allJumps_ = false;
    double requestedCellSize_ = 0.0;
    bool tracing_ = false;

    std::optional<HexLattice> lattice_;
    std::shared_ptr<const HexOccupancy> chart_;      // where the problem is one
    std::shared_ptr<const HexOccupancy> occupancy_;  // the same within the space's bounds
    ompl::base::OptimizationObjectivePtr problemObjective_;
    ompl::base::OptimizationObjectivePtr objective_;  // the problem's or, if it has none, path length
    std::vector<ompl::base::State *> starts_;
    std::vector<ompl::base::State *> goals_;
    std::unique_ptr<LatticeQuery> query_;
    std::size_t comparedPairs_ = 0;   // of a start and a goal
    ompl::base::PathPtr directPath_;  // the best motion between a start and a goal of one cell
    ompl::base::PathPtr solution_;

    PlanningOutcome outcome_ = PlanningOutcome::None;
    SearchCounters counters_;
    double searchMs_ = 0.0;
    std::vector<CellIndex> tracedIndices_;
    std::vector<HexCoord> trace_;
};

}  // namespace seahex
