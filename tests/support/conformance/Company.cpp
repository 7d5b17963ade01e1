#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <ompl/tools/benchmark/Benchmark.h>

#include <atomic>
#include <sstream>
#include <thread>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

// The planner among others: twice on one space in two threads, and in tools::Benchmark.

/// 40 repeats an arena, half of them a thread, each by a planner of its own or by one that is cleared.
void twoThreads(Trial &trial)
{
    const auto alone = trial.problem('A', 'B');
    const double there = trial.mustSolve(trial.planner(alone), "alone");
    const auto other = trial.problem('C', 'A');
    const double elsewhere = trial.mustSolve(trial.planner(other), "alone");
    std::atomic<int> wrong{0};
    const auto work = [&](char start, char goal, double expected)
    {
        const auto problem = trial.problem(start, goal);
        auto planner = trial.planner(problem);
        for (int i = 0; i < 20; ++i)
        {
            if (i % 2 == 0)
                planner = trial.planner(problem);
            planner->clear();
            problem->clearSolutionPaths();
            const bool solved =
                planner->solve(ob::timedPlannerTerminationCondition(10.0)) == ob::PlannerStatus::EXACT_SOLUTION;
            const bool good = solved && bestPath(problem)->check();
            if (!good || (trial.subject().deterministic && bestCost(problem) != expected))
                ++wrong;
        }
    };
    std::thread one([&] { work('A', 'B', there); });
    std::thread two([&] { work('C', 'A', elsewhere); });
    one.join();
    two.join();
    trial.expect(wrong == 0, std::to_string(wrong) + " of 40 solves in two threads are not what they are alone");
}

void benchmarkRuns(Trial &trial)
{
    constexpr unsigned int runs = 3;
    og::SimpleSetup setup(trial.si());
    const auto problem = trial.problem('A', 'B');
    setup.setStartAndGoalStates(trial.stateAt('A'), trial.stateAt('B'));
    setup.setOptimizationObjective(problem->getOptimizationObjective());
    setup.setPlanner(trial.planner());
    ompl::tools::Benchmark benchmark(setup, "conformance");
    benchmark.addPlanner(trial.planner());
    benchmark.benchmark(ompl::tools::Benchmark::Request(5.0, 4096.0, runs, 0.01, false, false, false));

    std::ostringstream log;
    benchmark.saveResultsToStream(log);
    trial.expect(log.str().find("DID NOT PASS") == std::string::npos, "a sanity check DID NOT PASS");
    const auto &results = benchmark.getRecordedExperimentData().planners;
    if (!trial.expect(results.size() == 1 && results[0].runs.size() == runs, "not every run was recorded"))
        return;
    for (const auto &run : results[0].runs)
    {
        std::vector<std::string> truths = {"solved BOOLEAN", "correct solution BOOLEAN"};
        if (trial.arena().chart)  // where motions are exact; OMPL's validator may find more when it looks closer
            truths.emplace_back("correct solution strict BOOLEAN");
        for (const std::string &name : truths)
            trial.expect(run.count(name) == 1 && run.at(name) == "1", "not so in a run: " + name);
        for (const std::string &name : trial.subject().progress)
            trial.expect(run.count(name) == 1, "a run has no " + inQuotes(name));
        if (trial.subject().deterministic)
            trial.expect(run.count("solution length REAL") == 1 &&
                             run.at("solution length REAL") == results[0].runs[0].at("solution length REAL"),
                         "runs differ in length");
    }
}

}  // namespace

std::vector<PlannerCheck> companyChecks()
{
    return {
        {"TwoThreads", twoThreads},
        {"BenchmarkRuns", benchmarkRuns},
    };
}

}  // namespace seahex::test
