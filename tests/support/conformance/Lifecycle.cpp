#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <ompl/base/goals/GoalStates.h>

#include <algorithm>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// What may be called when, and what it means for the next solve().

void clearThrice(const ob::PlannerPtr &planner)
{
    for (int i = 0; i < 3; ++i)
        planner->clear();
}

void expectNeverWorse(Trial &trial, double cost, double known, const std::string &when)
{
    trial.expect(cost <= known || isClose(cost, known),
                 when + ": cost " + toText(cost) + ", " + toText(known) + " was known");
}

void solveClearSolveSolveAgain(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    const double first = trial.mustSolve(planner, "first solve");
    planner->clear();
    problem->clearSolutionPaths();
    const double afresh = trial.mustSolve(planner, "after clear");
    if (trial.subject().deterministic)
        trial.expect(afresh == first, "cost " + toText(first) + ", after clear " + toText(afresh));
    problem->clearSolutionPaths();
    expectNeverWorse(trial, trial.mustSolve(planner, "again"), afresh, "again");
}

void clearAtAnyTime(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner();
    clearThrice(planner);
    planner->setProblemDefinition(problem);
    clearThrice(planner);
    planner->setup();
    clearThrice(planner);
    trial.mustSolve(planner, "cleared before and after setup");
    problem->clearSolutionPaths();
    clearThrice(planner);
    trial.mustSolve(planner, "cleared three times");
}

void setupAtAnyTime(Trial &trial)
{
    const auto planner = trial.planner();
    planner->setup();
    const auto problem = trial.problem('A', 'B');
    planner->setProblemDefinition(problem);
    const double known = trial.mustSolve(planner, "setup with no problem");
    trial.expect(planner->isSetup(), "not set up after solve");
    planner->setup();
    planner->setup();
    problem->clearSolutionPaths();
    const double again = trial.mustSolve(planner, "setup twice again");
    if (trial.subject().deterministic)
        trial.expect(again == known, "another cost after setup: " + toText(again) + ", " + toText(known) + " before");
}

void solveAgainIsNeverWorse(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    double known = trial.mustSolve(planner, "first solve");
    for (int i = 0; i < 4; ++i)
    {
        problem->clearSolutionPaths();
        const double cost = trial.mustSolve(planner, "solve again, the problem's solutions forgotten");
        expectNeverWorse(trial, cost, known, "solve again");
        known = std::min(known, cost);
    }
    for (int i = 0; i < 2; ++i)
        expectNeverWorse(trial, trial.mustSolve(planner, "solve again"), known, "best of several solves");
}

/// Asks an edited problem after `forget`, which is clear() or clearQuery().
void solveAnEditedProblem(Trial &trial, const std::function<void(ob::Planner &)> &forget)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "A to B");
    problem->clearStartStates();
    problem->clearSolutionPaths();
    problem->addStartState(trial.stateAt('C'));
    problem->setGoalState(trial.stateAt('D'));
    forget(*planner);
    const double cost = trial.mustSolve(planner, "C to D, of the same problem");
    const auto fresh = trial.problem('C', 'D');
    const double expected = trial.mustSolve(trial.planner(fresh), "C to D, by another planner");
    if (trial.subject().deterministic)
        trial.expect(isClose(cost, expected), "cost " + toText(cost) + ", " + toText(expected) + " by a new planner");
}

void clearForgetsTheQuestion(Trial &trial)
{
    solveAnEditedProblem(trial, [](ob::Planner &planner) { planner.clear(); });
}

void clearQueryForgetsTheQuestion(Trial &trial)
{
    solveAnEditedProblem(trial, [](ob::Planner &planner) { planner.clearQuery(); });
}

