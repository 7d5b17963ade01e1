#pragma once

#include "planning/Questions.h"
#include "seahex/planning/PlanarEmbedding.h"
#include "seahex/world/Occupancy.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <vector>

namespace seahex
{

/// Makes a lattice's path better by straight motions between points of it.
///
/// Where states are any points of the plane and cost is their path's length, the path is pulled taut (pullString).
/// Where that does not hold in the end, and in other spaces and for other costs, states are left out as long as the
/// motion in their place is valid and costs no more, by the objective's own word; in SE(2) the yaws become the courses
/// of the new legs. Every motion of the result was found valid, in its own direction.
class PathShortener
{
public:
    using Path = ompl::geometric::PathGeometric;

    /// @param chart  where the problem's validity is that of this occupancy and it may be read; else nullptr
    PathShortener(ompl::base::SpaceInformationPtr si, ompl::base::OptimizationObjectivePtr objective,
                  std::shared_ptr<const Occupancy> chart, double pitch);

    struct Result
    {
        std::shared_ptr<Path> path;  ///< nullptr if nothing better was found
        bool isFinished;             ///< false if the condition ended the work
    };

    /// The path to be shortened; it must not change.
    void begin(std::shared_ptr<Path> path);

    /// Goes on with it. The condition is looked at every 16 calls of the problem's code, or after each motion where one
    /// takes more.
    Result work(const ompl::base::PlannerTerminationCondition &stop);

private:
    std::shared_ptr<Path> pulledTaut(Questions &questions) const;
    std::shared_ptr<Path> withShortcuts(Questions &questions) const;
    bool isMotionValid(Questions &questions, const ompl::base::State *a, const ompl::base::State *b) const;

    ompl::base::SpaceInformationPtr si_;
    ompl::base::OptimizationObjectivePtr objective_;
    std::shared_ptr<const Occupancy> chart_;
    double pitch_;
    PlanarEmbedding embedding_;
    std::shared_ptr<Path> path_;
    std::vector<bool> answers_;
};

}  // namespace seahex
