#include "RunJudge.h"

namespace og = ompl::geometric;

namespace benchmark_planners
{

std::optional<double> RunJudge::judge(ompl::tools::Benchmark::RunProperties &run) const
{
    if (!setup_.haveExactSolutionPath())
        return std::nullopt;
    const og::PathGeometric &path = setup_.getSolutionPath();
    const bool valid = isWhole(path) && world_.isSafe(path, run) && path.check();
    run["valid BOOLEAN"] = valid ? "1" : "0";
    if (!valid)
        return std::nullopt;
    return world_.measure(path, run);
}

bool RunJudge::isWhole(const og::PathGeometric &path) const
{
    const auto &problem = setup_.getProblemDefinition();
    return path.getStateCount() >= 2 &&
           setup_.getSpaceInformation()->equalStates(path.getState(0), problem->getStartState(0)) &&
           problem->getGoal()->isSatisfied(path.getState(path.getStateCount() - 1));
}

}  // namespace benchmark_planners
