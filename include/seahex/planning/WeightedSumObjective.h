#pragma once

#include <ompl/base/OptimizationObjective.h>

#include <utility>
#include <vector>

namespace seahex
{

/// OMPL's MultiOptimizationObjective, the weighted sum of several objectives, with what a planner wants to know of it.
///
/// The sum itself is OMPL's: states and motions cost the weighted sum of what the parts say, costs add up, and parts
/// and weights are added, read and changed as there. What OMPL leaves out is said here:
/// - the heuristic is the weighted sum of the parts' (admissibleHeuristic), where OMPL says identity, which leaves BIT*
///   and informed samplers with nothing;
/// - it is symmetric if every part with a weight is, where OMPL asks the space alone, and RRT*, which takes that for
///   granted, reports costs that are not its path's.
/// Operators + and * make OMPL's own class again.
///
/// Weights must not be negative, and the parts' costs must add up, for the heuristic to say anything. Thread-safe if
/// the parts are.
class WeightedSumObjective : public ompl::base::MultiOptimizationObjective
{
public:
    using Part = std::pair<ompl::base::OptimizationObjectivePtr, double>;

    /// @param parts  objectives and their weights
    explicit WeightedSumObjective(const ompl::base::SpaceInformationPtr &si, const std::vector<Part> &parts = {});

    ompl::base::Cost motionCostHeuristic(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr &problem,
                                                             unsigned int maxNumberCalls) const override;
    bool isSymmetric() const override;
};

}  // namespace seahex
