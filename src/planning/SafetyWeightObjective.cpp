#include "seahex/planning/SafetyWeightObjective.h"

#include "planning/LineIntegral.h"
#include "planning/UpperBoundSampler.h"

#include <ompl/base/SpaceInformation.h>

namespace ob = ompl::base;

namespace seahex
{

SafetyWeightObjective::SafetyWeightObjective(const ob::SpaceInformationPtr &si, const Occupancy &occupancy,
                                             SafetyCharge charge)
    : ob::OptimizationObjective(si), embedding_(si->getStateSpace().get()), weights_(occupancy), charge_(charge)
{
    description_ = "Safety weight";
}

ob::Cost SafetyWeightObjective::stateCost(const ob::State *state) const
{
    return ob::Cost(weights_.weight(weights_.lattice().cellAt(embedding_.position(state))));
}

ob::Cost SafetyWeightObjective::motionCost(const ob::State *s1, const ob::State *s2) const
{
    const Point a = embedding_.position(s1);
    const Point b = embedding_.position(s2);
    if (charge_ == SafetyCharge::OnArrival)
        return ob::Cost((b - a).norm() * stateCost(s2).value());
    return ob::Cost(
        integrateAlong(weights_.lattice(), a, b, [this](OffsetCoord cell) { return weights_.weight(cell); }));
}

ob::Cost SafetyWeightObjective::motionCostHeuristic(const ob::State *s1, const ob::State *s2) const
{
    return ob::Cost(straightLengthBound(embedding_.position(s1), embedding_.position(s2)));
}

ob::InformedSamplerPtr SafetyWeightObjective::allocInformedStateSampler(const ob::ProblemDefinitionPtr &problem,
                                                                        unsigned int maxNumberCalls) const
{
    return std::make_shared<UpperBoundSampler>(problem, maxNumberCalls);
}

}  // namespace seahex
