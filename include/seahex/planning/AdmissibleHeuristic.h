#pragma once

#include <ompl/base/OptimizationObjective.h>

namespace seahex
{

/// A bound that no path from s1 to s2 costs less than: what an informed search may use for any objective.
///
/// For most objectives that is their own motionCostHeuristic(). OMPL's MultiOptimizationObjective has none of its own
/// and returns identity, however much is known of its parts; for exactly that class it is the weighted sum of the
/// parts' bounds, taken in the same order as the costs are. That holds where every part's costs are numbers that add
/// up, less being better, and no weight is negative; otherwise the bound is identity, as OMPL's own. Classes derived
/// from MultiOptimizationObjective may sum otherwise, and are asked themselves.
///
/// Whether a part adds up is found out by adding and comparing a few costs with it, so the answer is good for
/// objectives that are sums, minima or maxima. Const, thread-safe if the objectives are.
ompl::base::Cost admissibleHeuristic(const ompl::base::OptimizationObjective &objective, const ompl::base::State *s1,
                                     const ompl::base::State *s2);

/// The same for the parts and weights of a sum, whatever its class says itself.
ompl::base::Cost admissibleHeuristicOfSum(const ompl::base::MultiOptimizationObjective &sum,
                                          const ompl::base::State *s1, const ompl::base::State *s2);

}  // namespace seahex
