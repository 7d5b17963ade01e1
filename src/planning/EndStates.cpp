#include "planning/EndStates.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>

#include <limits>
#include <typeinfo>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

constexpr unsigned int mostSamples = 100;  // of a goal region that is no list of states

/// True for goals whose states are all there from the beginning: none will turn up later.
bool isListOfStates(const ob::Goal &goal)
{
    return typeid(goal) == typeid(ob::GoalState) || typeid(goal) == typeid(ob::GoalStates);
}

}  // namespace

bool EndStates::takeStarts(ob::PlannerInputStates &inputs)
{
    const std::size_t before = starts_.size();
    while (const ob::State *state = inputs.nextStart())
        starts_.push_back(si_->cloneState(state));
    return starts_.size() > before;
}

bool EndStates::takeGoals(ob::PlannerInputStates &inputs, const ob::Goal &goal,
                          const ob::PlannerTerminationCondition &ptc)
{
    const std::size_t before = goals_.size();
    const unsigned int most = isListOfStates(goal) ? std::numeric_limits<unsigned int>::max() : mostSamples;
    // nextGoal() makes one attempt, and none at all if the region can't give a sample now.
    for (bool goOn = true; goOn && inputs.haveMoreGoalStates() && inputs.getSampledGoalsCount() < most;)
    {
        const unsigned int sampled = inputs.getSampledGoalsCount();
        if (const ob::State *state = inputs.nextGoal())
            goals_.push_back(si_->cloneState(state));
        goOn = inputs.getSampledGoalsCount() > sampled && (!inputs.haveMoreGoalStates() || !ptc);
    }
    return goals_.size() > before;
}

bool EndStates::awaitGoal(ob::PlannerInputStates &inputs, const ob::Goal &goal,
                          const ob::PlannerTerminationCondition &ptc)
{
    if (!goals_.empty() || isListOfStates(goal))
        return false;
    const ob::State *state = inputs.nextGoal(ptc);
    if (state != nullptr)
        goals_.push_back(si_->cloneState(state));
    return state != nullptr;
}

void EndStates::clear()
{
    for (ob::State *state : starts_)
        si_->freeState(state);
    for (ob::State *state : goals_)
        si_->freeState(state);
    starts_.clear();
    goals_.clear();
}

}  // namespace seahex
