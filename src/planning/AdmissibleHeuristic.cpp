#include "seahex/planning/AdmissibleHeuristic.h"

#include <typeinfo>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

/// Are the objective's costs numbers that add up, the less the better?
bool addsUp(const ob::OptimizationObjective &objective)
{
    const ob::Cost low(0.25);
    const ob::Cost high(2.0);
    return objective.combineCosts(low, high).value() == low.value() + high.value() &&
           objective.identityCost().value() == 0.0 && objective.isCostBetterThan(low, high) &&
           !objective.isCostBetterThan(high, low);
}

}  // namespace

ob::Cost admissibleHeuristic(const ob::OptimizationObjective &objective, const ob::State *s1, const ob::State *s2)
{
    if (typeid(objective) == typeid(ob::MultiOptimizationObjective))
        return admissibleHeuristicOfSum(static_cast<const ob::MultiOptimizationObjective &>(objective), s1, s2);
    return objective.motionCostHeuristic(s1, s2);
}

ob::Cost admissibleHeuristicOfSum(const ob::MultiOptimizationObjective &sum, const ob::State *s1, const ob::State *s2)
{
    // Parts known exactly and weights that are no binary fractions may add up to more than the pieces of a path do.
    constexpr double rounding = 1e-9;
    double bound = 0.0;
    for (unsigned int i = 0; i < sum.getObjectiveCount(); ++i)
    {
        const ob::OptimizationObjective &part = *sum.getObjective(i);
        const double weight = sum.getObjectiveWeight(i);
        if (!(weight >= 0.0) || !addsUp(part))
            return sum.identityCost();
        bound += weight * admissibleHeuristic(part, s1, s2).value();
    }
    return ob::Cost(bound * (1.0 - rounding));
}

}  // namespace seahex
