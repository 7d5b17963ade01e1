#pragma once

#include "support/Random.h"

#include <seahex/planning/SlicePlanner.h>

#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>

#include <functional>
#include <memory>
#include <vector>

namespace seahex::test
{

/// Free places of R^3.
using FreePlaces = std::function<bool(const Eigen::Vector3d &)>;

inline Eigen::Vector3d placeOf(const ompl::base::State *state)
{
    return Eigen::Vector3d(state->as<ompl::base::RealVectorStateSpace::StateType>()->values);
}

/// R^3 within these bounds, set up, with OMPL's motion validator unless another is made.
inline ompl::base::SpaceInformationPtr waterColumn(
    const Eigen::AlignedBox3d &bounds, const FreePlaces &isFree,
    const std::function<ompl::base::MotionValidatorPtr(const ompl::base::SpaceInformationPtr &)> &validator = {})
{
    auto space = std::make_shared<ompl::base::RealVectorStateSpace>(3);
    ompl::base::RealVectorBounds box(3);
    for (unsigned int k = 0; k < 3; ++k)
    {
        box.setLow(k, bounds.min()[k]);
        box.setHigh(k, bounds.max()[k]);
    }
    space->setBounds(box);
    auto si = std::make_shared<ompl::base::SpaceInformation>(space);
    si->setStateValidityChecker([isFree](const ompl::base::State *state) { return isFree(placeOf(state)); });
    si->setStateValidityCheckingResolution(0.004);
    if (validator)
        si->setMotionValidator(validator(si));
    si->setup();
    return si;
}

inline ompl::base::ScopedState<> stateAt(const ompl::base::SpaceInformationPtr &si, const Eigen::Vector3d &p)
{
    ompl::base::ScopedState<> state(si);
    for (unsigned int k = 0; k < 3; ++k)
        state[k] = p[k];
    return state;
}

inline ompl::base::ProblemDefinitionPtr dive(const ompl::base::SpaceInformationPtr &si, const Eigen::Vector3d &start,
                                             const std::vector<Eigen::Vector3d> &goals)
{
    auto problem = std::make_shared<ompl::base::ProblemDefinition>(si);
    problem->addStartState(stateAt(si, start));
    auto goal = std::make_shared<ompl::base::GoalStates>(si);
    for (const Eigen::Vector3d &p : goals)
        goal->addState(stateAt(si, p));
    problem->setGoal(goal);
    return problem;
}

/// Solves with no limit of time, which planners on slices end without.
inline ompl::base::PlannerStatus::StatusType solve(ompl::base::Planner &planner,
                                                   const ompl::base::ProblemDefinitionPtr &problem)
{
    planner.setProblemDefinition(problem);
    return planner.solve(ompl::base::plannerNonTerminatingCondition());
}

inline std::vector<Eigen::Vector3d> solutionOf(const ompl::base::ProblemDefinitionPtr &problem)
{
    std::vector<Eigen::Vector3d> points;
    const auto path = std::dynamic_pointer_cast<ompl::geometric::PathGeometric>(problem->getSolutionPath());
    if (path)
        for (const ompl::base::State *state : path->getStates())
            points.push_back(placeOf(state));
    return points;
}

inline double lengthOf(const std::vector<Eigen::Vector3d> &points)
{
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += (points[i] - points[i - 1]).norm();
    return length;
}

}  // namespace seahex::test
