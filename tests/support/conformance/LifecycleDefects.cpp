#include "support/conformance/SpoiltPlanner.h"

#include <ompl/base/goals/GoalLazySamples.h>
#include <ompl/base/goals/GoalState.h>

#include <memory>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

using Condition = SpoiltPlanner::Condition;

const ob::PlannerStatus timeout = ob::PlannerStatus::TIMEOUT;

/// A problem's clone with its first start and its first goal.
ob::ProblemDefinitionPtr firstPair(const ob::ProblemDefinition &problem)
{
    ob::ProblemDefinitionPtr first = problem.clone();
    while (first->getStartStateCount() > 1)
    {
        const ob::ScopedState<> start(problem.getSpaceInformation()->getStateSpace(), problem.getStartState(0));
        first->clearStartStates();
        first->addStartState(start);
    }
    if (const auto *goals = dynamic_cast<const ob::GoalStates *>(problem.getGoal().get()))
        first->setGoalState(goals->getState(0));
    return first;
}

/// Says that something else is wrong than is.
void mistake(SpoiltPlanner &planner, ob::PlannerStatus::StatusType status, ob::PlannerStatus::StatusType forOther)
{
    planner.onSolve = [&planner, status, forOther](const Condition &condition)
    {
        const ob::PlannerStatus::StatusType answer = planner.solveWell(condition);
        return ob::PlannerStatus(answer == forOther ? status : answer);
    };
}

