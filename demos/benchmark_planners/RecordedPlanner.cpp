#include "RecordedPlanner.h"

#include <ompl/base/PlannerData.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/PathSimplifier.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <thread>

#include <ctime>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace benchmark_planners
{
namespace
{

double secondsOf(clockid_t clock)
{
    timespec now = {};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Longer than any benchmark, and OMPL can still count it in nanoseconds.
constexpr double noLimitS = 1e9;

}  // namespace

RecordedPlanner::RecordedPlanner(const std::string &name, ob::PlannerPtr planner, Finish finish)
    : ob::Planner(planner->getSpaceInformation(), name), planner_(std::move(planner)), finish_(finish),
      timeLimitS_(noLimitS)
{
    specs_ = planner_->getSpecs();
    params_.include(planner_->params());
    for (const auto &[property, read] : planner_->getPlannerProgressProperties())
        if (property.rfind("best cost ", 0) == 0)
            reportedCost_ = read;
}

void RecordedPlanner::setProblemDefinition(const ob::ProblemDefinitionPtr &pdef)
{
    ob::Planner::setProblemDefinition(pdef);
    planner_->setProblemDefinition(pdef);
}

void RecordedPlanner::setup()
{
    ob::Planner::setup();
    planner_->setup();
}

void RecordedPlanner::clear()
{
    ob::Planner::clear();
    planner_->clear();
    history_.clear();
}

ob::PlannerStatus RecordedPlanner::solve(const ob::PlannerTerminationCondition &ptc)
{
    history_.clear();
    isRunning_ = true;
    hasReported_ = false;
    pdef_->setIntermediateSolutionCallback(
        [this](const ob::Planner *, const std::vector<const ob::State *> &, const ob::Cost cost)
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            hasReported_ = true;
            note(cost.value());
        });
    const double processorBegin = secondsOf(CLOCK_PROCESS_CPUTIME_ID);
    beginS_ = secondsOf(CLOCK_MONOTONIC);
    std::thread sampler = reportedCost_ ? std::thread([this] { sample(); }) : std::thread();
    const ob::PlannerStatus status =
        solveAndFinish(plannerOrTerminationCondition(ptc, ob::timedPlannerTerminationCondition(timeLimitS_)));
    wallSeconds_ = secondsOf(CLOCK_MONOTONIC) - beginS_;
    processorSeconds_ = secondsOf(CLOCK_PROCESS_CPUTIME_ID) - processorBegin;
    pdef_->setIntermediateSolutionCallback({});
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        isRunning_ = false;
    }
    ended_.notify_all();
    if (sampler.joinable())
        sampler.join();
    return status;
}

void RecordedPlanner::sample()
{
    constexpr double leastS = 0.001;
    constexpr double growth = 0.02;  // even steps on a logarithmic axis
    std::unique_lock<std::mutex> lock(mutex_);
    while (isRunning_ && !hasReported_)
    {
        const double elapsed = secondsOf(CLOCK_MONOTONIC) - beginS_;
        ended_.wait_for(lock, std::chrono::duration<double>(std::max(leastS, growth * elapsed)));
        if (isRunning_ && !hasReported_)
            note(std::strtod(reportedCost_().c_str(), nullptr));
    }
}

ob::PlannerStatus RecordedPlanner::solveAndFinish(const ob::PlannerTerminationCondition &ptc)
{
    try
    {
        const ob::PlannerStatus status = planner_->solve(ptc);
        if (finish_ == Finish::Simplify && pdef_->hasExactSolution())
            simplify(ptc);
        return status;
    }
    catch (const std::exception &error)
    {
        std::cerr << getName() << ": " << error.what() << std::endl;
        return ob::PlannerStatus::CRASH;
    }
}

void RecordedPlanner::simplify(const ob::PlannerTerminationCondition &ptc)
{
    const ob::OptimizationObjectivePtr &objective = pdef_->getOptimizationObjective();
    const ob::PathPtr found = pdef_->getSolutionPath();
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        note(found->cost(objective).value());
    }

    // A copy: the path that the problem definition holds was ranked with its length as it is.
    const auto simplified = std::make_shared<og::PathGeometric>(static_cast<const og::PathGeometric &>(*found));
    og::PathSimplifier(si_, pdef_->getGoal(), objective).simplify(*simplified, ptc);
    ob::PlannerSolution solution(simplified);
    solution.setPlannerName(getName());
    const ob::Cost cost = simplified->cost(objective);
    solution.setOptimized(objective, cost, objective->isSatisfied(cost));
    pdef_->clearSolutionPaths();
    pdef_->addSolutionPath(solution);
}

void RecordedPlanner::getPlannerData(ob::PlannerData &data) const
{
    for (const auto &[property, read] : planner_->getPlannerProgressProperties())
        data.properties[property] = read();
}

void RecordedPlanner::note(double cost)
{
    history_.add(secondsOf(CLOCK_MONOTONIC) - beginS_, cost);
}

}  // namespace benchmark_planners
