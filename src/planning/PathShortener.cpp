#include "planning/PathShortener.h"

#include "planning/Courses.h"
#include "seahex/planning/RouteFromPath.h"
#include "seahex/route/RouteSmoother.h"
#include "seahex/world/SegmentValidity.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <typeinfo>
#include <utility>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex
{

PathShortener::PathShortener(ob::SpaceInformationPtr si, ob::OptimizationObjectivePtr objective,
                             std::shared_ptr<const Occupancy> chart, double pitch)
    : si_(std::move(si)), objective_(std::move(objective)), chart_(std::move(chart)), pitch_(pitch),
      embedding_(si_->getStateSpace().get())
{
}

void PathShortener::begin(std::shared_ptr<Path> path)
{
    path_ = std::move(path);
    answers_.clear();
}

PathShortener::Result PathShortener::work(const ob::PlannerTerminationCondition &stop)
{
    if (path_->getStateCount() < 3)
        return {nullptr, true};
    Questions questions(answers_, stop);
    const ob::OptimizationObjective &objective = *objective_;
    const bool isPlaneLength = typeid(objective) == typeid(ob::PathLengthOptimizationObjective) &&
                               !embedding_.hasHeading() && embedding_.lattice() == nullptr;
    auto shorter = isPlaneLength ? pulledTaut(questions) : nullptr;
    if (!shorter)
        shorter = withShortcuts(questions);
    if (shorter && !objective_->isCostBetterThan(shorter->cost(objective_), path_->cost(objective_)))
        shorter.reset();
    return {std::move(shorter), !questions.isOver()};
}

bool PathShortener::isMotionValid(Questions &questions, const ob::State *a, const ob::State *b) const
{
    if (chart_ && !embedding_.hasHeading())
        return questions.ask(1, [&] { return isFree(*chart_, embedding_.position(a), embedding_.position(b)); });
    return questions.ask(si_->getStateSpace()->validSegmentCount(a, b) + (embedding_.hasHeading() ? 1 : 0),
                         [&] { return (!embedding_.hasHeading() || si_->isValid(b)) && si_->checkMotion(a, b); });
}

std::shared_ptr<og::PathGeometric> PathShortener::pulledTaut(Questions &questions) const
{
    ob::ScopedState<> from(si_);
    ob::ScopedState<> to(si_);
    const auto isValid = [&](const Point &a, const Point &b)
    {
        embedding_.place(from.get(), a);
        embedding_.place(to.get(), b);
        return isMotionValid(questions, from.get(), to.get());
    };
    const Route pulled = pullString(routeFromPath(*path_), isValid, 0.5 * pitch_);
    if (questions.isOver() && !chart_)
        return nullptr;
    // Parts of valid motions need not be valid where a checker samples, nor motions back where they were asked for
    // there.
    const std::vector<Point> &points = pulled.waypoints();
    for (std::size_t i = 1; i < points.size(); ++i)
        if (chart_ ? !isFree(*chart_, points[i - 1], points[i]) : !isValid(points[i - 1], points[i]))
            return nullptr;
    auto result = std::make_shared<Path>(si_);
    for (const Point &waypoint : points)
    {
        embedding_.place(from.get(), waypoint);
        result->append(from.get());
    }
    return result;
}

std::shared_ptr<og::PathGeometric> PathShortener::withShortcuts(Questions &questions) const
{
    std::vector<const ob::State *> states;
    for (std::size_t i = 0; i < path_->getStateCount(); ++i)
        states.push_back(path_->getState(static_cast<unsigned int>(i)));
    const std::size_t last = states.size() - 1;
    auto result = std::make_shared<Path>(si_, states.front());
    ob::ScopedState<> candidate(si_);

    // Is the motion from the last state kept, states[from] as it has become, to states[to] valid and no worse? Leaves
    // the state that would be kept in `candidate`.
    const auto canSkip = [&](std::size_t from, std::size_t to)
    {
        const ob::State *kept = result->getStates().back();
        si_->copyState(candidate.get(), states[to]);
        if (embedding_.hasHeading() && to < last)
        {
            const Point a = embedding_.position(kept);
            const Point b = embedding_.position(states[to]);
            embedding_.place(candidate.get(), b, a == b ? embedding_.heading(kept) : courseBetween(a, b));
        }
        if (to > from + 1)
        {
            ob::Cost replaced = objective_->identityCost();
            for (std::size_t i = from; i < to; ++i)
                replaced = objective_->combineCosts(replaced, objective_->motionCost(states[i], states[i + 1]));
            if (objective_->isCostBetterThan(replaced, objective_->motionCost(kept, candidate.get())))
                return false;
        }
        return isMotionValid(questions, kept, candidate.get());
    };

    for (std::size_t from = 0; from < last;)
    {
        std::size_t seen = from;
        std::size_t stride = 1;
        // doubling strides, then halving them, as pullString does
        while (seen + stride <= last && canSkip(from, seen + stride))
        {
            seen += stride;
            stride *= 2;
        }
        for (; stride >= 1; stride /= 2)
            if (seen + stride <= last && canSkip(from, seen + stride))
                seen += stride;
        if (seen == from || !canSkip(from, seen))
            return nullptr;  // interrupted, or a yaw that the leg before it brought along does not hold
        result->append(candidate.get());
        from = seen;
    }
    return result;
}

}  // namespace seahex
