#pragma once

#include <seahex/geometry/Box.h>
#include <seahex/geometry/Lattice.h>
#include <seahex/planning/PlanningOutcome.h>
#include <seahex/search/Guidance.h>
#include <seahex/search/Jumps.h>
#include <seahex/search/SearchCounters.h>
#include <seahex/world/Occupancy.h>

#include <ompl/base/Planner.h>
#include <ompl/geometric/PathGeometric.h>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace seahex
{

class AnytimeSearch;
class ChartSearches;
class EndStates;
class PlanarEmbedding;
class SearchTree;
struct JumpChoice;
struct ProgressBoard;

/// What the tag of a vertex says in the PlannerData of a lattice planner.
enum class PlannerDataTag
{
    Waiting = 0,   ///< reached, and in the open list; also a goal that is joined
    Expanded = 1,  ///< expanded; also a start
    Solution = 2   ///< on the best path
};

/// A better answer than those before it.
struct Improvement
{
    double seconds;  ///< since solve() began
    double cost;     ///< of the whole path, by the problem's objective
};

/// Anytime A* on a lattice of cells, for problems in R^2 and SE(2): what HexAStar and SquareAStar share, so that a
/// comparison of the two is one of their lattices.
///
/// **Lattice.** On a chart of the planner's own kind of cells (OccupancyValidityChecker and OccupancyMotionValidator of
/// one occupancy, see useOccupancy) the search runs on that occupancy's own lattice and reads its bits (setDirect);
/// cells whose centre lies outside the space's bounds are left out. A state joins the centre of its own cell. **On any
/// other problem** the planner lays a lattice over the space's bounds and asks the problem's own checker and motion
/// validator, lazily, each cell and each motion once (motions must be as valid there as back); start and goal join
/// every centre within one ring that a valid motion reaches. In SE(2) the yaw at each centre is the course of the leg
/// that led there; a motion that does not hold with the yaw of the path's leg before it is taken out of the lattice,
/// and the search begins again.
///
/// **Answers.** solve() works in steps, each of which may better the answer: a search with one ring (setAnytime), its
/// path shortened (setSmoothing), the search with all rings, its path shortened. For path length in the plane, from one
/// start to one goal on the hexagons of a chart, with the guidance automatic and both of those on, the steps are these:
/// on large lattices paths through large cells, of which the first takes a fraction of a millisecond on millions of
/// cells, shortened; where there is none, the shortest chain of steps between neighbours (JumpPointSearch), shortened;
/// then the true shortest path of the plane, whatever its angles (HexAStar::setExact, TautSearch), with a proof. The
/// lattice itself is searched with that switched off, or where the last leg of a proof can't be made free. The best
/// path is kept, each improvement told to the problem's intermediate-solution callback (states from start to goal) and
/// noted in improvements(). Work ends when the steps are done, when the termination condition holds, or when the best
/// cost satisfies the objective's threshold. With both switched off the answer is the lattice's optimum: start,
/// centres, goal, the cheapest for the problem's objective (path length if it has none; the planner never writes one
/// into the problem), if the guidance's bound is admissible; see Guidance for the published one. A start and a goal in
/// one cell are joined directly if that motion is valid.
///
/// **Objectives.** Any of OMPL's will do: costs, their sum and their order are the objective's; for path length and
/// LatticeLengthObjective, which add up along a line, they are known beforehand and the bound is exact; so they are for
/// the SafetyWeightObjective on arrival of the lattice searched.
///
/// **Turns.** In SE(2) a leg costs what depends on the yaw that the leg before it left. On a chart that is read, for
/// path length (which charges for yaw there), TurnCountObjective, TurnAngleObjective and their sums
/// (WeightedSumObjective, OMPL's MultiOptimizationObjective; weights not negative, no derived classes), the search
/// tells apart with which heading a cell is reached. Its path is then the lattice's best for the objective as it is,
/// the first and last leg and the yaws of start and goal included. It takes longer than a plain search: 4 to 10
/// times in the median on 10^5 cells, 20 times on 4 million, most in open water, where a plain search has but to break
/// ties; and 225 bytes a cell touched instead of 9. In all other problems (more than 116 million cells, or memory that
/// does not last, among them) a cell keeps one way to reach it, the cheapest: where costs depend on yaws the path found
/// is good but need not be the lattice's best.
///
/// **Problem.** All starts and goals take part, and the best pair wins; a goal region with no end of samples, and no
/// GoalStates, is represented by its first 100. A goal state that is invalid is told at once; other regions are waited
/// for as PlannerInputStates does, and goals that turn up during the search make it begin again with all of them.
/// Starts and goals may be added between calls of solve(); after other changes to a problem call clear(), as for any
/// planner. Another problem, objective or occupancy is noticed. A later call goes on where the one before it stopped;
/// its answer is never worse.
///
/// **Status.** EXACT_SOLUTION; APPROXIMATE_SOLUTION if asked for (setApproximate); INVALID_START, INVALID_GOAL,
/// UNRECOGNIZED_GOAL_TYPE (not sampleable); else TIMEOUT, also for an exhausted search, since "no path" holds for this
/// cell size only; ask outcome(). The termination condition is looked at every 500 expansions, and every 16 calls of a
/// user's checker, or after each motion where one takes more of them. An exception of the user's code clears the
/// planner and passes through.
///
/// **Progress properties**, safe to read from any thread at any time: "best cost REAL", "lower bound REAL" (no path
/// that this planner may yet return is cheaper: the search's own bound where smoothing is off; that of the search for
/// the shortest path, once that has begun; the objective's heuristic otherwise), "expanded INTEGER" (cells, or cells
/// with headings, by all searches of the lattice since clear(); large cells, JumpPointSearch and TautSearch are not
/// counted), "open INTEGER".
class LatticeAStar : public ompl::base::Planner
{
public:
    ~LatticeAStar() override;

    /// @throws ompl::Exception if the lattice of a problem with no chart of this planner's cells would have more than
    /// 10^6 cells, or a HexStateSpace that must be asked, or a chart with setDirect(false), has more than 10^7
    void setup() override;
    void clear() override;
    /// Clears the planner if the problem is another one.
    void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &pdef) override;
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
    using ompl::base::Planner::solve;
    /// The tree of the last search, its jumps weighted by the objective, joined to starts and goals, and the best path;
    /// tags are PlannerDataTag. The states are the planner's and live until clear() or a change of settings.
    void getPlannerData(ompl::base::PlannerData &data) const override;

    void setGuidance(Guidance guidance);
    /// By name: automatic, none, distance, euclidean, cheng, wang, tie_break, relaxed. @throws ompl::Exception for
    /// another
    void setGuidance(const std::string &name);
    std::string getGuidance() const { return toString(guidance_); }

    /// Shorten what a search found by straight valid motions, as far as that lowers its cost. On by default.
    void setSmoothing(bool smoothing);
    bool getSmoothing() const { return smoothing_; }

    /// Has the path found been proven to be the shortest of the plane (HexAStar::setExact)? Never where the space's
    /// bounds leave out free cells: a shorter one may pass through what of these lies within the bounds.
    bool isProvenShortest() const;

    /// With no path to a goal, tell the one to the centre nearest to a goal as an approximate solution. Off by default.
    void setApproximate(bool approximate);
    bool getApproximate() const { return approximate_; }

    /// What a jump needs (JumpRule): "safe" or "hopping"; safe by default. **A path of hopping jumps may pass over
    /// blocked cells**: it is no path of the problem, only of the figures that it reproduces.
    /// @throws ompl::Exception for another name
    void setJumps(const std::string &rule);
    void setJumps(JumpRule rule);
    std::string getJumps() const { return toString(jumpRule_); }

    /// Read the occupancy behind a chart's checker, or ask the checker and motion validator as for any other problem:
    /// slower, with up to 37 bytes a cell to keep the answers, and the same result, but where turns are charged (see
    /// Turns). On by default.
    void setDirect(bool direct);
    bool getDirect() const { return direct_; }

    /// Pitch of the lattice where there is no chart, in the space's unit; 0 (default): a 200th of the largest extent.
    /// @throws ompl::Exception if negative or not a number
    void setCellSize(double pitch);
    double getCellSize() const { return requestedCellSize_; }

    /// Pitch of the lattice in use; 0 before setup().
    double cellSize() const { return lattice_ ? lattice_->pitch() : 0.0; }
    /// The lattice in use; empty before setup().
    const std::optional<Lattice> &lattice() const { return lattice_; }

    PlanningOutcome outcome() const { return outcome_; }
    /// Of the search of the lattice with the most rings that has begun; all 0 where none was needed.
    const SearchCounters &counters() const { return counters_; }
    /// Wall time of the last solve(), joints, searches and smoothing included, milliseconds.
    double searchMs() const { return searchMs_; }
    /// The answers of the last solve(), each better than the one before; the first may be known from earlier.
    const std::vector<Improvement> &improvements() const { return improvements_; }

    /// Record the expanded cells (off by default).
    void setTracing(bool tracing);
    /// The cells of the search that counters() is about, in the order of expansion, if tracing is on; where it tells
    /// headings apart, a cell once for each with which it was expanded.
    const std::vector<OffsetCoord> &trace() const { return trace_; }

protected:
    /// @throws ompl::Exception if the space is neither R^2 nor SE(2) nor a HexStateSpace
    LatticeAStar(const ompl::base::SpaceInformationPtr &si, const std::string &name);

    /// Does the planner search lattices of this kind?
    virtual bool isOwn(const Lattice &lattice) const = 0;
    /// A lattice for a problem that has none of the planner's kind.
    virtual Lattice layLattice(const PlanarEmbedding &embedding, double requestedCellSize) const = 0;
    virtual JumpChoice jumpChoice() const = 0;
    /// Search with one ring before the search with all?
    virtual bool searchesTwice() const { return false; }
    /// Go on to the shortest path of the plane, where that can be done?
    virtual bool isExact() const { return false; }

    /// To be called when what the functions above say has changed.
    void forgetSearch();
    JumpRule jumpRule() const { return jumpRule_; }

private:
    void declareParameters();
    void declareProgress();
    std::shared_ptr<const Occupancy> ownChart() const;
    bool isOutdated() const;
    PlanningOutcome plan(const ompl::base::PlannerTerminationCondition &ptc);
    void beginSearch();
    void note(const ompl::geometric::PathGeometric &path, ompl::base::Cost cost);
    ompl::base::PlannerStatus tell();
    void addSolution(const ompl::geometric::PathGeometric &path, bool isApproximate);

    Guidance guidance_ = Guidance::Automatic;
    JumpRule jumpRule_ = JumpRule::Safe;
    bool smoothing_ = true;
    bool approximate_ = false;
    bool direct_ = true;
    double requestedCellSize_ = 0.0;
    bool tracing_ = false;

    std::optional<Lattice> lattice_;
    std::shared_ptr<const Occupancy> chart_;      // where the problem is one of the planner's kind
    Box bounds_;                                  // of the space
    std::shared_ptr<const Occupancy> occupancy_;  // the chart within these bounds
    std::shared_ptr<ChartSearches> searches_;     // on that occupancy, kept for the next problem
    ompl::base::OptimizationObjectivePtr problemObjective_;
    ompl::base::OptimizationObjectivePtr objective_;  // the problem's or, if it has none, path length

    std::unique_ptr<EndStates> ends_;
    std::unique_ptr<AnytimeSearch> search_;
    std::unique_ptr<SearchTree> tree_;  // what getPlannerData() handed out
    std::unique_ptr<ProgressBoard> board_;

    PlanningOutcome outcome_ = PlanningOutcome::None;
    SearchCounters counters_;
    std::chrono::steady_clock::time_point begin_;  // of the last solve()
    double searchMs_ = 0.0;
    std::vector<Improvement> improvements_;
    std::vector<OffsetCoord> trace_;
};

}  // namespace seahex
