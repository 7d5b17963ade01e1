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

/// Counts the questions that may still be asked before the condition has to be looked at.
class PathShortener::Budget
{
public:
    explicit Budget(const ob::PlannerTerminationCondition &stop) : stop_(stop), isOver_(stop()) {}

    /// To be called before each question. @return false if no more may be asked
    bool ask()
    {
        if (!isOver_ && ++asked_ % 14 == 0)  // two or three questions of the problem's code at a time
            isOver_ = stop_();
        return !isOver_;
    }
    bool isOver() const { return isOver_; }

private:
    const ob::PlannerTerminationCondition &stop_;
    unsigned int asked_ = 0;
    bool isOver_;
};

PathShortener::PathShortener(ob::SpaceInformationPtr si, ob::OptimizationObjectivePtr objective,
                             std::shared_ptr<const HexOccupancy> chart, double pitch)
    : si_(std::move(si)), objective_(std::move(objective)), chart_(std::move(chart)), pitch_(pitch),
      embedding_(si_->getStateSpace().get())
{
}

PathShortener::Result PathShortener::shorten(const og::PathGeometric &path,
                                             const ob::PlannerTerminationCondition &stop) const
{
    if (path.getStateCount() < 3)
        return {nullptr, true};
    Budget budget(stop);
    const ob::OptimizationObjective &objective = *objective_;
    const bool isPlaneLength = typeid(objective) == typeid(ob::PathLengthOptimizationObjective) &&
                               !embedding_.hasHeading() && embedding_.lattice() == nullptr;
    auto shorter = isPlaneLength ? pulledTaut(path, budget) : withShortcuts(path, budget);
    if (shorter && !objective_->isCostBetterThan(shorter->cost(objective_), path.cost(objective_)))
        shorter.reset();
    return {std::move(shorter), !budget.isOver()};
}

std::shared_ptr<og::PathGeometric> PathShortener::pulledTaut(const og::PathGeometric &path, Budget &budget) const
{
    ob::ScopedState<> from(si_);
    ob::ScopedState<> to(si_);
    const auto isValid = [&](const Point &a, const Point &b)
    {
        if (!budget.ask())
            return false;  // no more may be pulled; what is left stays as it is
        if (chart_)
            return isFree(*chart_, a, b);
        embedding_.place(from.get(), a);
        embedding_.place(to.get(), b);
        return si_->checkMotion(from.get(), to.get());
    };
    const Route pulled = pullString(routeFromPath(path), isValid, 0.5 * pitch_);
    auto result = std::make_shared<og::PathGeometric>(si_);
    for (const Point &waypoint : pulled.waypoints())
    {
        embedding_.place(from.get(), waypoint);
        result->append(from.get());
    }
    return result;
}

std::shared_ptr<og::PathGeometric> PathShortener::withShortcuts(const og::PathGeometric &path, Budget &budget) const
{
    std::vector<const ob::State *> states;
    for (std::size_t i = 0; i < path.getStateCount(); ++i)
        states.push_back(path.getState(static_cast<unsigned int>(i)));
    const std::size_t last = states.size() - 1;
    auto result = std::make_shared<og::PathGeometric>(si_, states.front());
    ob::ScopedState<> candidate(si_);

    // Is the motion from the last state kept, states[from] as it has become, to states[to] valid and no worse? Leaves
    // the state that would be kept in `candidate`.
    const auto canSkip = [&](std::size_t from, std::size_t to)
    {
        if (!budget.ask())
            return false;
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
        return (!embedding_.hasHeading() || si_->isValid(candidate.get())) && si_->checkMotion(kept, candidate.get());
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
