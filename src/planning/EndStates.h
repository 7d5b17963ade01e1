#pragma once

#include <ompl/base/Planner.h>

#include <utility>
#include <vector>

namespace seahex
{

/// The starts and goals of a problem as far as a planner has taken them over; owns copies of them.
class EndStates
{
public:
    explicit EndStates(ompl::base::SpaceInformationPtr si) : si_(std::move(si)) {}
    ~EndStates() { clear(); }
    EndStates(const EndStates &) = delete;
    EndStates &operator=(const EndStates &) = delete;

    const std::vector<ompl::base::State *> &starts() const { return starts_; }
    const std::vector<ompl::base::State *> &goals() const { return goals_; }

    /// Takes the valid starts that are new. @return true if there were any
    bool takeStarts(ompl::base::PlannerInputStates &inputs);

    /// Takes the valid goals that are there and new. A region with no end of samples is represented by its first 100.
    /// @return true if there were any
    bool takeGoals(ompl::base::PlannerInputStates &inputs, const ompl::base::Goal &goal,
                   const ompl::base::PlannerTerminationCondition &ptc);

    /// Waits for a goal if there is none yet and one may turn up. @return true if one did
    bool awaitGoal(ompl::base::PlannerInputStates &inputs, const ompl::base::Goal &goal,
                   const ompl::base::PlannerTerminationCondition &ptc);

    void clear();

private:
    ompl::base::SpaceInformationPtr si_;
    std::vector<ompl::base::State *> starts_;
    std::vector<ompl::base::State *> goals_;
};

}  // namespace seahex
