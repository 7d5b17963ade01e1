#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <ompl/base/terminationconditions/CostConvergenceTerminationCondition.h>

#include <algorithm>
#include <memory>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

// The callback for intermediate solutions: costs that fall, and the path behind each of them.

struct Report
{
    const ob::Planner *planner;
    ob::Cost cost;
    std::shared_ptr<og::PathGeometric> path;
};

/// Notes what is reported from now on. The states are the planner's, so they are copied.
std::shared_ptr<std::vector<Report>> listenTo(const Trial &trial, const ob::ProblemDefinitionPtr &problem)
{
    auto reports = std::make_shared<std::vector<Report>>();
    problem->setIntermediateSolutionCallback(
        [reports, si = trial.si()](const ob::Planner *planner, const std::vector<const ob::State *> &states,
                                   const ob::Cost cost)
        {
            auto path = std::make_shared<og::PathGeometric>(si);
            for (const ob::State *state : states)
                path->append(state);
            reports->push_back({planner, cost, path});
        });
    return reports;
}

void expectFallingCosts(Trial &trial, const std::vector<Report> &reports, const std::string &when)
{
    for (std::size_t i = 1; i < reports.size(); ++i)
        trial.expect(reports[i].cost.value() < reports[i - 1].cost.value(),
                     when + ": " + toText(reports[i].cost.value()) + " was reported after " +
                         toText(reports[i - 1].cost.value()));
}

void costsFallToTheSolutions(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto reports = listenTo(trial, problem);
    const auto planner = trial.planner(problem);
    const double cost = trial.mustSolve(planner, "solve");
    if (!planner->getSpecs().canReportIntermediateSolutions)
    {
        trial.expect(reports->empty(), "solutions are reported, and the specs promise none");
        return;
    }
    if (!trial.expect(!reports->empty(), "no solution was reported, and the specs promise it"))
        return;
    expectFallingCosts(trial, *reports, "solve");
    trial.expect(isClose(reports->back().cost.value(), cost), "the last report is not the solution's cost");
    for (const Report &report : *reports)
        trial.expect(report.planner == planner.get(), "a report of another planner's");

    planner->clear();
    problem->clearSolutionPaths();
    const std::size_t before = reports->size();
    trial.mustSolve(planner, "after clear");
    trial.expect(reports->size() > before, "nothing was reported after clear");
}

void reportsArePathsFromStartToGoal(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto reports = listenTo(trial, problem);
    trial.mustSolve(trial.planner(problem), "solve");
    for (const Report &report : *reports)
    {
        const auto &states = report.path->getStates();
        if (!trial.judgePath(*report.path, "a report"))
            continue;
        trial.expect(trial.si()->equalStates(states.front(), problem->getStartState(0)),
                     "a report does not begin at the start");
        trial.expect(problem->getGoal()->isSatisfied(states.back()), "a report does not end at the goal");
        const double cost = report.path->cost(problem->getOptimizationObjective()).value();
        trial.expect(isClose(report.cost.value(), cost),
                     "a cost of " + toText(report.cost.value()) + " was reported for a path of " + toText(cost));
    }
}

void aReportMayEndTheSearch(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    const auto condition = trial.condition([](int) { return false; });
    double reported = 0.0;
    int reports = 0;
    problem->setIntermediateSolutionCallback(
        [&](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost)
        {
            ++reports;
            reported = cost.value();
            condition.terminate();
        });
    const ob::PlannerStatus status = trial.solve(planner, condition, "ended by a report");
    trial.expect(status == ob::PlannerStatus::EXACT_SOLUTION, "ended by a report: " + nameOf(status));
    if (reports > 0)
        trial.expect(isClose(reported, bestCost(problem)), "ended by a report: the solution is not the one reported");
    const double known = bestCost(problem);
    const double cost = trial.mustSolve(planner, "after a report ended it");
    trial.expect(cost <= known || isClose(cost, known), "after a report ended it: worse");
}

void costConvergenceIsACondition(Trial &trial)
{
    auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    const ob::CostConvergenceTerminationCondition converged(problem, 1, 0.9);
    const auto both = ob::plannerOrTerminationCondition(converged, trial.patience());
    const ob::PlannerStatus status = trial.solve(planner, both, "until the cost has converged");
    trial.expect(status == ob::PlannerStatus::EXACT_SOLUTION, "until the cost has converged: " + nameOf(status));
}

/// A planner that goes on where it was has nothing to report until there is something better.
void whatIsKnownIsNotReportedAgain(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto reports = listenTo(trial, problem);
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "solve");
    problem->clearSolutionPaths();
    trial.mustSolve(planner, "again");
    expectFallingCosts(trial, *reports, "solve and solve again");
}

}  // namespace

std::vector<PlannerCheck> improvementChecks()
{
    return {
        {"CostsFallToTheSolutions", costsFallToTheSolutions},
        {"ReportsArePathsFromStartToGoal", reportsArePathsFromStartToGoal},
        {"AReportMayEndTheSearch", aReportMayEndTheSearch},
        {"CostConvergenceIsACondition", costConvergenceIsACondition},
        {"WhatIsKnownIsNotReportedAgain", whatIsKnownIsNotReportedAgain},
    };
}

}  // namespace seahex::test
