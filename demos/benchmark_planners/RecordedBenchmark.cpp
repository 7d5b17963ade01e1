#include "RecordedBenchmark.h"

#include <sys/prctl.h>

namespace benchmark_planners
{
namespace
{

const char *const timeColumn = "time REAL";
const char *const costColumn = "best cost REAL";

}  // namespace

RecordedBenchmark::RecordedBenchmark(ompl::geometric::SimpleSetup &setup, const std::string &name, RunJudge judge)
    : ompl::tools::Benchmark(setup, name), judge_(judge)
{
    setPlannerSwitchEvent(
        [this](const ompl::base::PlannerPtr &planner)
        {
            improvements_.emplace_back();
            prctl(PR_SET_NAME, planner->getName().c_str());  // ps and top then show who is at work
        });
    setPostRunEvent([this](const ompl::base::PlannerPtr &planner, RunProperties &run)
                    { recordRun(static_cast<const RecordedPlanner &>(*planner), run); });
}

void RecordedBenchmark::benchmark(const Request &request)
{
    improvements_.clear();
    ompl::tools::Benchmark::benchmark(request);
    for (std::size_t i = 0; i < improvements_.size(); ++i)
    {
        PlannerExperiment &planner = exp_.planners[i];
        planner.progressPropertyNames = {costColumn, timeColumn};
        planner.runsProgressData.clear();
        for (const std::vector<TimedCost> &run : improvements_[i])
        {
            RunProgressData rows;
            for (const TimedCost &better : run)
                rows.push_back({{timeColumn, logNumber(better.seconds)}, {costColumn, logNumber(better.cost)}});
            planner.runsProgressData.push_back(rows);
        }
    }
}

void RecordedBenchmark::recordRun(const RecordedPlanner &planner, RunProperties &run)
{
    run.erase("graph states INTEGER");  // RecordedPlanner exports none
    run.erase("graph motions INTEGER");
    run["run INTEGER"] = std::to_string(improvements_.back().size() + 1);
    run["solve time REAL"] = logNumber(planner.wallSeconds());
    run["processor time REAL"] = logNumber(planner.processorSeconds());
    std::vector<TimedCost> improvements;
    if (const std::optional<double> cost = judge_.judge(run))
    {
        CostHistory history = planner.history();
        history.finish(planner.wallSeconds(), *cost);
        improvements = history.improvements();
        run["time to first solution REAL"] = logNumber(improvements.front().seconds);
    }
    improvements_.back().push_back(improvements);
}

}  // namespace benchmark_planners
