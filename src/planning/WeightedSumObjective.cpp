#include "seahex/planning/WeightedSumObjective.h"

#include "planning/UpperBoundSampler.h"
#include "seahex/planning/AdmissibleHeuristic.h"

namespace ob = ompl::base;

namespace seahex
{

WeightedSumObjective::WeightedSumObjective(const ob::SpaceInformationPtr &si, const std::vector<Part> &parts)
    : ob::MultiOptimizationObjective(si)
{
    description_ = "Weighted sum";
    for (const auto &[objective, weight] : parts)
        addObjective(objective, weight);
}

ob::Cost WeightedSumObjective::motionCostHeuristic(const ob::State *s1, const ob::State *s2) const
{
    return admissibleHeuristicOfSum(*this, s1, s2);
}

bool WeightedSumObjective::isSymmetric() const
{
    for (unsigned int i = 0; i < getObjectiveCount(); ++i)
        if (getObjectiveWeight(i) != 0.0 && !getObjective(i)->isSymmetric())
            return false;
    return true;
}

ob::InformedSamplerPtr WeightedSumObjective::allocInformedStateSampler(const ob::ProblemDefinitionPtr &problem,
                                                                       unsigned int maxNumberCalls) const
{
    return std::make_shared<UpperBoundSampler>(problem, maxNumberCalls);
}

}  // namespace seahex
