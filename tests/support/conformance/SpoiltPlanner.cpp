#include "support/conformance/SpoiltPlanner.h"

#include <ompl/base/OptimizationObjective.h>

#include <algorithm>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{

ob::PlannerStatus SpoiltPlanner::solveInstead(const ob::ProblemDefinitionPtr &other, const Condition &condition)
{
    const ob::ProblemDefinitionPtr given = pdef_;
    takeProblem(other);
    const ob::PlannerStatus status = solveWell(condition);
    takeProblem(given);
    for (const ob::PlannerSolution &solution : other->getSolutions())
        given->addSolutionPath(solution);
    return status;
}

ob::PlannerStatus SpoiltPlanner::solveAndChange(const Condition &condition,
                                                const std::function<void(ob::PlannerSolution &)> &change)
{
    const std::vector<ob::PlannerSolution> before = pdef_->getSolutions();
    const ob::PlannerStatus status = solveWell(condition);
    const std::vector<ob::PlannerSolution> after = pdef_->getSolutions();
    pdef_->clearSolutionPaths();
    for (ob::PlannerSolution solution : after)
    {
        if (std::find(before.begin(), before.end(), solution) == before.end())
            change(solution);
        if (solution.path_)
            pdef_->addSolutionPath(solution);
    }
    return status;
}

void SpoiltPlanner::addDetour(ob::PlannerSolution &solution) const
{
    const auto &path = static_cast<const og::PathGeometric &>(*solution.path_);
    auto detour = std::make_shared<og::PathGeometric>(path);
    og::PathGeometric back(path);
    back.reverse();
    detour->append(back);
    detour->append(path);
    solution.path_ = detour;
    solution.length_ = detour->length();
    const ob::Cost cost = detour->cost(solution.opt_);
    solution.setOptimized(solution.opt_, cost, solution.opt_->isSatisfied(cost));
}

}  // namespace seahex::test
