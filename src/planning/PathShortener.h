#pragma once

#include "seahex/planning/PlanarEmbedding.h"
#include "seahex/world/HexOccupancy.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>

namespace seahex
{

/// Makes a lattice's path better by straight motions between points of it.
///
/// Where states are any points of the plane and cost is their path's length, the path is pulled taut (pullString).
/// Elsewhere states are left out as long as the motion in their place is valid and costs no more, by the objective's
/// own word; in SE(2) the yaws become the courses of the new legs. Every motion of the result was found valid.
class PathShortener
{
public:
    /// @param chart  where the problem's validity is that of this occupancy and it may be read; else nullptr
    PathShortener(ompl::base::SpaceInformationPtr si, ompl::base::OptimizationObjectivePtr objective,
                  std::shared_ptr<const HexOccupancy> chart, double pitch);

    struct Result
    {
        std::shared_ptr<ompl::geometric::PathGeometric> path;  ///< nullptr if nothing better was found
        bool isFinished;                                       ///< false if the condition ended the work
    };

    /// The condition is looked at every 16 questions to the problem's code.
    Result shorten(const ompl::geometric::PathGeometric &path,
                   const ompl::base::PlannerTerminationCondition &stop) const;

private:
    class Budget;

    std::shared_ptr<ompl::geometric::PathGeometric> pulledTaut(const ompl::geometric::PathGeometric &path,
                                                               Budget &budget) const;
    std::shared_ptr<ompl::geometric::PathGeometric> withShortcuts(const ompl::geometric::PathGeometric &path,
                                                                  Budget &budget) const;

    ompl::base::SpaceInformationPtr si_;
    ompl::base::OptimizationObjectivePtr objective_;
    std::shared_ptr<const HexOccupancy> chart_;
    double pitch_;
    PlanarEmbedding embedding_;
};

}  // namespace seahex
