#pragma once

#include <benchmark_planners/CostHistory.h>

#include <map>
#include <string>
#include <vector>

namespace seahex::contest
{

/// The moments at which curves are compared: ten a decade from 0.1 ms to a limit in seconds, both included.
std::vector<double> timeGrid(double limitS);

/// One run of one planner for one query.
struct PlannerRun
{
    std::size_t query = 0;
    std::string planner;
    std::vector<benchmark_planners::TimedCost> improvements;  ///< in the order of time, falling
};

/// How good the planners are at each moment: for each of them the median over its runs of the best cost so far, as a
/// ratio to the best that any run ever found for the same query. A run with no path yet counts as infinite.
std::map<std::string, std::vector<double>> medianCurves(const std::vector<PlannerRun> &runs,
                                                        const std::vector<double> &moments);

/// Median time in seconds until a run's cost was within a ratio of the best known for its query; infinite where more
/// than half never got there. With an infinite ratio the time of the first path.
double medianTimeTo(const std::vector<PlannerRun> &runs, const std::string &planner, double ratio);

/// At how many moments one of the other curves lies below that of `ours`, by more than rounding.
std::size_t momentsBehind(const std::map<std::string, std::vector<double>> &curves, const std::string &ours);

}  // namespace seahex::contest
