#include "planning/CourseCosts.h"

#include "seahex/planning/PlanarEmbedding.h"
#include "seahex/planning/TurnAngleObjective.h"
#include "seahex/planning/TurnCountObjective.h"
#include "seahex/planning/WeightedSumObjective.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/SE2StateSpace.h>

#include <typeinfo>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

bool addPart(const ob::OptimizationObjective &objective, double weight, CourseCosts &costs);

bool addParts(const ob::MultiOptimizationObjective &sum, double weight, CourseCosts &costs)
{
    for (unsigned int i = 0; i < sum.getObjectiveCount(); ++i)
        if (!addPart(*sum.getObjective(i), weight * sum.getObjectiveWeight(i), costs))
            return false;
    return true;
}

bool addPart(const ob::OptimizationObjective &objective, double weight, CourseCosts &costs)
{
    if (!(weight >= 0.0))
        return false;
    const std::type_info &type = typeid(objective);
    if (type == typeid(ob::PathLengthOptimizationObjective))
    {
        const auto &space = *objective.getSpaceInformation()->getStateSpace()->as<ob::SE2StateSpace>();
        costs.perLength += weight * space.getSubspaceWeight(0);
        costs.turns.perRadian += weight * space.getSubspaceWeight(1);
        return true;
    }
    if (type == typeid(TurnAngleObjective))
        costs.turns.perRadian += weight;
    else if (type == typeid(TurnCountObjective))
        costs.turns.perTurn += weight;
    else if (type == typeid(WeightedSumObjective) || type == typeid(ob::MultiOptimizationObjective))
        return addParts(static_cast<const ob::MultiOptimizationObjective &>(objective), weight, costs);
    else
        return false;
    return true;
}

}  // namespace

std::optional<CourseCosts> courseCosts(const ob::OptimizationObjective &objective)
{
    if (!PlanarEmbedding(objective.getSpaceInformation()->getStateSpace().get()).hasHeading())
        return std::nullopt;
    CourseCosts costs;
    return addPart(objective, 1.0, costs) ? std::optional(costs) : std::nullopt;
}

}  // namespace seahex
