#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <ompl/base/goals/GoalStates.h>
#include <ompl/util/Exception.h>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// What solve() answers where the problem is at fault.

/// A goal that can be recognised and not sampled.
class Recognised : public ob::Goal
{
public:
    using ob::Goal::Goal;
    bool isSatisfied(const ob::State *) const override { return false; }
};

void expectStatus(Trial &trial, const ob::ProblemDefinitionPtr &problem, ob::PlannerStatus::StatusType expected,
                  const std::string &what)
{
    const auto planner = trial.planner(problem);
    for (const char *when : {"", ", asked again"})
    {
        const ob::PlannerStatus status = trial.mustNotSolve(planner, what + when);
        trial.expect(status == expected, what + when + ": " + nameOf(status));
    }
    trial.expect(!problem->hasSolution(), what + ": the problem has a solution");
}

void anIncompleteProblemIsAnException(Trial &trial)
{
    const auto refuses = [&](const ob::ProblemDefinitionPtr &problem, const std::string &what)
    {
        const auto planner = trial.planner();
        if (problem)
            planner->setProblemDefinition(problem);
        try
        {
            planner->solve(ob::plannerAlwaysTerminatingCondition());
            trial.expect(false, what + ": no ompl::Exception");
        }
        catch (const ompl::Exception &)
        {
        }
    };
    refuses(nullptr, "no problem");
    const auto problem = std::make_shared<ob::ProblemDefinition>(trial.si());
    refuses(problem, "neither start nor goal");
    problem->addStartState(trial.stateAt('A'));
    refuses(problem, "no goal");
    problem->clearStartStates();
    problem->setGoalState(trial.stateAt('B'));
    refuses(problem, "no start");
}

void anIncompleteProblemMayBeCompleted(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    problem->clearStartStates();
    const auto planner = trial.planner(problem);
    try
    {
        planner->solve(ob::plannerAlwaysTerminatingCondition());
    }
    catch (const ompl::Exception &)
    {
    }
    problem->addStartState(trial.stateAt('A'));
    trial.mustSolve(planner, "completed");
}

void anInvalidStartIsTold(Trial &trial)
{
    for (const char bad : {'X', 'O'})
        if (trial.arena().has(bad))
            expectStatus(trial, trial.problem(bad, 'B'), ob::PlannerStatus::INVALID_START,
                         bad == 'X' ? "start on an obstacle" : "start out of bounds");
}

void noValidStartOfSeveralIsTold(Trial &trial)
{
    const std::string starts = trial.arena().has('X') ? "XOX" : "OO";
    expectStatus(trial, trial.problem(starts, trial.goalStates("B")), ob::PlannerStatus::INVALID_START,
                 "several invalid starts");
}

void oneValidStartIsEnough(Trial &trial)
{
    const std::string starts = trial.arena().has('X') ? "XAO" : "OA";
    trial.mustSolve(trial.planner(trial.problem(starts, trial.goalStates("B"))), "one valid start");
}

void anInvalidGoalIsTold(Trial &trial)
{
    for (const char bad : {'X', 'O'})
        if (trial.arena().has(bad))
            expectStatus(trial, trial.problem('A', bad), ob::PlannerStatus::INVALID_GOAL,
                         bad == 'X' ? "goal on an obstacle" : "goal out of bounds");
}

void noValidGoalOfSeveralIsTold(Trial &trial)
{
    const std::string goals = trial.arena().has('X') ? "XOX" : "OO";
    expectStatus(trial, trial.problem("A", trial.goalStates(goals)), ob::PlannerStatus::INVALID_GOAL,
                 "several invalid goals");
}

void anUnknownGoalTypeIsTold(Trial &trial)
{
    if (trial.planner()->getSpecs().recognizedGoal != ob::GOAL_ANY)
        expectStatus(trial, trial.problem("A", std::make_shared<Recognised>(trial.si())),
                     ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE, "a goal that can't be sampled");
}

void aStartThatIsTheGoal(Trial &trial)
{
    for (const char place : {'A', 'C'})
    {
        const auto problem = trial.problem(place, place);
        const double cost = trial.mustSolve(trial.planner(problem), "start is goal");
        trial.expect(cost == 0.0, "start is goal: cost " + toText(cost));
        const auto path = bestPath(problem);
        trial.expect(!path || path->getStateCount() <= 2, "start is goal: a path of more than two states");
    }
}

void anUnreachableGoalIsNotReached(Trial &trial)
{
    if (!trial.arena().has('E'))
        return;
    const std::vector<std::string> pairs = {"AE", "EA"};
    for (const std::string &pair : pairs)
    {
        const auto problem = trial.problem(pair[0], pair[1]);
        const auto planner = trial.planner(problem);
        for (int i = 0; i < 2; ++i)
        {
            const ob::PlannerStatus::StatusType status = trial.mustNotSolve(planner, "unreachable goal");
            trial.expect(status == ob::PlannerStatus::TIMEOUT || status == ob::PlannerStatus::APPROXIMATE_SOLUTION,
                         "unreachable goal: " + nameOf(status));
            if (trial.subject().finishes)
                trial.expect((status == ob::PlannerStatus::APPROXIMATE_SOLUTION) ==
                                 planner->getSpecs().approximateSolutions,
                             "unreachable goal: " + nameOf(status) + " is not what the specs say");
        }
        trial.expect(!problem->hasExactSolution(), "unreachable goal: the problem has an exact solution");
    }
}

void anUnreachableGoalIsNoMatterToOthers(Trial &trial)
{
    if (!trial.arena().has('E'))
        return;
    trial.mustSolve(trial.planner(trial.problem("EA", trial.goalStates("B"))), "one start of two is cut off");
    trial.mustSolve(trial.planner(trial.problem("A", trial.goalStates("EB"))), "one goal of two is cut off");
}

void anUnreachableGoalIsNotTheLastWord(Trial &trial)
{
    if (!trial.arena().has('E'))
        return;
    const auto goals = std::make_shared<ob::GoalStates>(trial.si());
    goals->addState(trial.stateAt('E'));
    const auto planner = trial.planner(trial.problem("A", goals));
    trial.mustNotSolve(planner, "unreachable goal");
    goals->addState(trial.stateAt('B'));
    trial.mustSolve(planner, "another goal was added");
}

}  // namespace

std::vector<PlannerCheck> statusChecks()
{
    return {
        {"AnIncompleteProblemIsAnException", anIncompleteProblemIsAnException},
        {"AnIncompleteProblemMayBeCompleted", anIncompleteProblemMayBeCompleted},
        {"AnInvalidStartIsTold", anInvalidStartIsTold},
        {"NoValidStartOfSeveralIsTold", noValidStartOfSeveralIsTold},
        {"OneValidStartIsEnough", oneValidStartIsEnough},
        {"AnInvalidGoalIsTold", anInvalidGoalIsTold},
        {"NoValidGoalOfSeveralIsTold", noValidGoalOfSeveralIsTold},
        {"AnUnknownGoalTypeIsTold", anUnknownGoalTypeIsTold},
        {"AStartThatIsTheGoal", aStartThatIsTheGoal},
        {"AnUnreachableGoalIsNotReached", anUnreachableGoalIsNotReached},
        {"AnUnreachableGoalIsNoMatterToOthers", anUnreachableGoalIsNoMatterToOthers},
        {"AnUnreachableGoalIsNotTheLastWord", anUnreachableGoalIsNotTheLastWord},
    };
}

}  // namespace seahex::test
