#include "seahex/planning/LatticeLengthObjective.h"

#include "planning/UpperBoundSampler.h"
#include "seahex/geometry/LatticeNorm.h"

#include <ompl/base/SpaceInformation.h>

namespace ob = ompl::base;

namespace seahex
{

LatticeLengthObjective::LatticeLengthObjective(const ob::SpaceInformationPtr &si, const Lattice &lattice)
    : ob::OptimizationObjective(si), embedding_(si->getStateSpace().get()), lattice_(lattice)
{
    description_ = "Lattice length";
}

ob::Cost LatticeLengthObjective::stateCost(const ob::State *) const
{
    return identityCost();
}

ob::Cost LatticeLengthObjective::motionCost(const ob::State *s1, const ob::State *s2) const
{
    return ob::Cost(latticeNorm(embedding_.position(s2) - embedding_.position(s1), lattice_));
}

ob::Cost LatticeLengthObjective::motionCostHeuristic(const ob::State *s1, const ob::State *s2) const
{
    // The pieces of a line may add up to less than the whole by rounding; a heuristic above the cost breaks BIT*.
    constexpr double rounding = 1e-9;
    return ob::Cost(motionCost(s1, s2).value() * (1.0 - rounding));
}

ob::InformedSamplerPtr LatticeLengthObjective::allocInformedStateSampler(const ob::ProblemDefinitionPtr &problem,
                                                                         unsigned int maxNumberCalls) const
{
    return std::make_shared<UpperBoundSampler>(problem, maxNumberCalls);
}

}  // namespace seahex
