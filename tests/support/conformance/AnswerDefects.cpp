#include "support/conformance/SpoiltPlanner.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <memory>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

using Condition = SpoiltPlanner::Condition;

/// Each solution is changed.
std::function<void(SpoiltPlanner &)> change(const std::function<void(SpoiltPlanner &, ob::PlannerSolution &)> &what)
{
    return [what](SpoiltPlanner &planner)
    {
        planner.onSolve = [&planner, what](const Condition &condition)
        {
            return planner.solveAndChange(condition, [&](ob::PlannerSolution &solution) { what(planner, solution); });
        };
    };
}

double sumOfMotions(const ob::PlannerSolution &solution)
{
    const auto &path = static_cast<og::PathGeometric &>(*solution.path_);
    ob::Cost sum = solution.opt_->identityCost();
    for (unsigned int i = 1; i < path.getStateCount(); ++i)
        sum = solution.opt_->combineCosts(sum, solution.opt_->motionCost(path.getState(i - 1), path.getState(i)));
    return sum.value();
}

std::vector<Defect> pathDefects()
{
    return {
        {"a straight path, whatever is in between",
         {{"PathsBetweenRandomPlaces", "a leg touches an obstacle"},
          {"SolveClearSolveSolveAgain", "path.check() fails"}},
         change(
             [](SpoiltPlanner &planner, ob::PlannerSolution &solution)
             {
                 auto &path = static_cast<og::PathGeometric &>(*solution.path_);
                 auto straight = std::make_shared<og::PathGeometric>(planner.getSpaceInformation(), path.getState(0),
                                                                     path.getStates().back());
                 const ob::Cost cost = straight->cost(solution.opt_);
                 solution.path_ = straight;
                 solution.length_ = straight->length();
                 solution.setOptimized(solution.opt_, cost, solution.opt_->isSatisfied(cost));
             })},
        {"a straight path where there is no way",
         {{"AnUnreachableGoalIsNotReached", "an exact solution of a problem that has none"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 const ob::PlannerStatus status = planner.solveWell(condition);
                 if (status != ob::PlannerStatus::TIMEOUT || condition)
                     return status;
                 const auto &problem = planner.getProblemDefinition();
                 const auto *goal = problem->getGoal()->as<ob::GoalState>();
                 problem->addSolutionPath(std::make_shared<og::PathGeometric>(
                     planner.getSpaceInformation(), problem->getStartState(0), goal->getState()));
                 return ob::PlannerStatus(ob::PlannerStatus::EXACT_SOLUTION);
             };
         }},
        {"a path that ends short of the goal",
         {{"SolveClearSolveSolveAgain", "short of the goal"}},
         change(
             [](SpoiltPlanner &planner, ob::PlannerSolution &solution)
             {
                 auto &states = static_cast<og::PathGeometric &>(*solution.path_).getStates();
                 planner.getSpaceInformation()->freeState(states.back());
                 states.pop_back();
             })},
        {"a solution without the planner's name",
         {{"SolveClearSolveSolveAgain", "name"}},
         change([](SpoiltPlanner &, ob::PlannerSolution &solution) { solution.setPlannerName(""); })},
        {"EXACT_SOLUTION, and none is added",
         {{"SolveClearSolveSolveAgain", "the problem has none"}},
         change([](SpoiltPlanner &, ob::PlannerSolution &solution) { solution.path_.reset(); })},
        {"an approximate solution that the specs do not promise",
         {{"SolveClearSolveSolveAgain", "the specs promise none"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 planner.solveAndChange(condition, [](ob::PlannerSolution &solution) { solution.setApproximate(0.0); });
                 return ob::PlannerStatus(ob::PlannerStatus::APPROXIMATE_SOLUTION);
             };
         }},
        {"an exception",
         {{"SolveClearSolveSolveAgain", "an exception"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [](const Condition &) -> ob::PlannerStatus
             {
                 throw ompl::Exception("nothing comes to mind");
             };
         }},
        {"every planner is another",
         {{"TheSameQuestionHasTheSameAnswer", "two paths"}},
         [](SpoiltPlanner &planner)
         {
             static int made = 0;
             planner.setPoints(30 + ++made % 5);
         }},
        {"the planner's own path is handed out",
         {{"AChangedSolutionDoesNoHarm", "was spoilt"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve =
                 [&planner, own = std::make_shared<std::vector<ob::PlannerSolution>>()](const Condition &condition)
             {
                 if (own->empty())
                 {
                     const ob::PlannerStatus status = planner.solveWell(condition);
                     *own = planner.getProblemDefinition()->getSolutions();
                     return status;
                 }
                 planner.getProblemDefinition()->addSolutionPath(own->front());
                 return ob::PlannerStatus(ob::PlannerStatus::EXACT_SOLUTION);
             };
         }},
        {"the problem has a solution already, and that is enough",
         {{"TheBetterOfTwoSolutionsIsTheProblems", "was not added"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 return planner.getProblemDefinition()->hasExactSolution()
                            ? ob::PlannerStatus(ob::PlannerStatus::EXACT_SOLUTION)
                            : planner.solveWell(condition);
             };
         }},
        {"the problem is given another start",
         {{"TheProblemKeepsItsStates", "start was changed"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 const ob::PlannerStatus status = planner.solveWell(condition);
                 const auto &problem = planner.getProblemDefinition();
                 if (const auto path = std::dynamic_pointer_cast<og::PathGeometric>(problem->getSolutionPath()))
                     problem->addStartState(path->getStates().back());
                 return status;
             };
         }},
    };
}

std::vector<Defect> costDefects()
{
    return {
        {"tolls at the ends do not count",
         {{"TollsAtBothEndsCount", "of a path of cost"}},
         change([](SpoiltPlanner &, ob::PlannerSolution &solution)
                { solution.cost_ = ob::Cost(sumOfMotions(solution)); })},
        {"every cost is a length",
         {{"CostsAreTheObjectives", "of a path of cost"}},
         change([](SpoiltPlanner &, ob::PlannerSolution &solution)
                { solution.cost_ = ob::Cost(solution.path_->length()); })},
        {"the first objective is kept",
         {{"AnotherObjectiveIsNoticed", "the problem's objective"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&planner, first = ob::OptimizationObjectivePtr()](const Condition &condition) mutable
             {
                 const auto &problem = planner.getProblemDefinition();
                 if (!first)
                     first = problem->getOptimizationObjective();
                 const auto other = problem->getOptimizationObjective();
                 problem->setOptimizationObjective(first);
                 const ob::PlannerStatus status = planner.solveWell(condition);
                 problem->setOptimizationObjective(other);
                 return status;
             };
         }},
        {"an objective is written into the problem",
         {{"AProblemWithoutObjectiveStaysWithout", "wrote an objective"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSetup = [&]
             {
                 planner.TextbookPlanner::setup();
                 const auto &problem = planner.getProblemDefinition();
                 if (problem && !problem->hasOptimizationObjective())
                     problem->setOptimizationObjective(
                         std::make_shared<ob::PathLengthOptimizationObjective>(planner.getSpaceInformation()));
             };
         }},
        {"every solution is optimised",
         {{"TheThresholdDecidesWhatIsOptimised", "it can't be satisfied"},
          {"SolveClearSolveSolveAgain", "does not satisfy"}},
         change([](SpoiltPlanner &, ob::PlannerSolution &solution) { solution.optimized_ = true; })},
        {"every second call fails",
         {{"BenchmarkRuns", "solved BOOLEAN"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&planner, calls = 0](const Condition &condition) mutable
             {
                 return ++calls % 2 == 0 ? ob::PlannerStatus(ob::PlannerStatus::TIMEOUT) : planner.solveWell(condition);
             };
         }},
    };
}

}  // namespace

std::vector<Defect> answerDefects()
{
    std::vector<Defect> defects = pathDefects();
    const std::vector<Defect> more = costDefects();
    defects.insert(defects.end(), more.begin(), more.end());
    return defects;
}

}  // namespace seahex::test
