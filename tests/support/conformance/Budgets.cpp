#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <ompl/base/terminationconditions/IterationTerminationCondition.h>

#include <thread>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// Termination conditions: looked at often, obeyed at once, and no reason to lose what was done. What happens in
// between is counted, not timed.

/// Interrupted before there is anything to tell. A path of a single leg may be known at once.
void expectNothingYet(Trial &trial, const ob::PlannerPtr &planner, const ob::PlannerStatus &status,
                      const std::string &when)
{
    const auto path = bestPath(planner->getProblemDefinition());
    if (status != ob::PlannerStatus::APPROXIMATE_SOLUTION && (!path || path->getStateCount() > 2))
        trial.expect(status == ob::PlannerStatus::TIMEOUT, when + ": " + nameOf(status));
}

void expectPromptness(Trial &trial, int questions, const std::string &when)
{
    trial.expect(questions <= trial.subject().questionsBetweenLooks,
                 when + ": " + std::to_string(questions) + " states asked for, at most " +
                     std::to_string(trial.subject().questionsBetweenLooks) + " are promised");
}

void anOverdueConditionIsObeyed(Trial &trial)
{
    const auto planner = trial.planner(trial.problem('A', 'B'));
    for (int i = 0; i < 3; ++i)
    {
        const auto overdue = trial.condition([](int) { return true; });
        expectNothingYet(trial, planner, trial.solve(planner, overdue, "no time at all"), "no time at all");
        expectPromptness(trial, trial.observed().questions, "no time at all");
    }
    expectNothingYet(trial, planner,
                     trial.solve(planner, ob::plannerAlwaysTerminatingCondition(), "always terminating"),
                     "always terminating");
    trial.mustSolve(planner, "after no time at all");
}

void whatIsKnownIsToldInNoTime(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    const double known = trial.mustSolve(planner, "solve");
    problem->clearSolutionPaths();
    const ob::PlannerStatus status = trial.solve(planner, ob::plannerAlwaysTerminatingCondition(), "asked again");
    trial.expect(status == ob::PlannerStatus::EXACT_SOLUTION, "asked again with no time: " + nameOf(status));
    trial.expect(bestCost(problem) <= known || isClose(bestCost(problem), known), "asked again with no time: worse");
}

void tinyBudgets(Trial &trial)
{
    for (const double seconds : {-1.0, 0.0, 1e-6, 1e-5, 1e-4, 1e-3})
    {
        const std::string when = "a budget of " + toText(seconds) + " s";
        const auto planner = trial.planner(trial.problem('A', 'B'));
        const ob::PlannerStatus status = trial.solve(planner, ob::timedPlannerTerminationCondition(seconds), when);
        if (status != ob::PlannerStatus::EXACT_SOLUTION)
            expectNothingYet(trial, planner, status, when);
        trial.mustSolve(planner, "after " + when);
    }
}

void theConditionIsLookedAtOften(Trial &trial)
{
    trial.mustSolve(trial.planner(trial.problem('A', 'B')), "solve");
    trial.expect(trial.observed().looks > 0, "the condition was never looked at");
    expectPromptness(trial, trial.observed().mostBetween, "between two looks");
    if (!trial.arena().has('E'))
        return;
    trial.mustNotSolve(trial.planner(trial.problem('A', 'E')), "unreachable goal");
    expectPromptness(trial, trial.observed().mostBetween, "between two looks, no path");
}

/// The condition is terminated from another thread while the planner asks its nth question, or looks for the nth time.
void terminatingFromAnotherThread(Trial &trial)
{
    Observed &observed = trial.observed();
    for (const int moment : {1, 40, 300})
    {
        const std::string when = "terminated from another thread";
        const auto planner = trial.planner(trial.problem('A', 'B'));
        const ob::PlannerTerminationCondition *terminated = nullptr;
        const auto terminate = [&]
        {
            std::thread([&] { terminated->terminate(); }).join();
            observed.ended = true;
        };
        const auto condition = trial.condition(
            [&](int look)
            {
                if (trial.arena().chart && look == moment)
                    terminate();
                return false;
            });
        terminated = &condition;
        observed.onQuestion = [&](int question)
        {
            if (question == moment)
                terminate();
        };
        const ob::PlannerStatus status = trial.solve(planner, condition, when);
        observed.onQuestion = nullptr;
        if (observed.ended && status != ob::PlannerStatus::EXACT_SOLUTION)
            expectNothingYet(trial, planner, status, when);
        expectPromptness(trial, observed.afterTheEnd, when);
        trial.mustSolve(planner, "after it was " + when);
    }
}

void aNumberOfIterations(Trial &trial)
{
    for (const unsigned int iterations : {1u, 2u, 5u, 30u, 200u})
    {
        const auto planner = trial.planner(trial.problem('A', 'B'));
        ob::IterationTerminationCondition condition(iterations);
        const std::string when = std::to_string(iterations) + " iterations";
        const ob::PlannerStatus status = trial.solve(planner, condition, when);
        if (status != ob::PlannerStatus::EXACT_SOLUTION)
        {
            expectNothingYet(trial, planner, status, when);
            trial.expect(condition.getTimesCalled() >= iterations, when + ": gave up before");
        }
        trial.mustSolve(planner, "after " + when);
    }
}

void slicesOfTimeAddUp(Trial &trial)
{
    const auto whole = trial.problem('A', 'B');
    const double expected = trial.mustSolve(trial.planner(whole), "at once");
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    for (int calls = 1;; ++calls)
    {
        if (!trial.expect(calls < 2000, "2000 calls of three looks each, and no end"))
            return;
        const auto three = trial.condition([](int look) { return look > 3; });
        const ob::PlannerStatus status = trial.solve(planner, three, "a slice of time");
        if (status == ob::PlannerStatus::EXACT_SOLUTION && (!trial.subject().finishes || !trial.observed().ended))
            break;
    }
    const bool isAsGood = isClose(bestCost(problem), expected) || bestCost(problem) < expected;
    if (trial.subject().deterministic)
        trial.expect(trial.subject().optimal ? isClose(bestCost(problem), expected) : isAsGood,
                     "cost " + toText(bestCost(problem)) + " in slices, " + toText(expected) + " at once");
}

}  // namespace

std::vector<PlannerCheck> budgetChecks()
{
    return {
        {"AnOverdueConditionIsObeyed", anOverdueConditionIsObeyed},
        {"WhatIsKnownIsToldInNoTime", whatIsKnownIsToldInNoTime},
        {"TinyBudgets", tinyBudgets},
        {"TheConditionIsLookedAtOften", theConditionIsLookedAtOften},
        {"TerminatingFromAnotherThread", terminatingFromAnotherThread},
        {"ANumberOfIterations", aNumberOfIterations},
        {"SlicesOfTimeAddUp", slicesOfTimeAddUp},
    };
}

}  // namespace seahex::test
