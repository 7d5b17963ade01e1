#pragma once

#include "CostHistory.h"

#include <ompl/base/Planner.h>

#include <condition_variable>
#include <mutex>
#include <string>

namespace benchmark_planners
{

/// What is done with the first path that a planner ends with, as part of its run.
enum class Finish
{
    None,
    Simplify  ///< ompl::geometric::PathSimplifier, with what is left of the time
};

/// A planner that runs another one and takes its times.
///
/// ompl::tools::Benchmark adds a thread's start to every run and looks at its time limit ten times a second. This
/// planner measures around the other's solve() itself, holds every planner to the same limit with a clock that is read
/// whenever the planner asks, and notes each better cost at the moment it is reported to the problem definition's
/// callback. Of a planner that reports none, the progress property of its best cost is read from a thread, after 1 ms
/// and then whenever the time has grown by 2 %, and at least 1 ms.
///
/// It has no progress properties itself, so Benchmark starts no thread to collect them: some of the planners' (BIT*'s
/// number of vertices) walk structures that the solver is changing, and crash (OMPL 1.5.2). The best cost is one double
/// everywhere. The final values of all of them are in the planner data.
///
/// An exception out of solve() becomes the status CRASH.
class RecordedPlanner : public ompl::base::Planner
{
public:
    RecordedPlanner(const std::string &name, ompl::base::PlannerPtr planner, Finish finish);

    /// Time limit of a run in seconds; none by default.
    void setTimeLimit(double seconds) { timeLimitS_ = seconds; }

    void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &pdef) override;
    void setup() override;
    void clear() override;
    ompl::base::PlannerStatus solve(const ompl::base::PlannerTerminationCondition &ptc) override;
    using ompl::base::Planner::solve;
    /// The final values of the other's progress properties, without its graph: to export a search tree of a million
    /// states takes longer than the search.
    void getPlannerData(ompl::base::PlannerData &data) const override;

    /// Of the last solve(): wall time, and the processor time of the whole process, in seconds.
    double wallSeconds() const { return wallSeconds_; }
    double processorSeconds() const { return processorSeconds_; }

    /// The costs of the last solve() as they were reported or read.
    const CostHistory &history() const { return history_; }

private:
    ompl::base::PlannerStatus solveAndFinish(const ompl::base::PlannerTerminationCondition &ptc);
    void simplify(const ompl::base::PlannerTerminationCondition &ptc);
    void sample();
    void note(double cost);

    ompl::base::PlannerPtr planner_;
    PlannerProgressProperty reportedCost_;  // the other's own; empty if it has none
    Finish finish_;
    double timeLimitS_;
    double beginS_ = 0.0;
    double wallSeconds_ = 0.0;
    double processorSeconds_ = 0.0;
    std::mutex mutex_;  // of what follows
    std::condition_variable ended_;
    bool isRunning_ = false;
    bool hasReported_ = false;  // to the callback
    CostHistory history_;
};

}  // namespace benchmark_planners
