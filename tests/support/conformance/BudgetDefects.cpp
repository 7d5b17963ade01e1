#include "support/conformance/SpoiltPlanner.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

using Condition = SpoiltPlanner::Condition;

const ob::PlannerStatus timeout = ob::PlannerStatus::TIMEOUT;

}  // namespace

std::vector<Defect> budgetDefects()
{
    return {
        {"the condition is not looked at",
         {{"AnOverdueConditionIsObeyed", "no time at all: Exact solution"},
          {"TheConditionIsLookedAtOften", "never looked at"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &)
             {
                 return planner.solveWell(ob::plannerNonTerminatingCondition());
             };
         }},
        {"the condition is looked at once",
         {{"TheConditionIsLookedAtOften", "between two looks"}, {"TerminatingFromAnotherThread", "states asked for"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 const bool isOver = condition;
                 return planner.solveWell(Condition([isOver] { return isOver; }));
             };
         }},
        {"nothing is told when time is over",
         {{"WhatIsKnownIsToldInNoTime", "Timeout"}, {"AReportMayEndTheSearch", "Timeout"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 const ob::PlannerStatus status = planner.solveAndChange(condition,
                                                                         [&](ob::PlannerSolution &solution)
                                                                         {
                                                                             if (condition)
                                                                                 solution.path_.reset();
                                                                         });
                 return condition ? timeout : status;
             };
         }},
        {"the first call gives up",
         {{"ANumberOfIterations", "gave up before"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&planner, calls = 0](const Condition &condition) mutable
             {
                 return ++calls == 1 ? timeout : planner.solveWell(condition);
             };
         }},
        {"every call begins afresh",
         {{"SlicesOfTimeAddUp", "and no end"}, {"SecondExportAddsOnly", "frees states"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 planner.clear();
                 return planner.solveWell(condition);
             };
         }},
        {"no two of them work at a time",
         {{"TwoThreads", "solves in two threads"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&](const Condition &condition)
             {
                 static std::atomic<int> working{0};
                 ++working;
                 bool isAlone = true;
                 for (int i = 0; isAlone && i < 50; ++i)
                 {
                     isAlone = working == 1;
                     std::this_thread::sleep_for(std::chrono::microseconds(100));
                 }
                 const ob::PlannerStatus status = isAlone ? planner.solveWell(condition) : timeout;
                 --working;
                 return status;
             };
         }},
    };
}

}  // namespace seahex::test