std::vector<Defect> memoryDefects()
{
    return {
        {"clear() does nothing",
         {{"ClearForgetsTheQuestion", "does not begin at a start"}},
         [](SpoiltPlanner &planner)
         {
             planner.onClear = [] {
             };
         }},
        {"clear() does nothing, nor is another problem noticed",
         {{"AnotherProblemAfterClear", "second problem"}, {"AnotherProblemIsNoticed", "second problem"}},
         [](SpoiltPlanner &planner)
         {
             planner.onClear = [] {
             };
             planner.onProblem = [&](const auto &problem)
             {
                 planner.takeProblem(problem);
             };
         }},
        {"clearQuery() does nothing",
         {{"ClearQueryForgetsTheQuestion", "does not begin at a start"}},
         [](SpoiltPlanner &planner)
         {
             planner.onClearQuery = [] {
             };
         }},
        {"clear() wants a problem",
         {{"ClearAtAnyTime", "an exception"}},
         [](SpoiltPlanner &planner)
         {
             planner.onClear = [&]
             {
                 if (!planner.getProblemDefinition())
                     throw ompl::Exception("no problem to be cleared");
                 planner.TextbookPlanner::clear();
             };
         }},
        {"setup() wants a problem",
         {{"SetupAtAnyTime", "an exception"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSetup = [&]
             {
                 if (!planner.getProblemDefinition())
                     throw ompl::Exception("no problem to be set up");
                 planner.TextbookPlanner::setup();
             };
         }},
        {"a later answer is worse",
         {{"SolveClearSolveSolveAgain", "after clear"},
          {"SolveAgainIsNeverWorse", "was known"},
          {"WhatIsKnownIsToldInNoTime", "worse"},
          {"AChangedSolutionDoesNoHarm", "was simplified: cost"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&planner, solves = 0](const Condition &condition) mutable
             {
                 const bool isLater = ++solves > 1;
                 return planner.solveAndChange(condition,
                                               [&](ob::PlannerSolution &solution)
                                               {
                                                   if (isLater)
                                                       planner.addDetour(solution);
                                               });
             };
         }},
        {"the first answer is told for good",
         {{"StatesMayBeAdded", "instead of"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve =
                 [&planner, known = std::make_shared<std::vector<ob::PlannerSolution>>()](const Condition &condition)
             {
                 if (known->empty())
                 {
                     const ob::PlannerStatus status = planner.solveWell(condition);
                     *known = planner.getProblemDefinition()->getSolutions();
                     return status;
                 }
                 planner.getProblemDefinition()->addSolutionPath(known->front());
                 return ob::PlannerStatus(ob::PlannerStatus::EXACT_SOLUTION);
             };
         }},
        {"states pile up until the end",
         {{"NoStateOutlivesClear", "states alive after clear"}},
         [](SpoiltPlanner &planner)
         {
             const auto states = std::make_shared<std::vector<ob::State *>>();
             planner.onSolve = [&planner, states](const Condition &condition)
             {
                 states->push_back(planner.getSpaceInformation()->allocState());
                 return planner.solveWell(condition);
             };
             planner.onDeath = [&planner, states]
             {
                 planner.getSpaceInformation()->freeStates(*states);
             };
         }},
        {"a state is kept for good",
         {{"FreesEveryState", "states are left"}, {"BenchmarkRuns", "states are left"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 static auto *const kept = new std::vector<ob::State *>;  // never freed, never lost: no sanitizer minds
                 kept->push_back(planner.getSpaceInformation()->allocState());
                 return planner.solveWell(condition);
             };
         }},
    };
}

std::vector<Defect> statusDefects()
{
    return {
        {"no answer is no answer for good",
         {{"AnUnreachableGoalIsNotTheLastWord", "another goal was added: Timeout"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&planner, isInVain = false](const Condition &condition) mutable
             {
                 const ob::PlannerStatus status = isInVain ? timeout : planner.solveWell(condition);
                 isInVain = status == ob::PlannerStatus::TIMEOUT;
                 return status;
             };
         }},
        {"an incomplete problem is a status",
         {{"AnIncompleteProblemIsAnException", "no ompl::Exception"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 const auto &problem = planner.getProblemDefinition();
                 const bool isWhole = problem && problem->getGoal() && problem->getStartStateCount() > 0;
                 return isWhole ? planner.solveWell(condition) : ob::PlannerStatus(ob::PlannerStatus::INVALID_START);
             };
         }},
        {"an incomplete problem is never forgiven",
         {{"AnIncompleteProblemMayBeCompleted", "an exception"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&planner, isBad = false](const Condition &condition) mutable
             {
                 isBad = isBad || planner.getProblemDefinition()->getStartStateCount() == 0;
                 if (isBad)
                     throw ompl::Exception("the problem was incomplete");
                 return planner.solveWell(condition);
             };
         }},
        {"TIMEOUT for an invalid start",
         {{"AnInvalidStartIsTold", "Timeout"}, {"NoValidStartOfSeveralIsTold", "Timeout"}},
         [](SpoiltPlanner &planner)
         {
             mistake(planner, ob::PlannerStatus::TIMEOUT, ob::PlannerStatus::INVALID_START);
         }},
        {"TIMEOUT for an invalid goal",
         {{"AnInvalidGoalIsTold", "Timeout"}, {"NoValidGoalOfSeveralIsTold", "Timeout"}},
         [](SpoiltPlanner &planner)
         {
             mistake(planner, ob::PlannerStatus::TIMEOUT, ob::PlannerStatus::INVALID_GOAL);
         }},
        {"INVALID_GOAL for an unknown goal type",
         {{"AnUnknownGoalTypeIsTold", "Invalid goal"}},
         [](SpoiltPlanner &planner)
         {
             mistake(planner, ob::PlannerStatus::INVALID_GOAL, ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE);
         }},
        {"INVALID_START for a good one",
         {{"SolveClearSolveSolveAgain", "Invalid start instead of"}, {"TinyBudgets", "Invalid start"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [](const Condition &)
             {
                 return ob::PlannerStatus(ob::PlannerStatus::INVALID_START);
             };
         }},
        {"INVALID_GOAL where there is no way, or no time",
         {{"AnUnreachableGoalIsNotReached", "Invalid goal"},
          {"AnOverdueConditionIsObeyed", "Invalid goal"},
          {"TinyBudgets", "Invalid goal"}},
         [](SpoiltPlanner &planner)
         {
             mistake(planner, ob::PlannerStatus::INVALID_GOAL, ob::PlannerStatus::TIMEOUT);
         }},
        {"no answer where the start is the goal",
         {{"AStartThatIsTheGoal", "start is goal: Timeout"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 const auto &problem = planner.getProblemDefinition();
                 return problem->getGoal()->isSatisfied(problem->getStartState(0)) ? timeout
                                                                                   : planner.solveWell(condition);
             };
         }},
        {"one start and one goal only",
         {{"OneValidStartIsEnough", "Invalid start"},
          {"AnUnreachableGoalIsNoMatterToOthers", "is cut off"},
          {"TheBestPairOfStatesWins", "the best pair's"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 return planner.solveInstead(firstPair(*planner.getProblemDefinition()), condition);
             };
         }},
        {"goals that are no states are not waited for",
         {{"ARegionWithNoEndOfSamples", "Abort"},
          {"AGoalThatTurnsUpLate", "Abort"},
          {"AGoalThatNeverTurnsUp", "Abort"},
          {"WaitingForAGoalHasAnEnd", "Abort"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 const ob::Goal *goal = planner.getProblemDefinition()->getGoal().get();
                 const bool isEasy = dynamic_cast<const ob::GoalState *>(goal) != nullptr ||
                                     (dynamic_cast<const ob::GoalStates *>(goal) != nullptr &&
                                      dynamic_cast<const ob::GoalLazySamples *>(goal) == nullptr);
                 return isEasy ? planner.solveWell(condition) : ob::PlannerStatus(ob::PlannerStatus::ABORT);
             };
         }},
    };
}

}  // namespace

std::vector<Defect> lifecycleDefects()
{
    std::vector<Defect> defects = memoryDefects();
    const std::vector<Defect> more = statusDefects();
    defects.insert(defects.end(), more.begin(), more.end());
    return defects;
}

}  // namespace seahex::test
