#pragma once

#include "RecordedPlanner.h"
#include "RunJudge.h"

#include <ompl/tools/benchmark/Benchmark.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace benchmark_planners
{

/// ompl::tools::Benchmark with RunJudge's properties, and with progress data that say exactly when each run's solution
/// became better: one row an improvement, as RecordedPlanner noted it, the last one with the cost of the path that the
/// run ended with. A run whose path is not valid has no rows.
class RecordedBenchmark : public ompl::tools::Benchmark
{
public:
    RecordedBenchmark(ompl::geometric::SimpleSetup &setup, const std::string &name, RunJudge judge);

    void add(const std::shared_ptr<RecordedPlanner> &planner) { addPlanner(planner); }
    void benchmark(const Request &request) override;

private:
    void recordRun(const RecordedPlanner &planner, RunProperties &run);

    RunJudge judge_;
    std::vector<std::vector<std::vector<TimedCost>>> improvements_;  // of each planner in each run
};

}  // namespace benchmark_planners