void anotherProblem(Trial &trial, const std::function<void(ob::Planner &)> &before)
{
    const auto first = trial.problem('A', 'B');
    const auto second = trial.problem('C', 'D');
    const auto planner = trial.planner(first);
    trial.mustSolve(planner, "first problem");
    const std::size_t solutions = first->getSolutionCount();
    before(*planner);
    planner->setProblemDefinition(second);
    const double cost = trial.mustSolve(planner, "second problem");
    if (trial.subject().deterministic)
    {
        const auto fresh = trial.problem('C', 'D');
        const double expected = trial.mustSolve(trial.planner(fresh), "second problem, by another planner");
        trial.expect(isClose(cost, expected), "cost " + toText(cost) + ", " + toText(expected) + " by a new planner");
    }
    trial.expect(first->getSolutionCount() == solutions, "the first problem was given a solution of the second");
    before(*planner);
    planner->setProblemDefinition(first);
    first->clearSolutionPaths();
    trial.mustSolve(planner, "first problem, again");
}

void anotherProblemIsNoticed(Trial &trial)
{
    anotherProblem(trial, [](ob::Planner &) {});
}

void anotherProblemAfterClear(Trial &trial)
{
    anotherProblem(trial, [](ob::Planner &planner) { planner.clear(); });
}

void statesMayBeAdded(Trial &trial)
{
    const auto goals = std::make_shared<ob::GoalStates>(trial.si());
    goals->addState(trial.stateAt('B'));
    const auto problem = trial.problem("A", goals);
    const auto planner = trial.planner(problem);
    double known = trial.mustSolve(planner, "one goal");
    const auto solveWithMore = [&](const std::string &starts, const std::string &ends, const std::string &when)
    {
        problem->clearSolutionPaths();
        const double cost = trial.mustSolve(planner, when);
        expectNeverWorse(trial, cost, known, when);
        known = std::min(known, cost);
        const auto fresh = trial.problem(starts, trial.goalStates(ends));
        const double best = trial.mustSolve(trial.planner(fresh), when + ", by another planner");
        if (trial.subject().optimal && !trial.turnsMatter())
            trial.expect(isClose(cost, best), when + ": cost " + toText(cost) + " instead of " + toText(best));
    };
    goals->addState(trial.stateAt('D'));
    solveWithMore("A", "BD", "a goal added");
    problem->addStartState(trial.stateAt('C'));
    solveWithMore("AC", "BD", "a start added");
    goals->addState(trial.stateAt('C'));
    solveWithMore("AC", "BDC", "the start is a goal as well");
}

void noStateOutlivesClear(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    std::size_t alive = 0;
    for (int i = 0; i < 4; ++i)
    {
        trial.solve(planner, ob::plannerAlwaysTerminatingCondition(), "interrupted");
        trial.mustSolve(planner, "solve");
        planner->clear();
        problem->clearSolutionPaths();
        if (i == 0)
            alive = trial.statesAlive();
        trial.expect(trial.statesAlive() <= alive, std::to_string(trial.statesAlive()) + " states alive after clear, " +
                                                       std::to_string(alive) + " the first time");
    }
}

/// violationsOf() counts the states when all is over.
void freesEveryState(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    {
        const auto unused = trial.planner();
        const auto setUp = trial.planner(problem);
        setUp->setup();
        const auto interrupted = trial.planner(problem);
        trial.solve(interrupted, ob::plannerAlwaysTerminatingCondition(), "interrupted");
    }
    trial.mustSolve(trial.planner(problem), "solve");
}

}  // namespace

std::vector<PlannerCheck> lifecycleChecks()
{
    return {
        {"SolveClearSolveSolveAgain", solveClearSolveSolveAgain},
        {"ClearAtAnyTime", clearAtAnyTime},
        {"SetupAtAnyTime", setupAtAnyTime},
        {"SolveAgainIsNeverWorse", solveAgainIsNeverWorse},
        {"ClearForgetsTheQuestion", clearForgetsTheQuestion},
        {"ClearQueryForgetsTheQuestion", clearQueryForgetsTheQuestion},
        {"AnotherProblemIsNoticed", anotherProblemIsNoticed},
        {"AnotherProblemAfterClear", anotherProblemAfterClear},
        {"StatesMayBeAdded", statesMayBeAdded},
        {"NoStateOutlivesClear", noStateOutlivesClear},
        {"FreesEveryState", freesEveryState},
    };
}

}  // namespace seahex::test
