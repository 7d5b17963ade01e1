#include "seahex/planning/TurnCountObjective.h"

#include "planning/MotionTurns.h"
#include "seahex/route/RouteMetrics.h"

#include <ompl/base/SpaceInformation.h>

namespace ob = ompl::base;

namespace seahex
{

TurnCountObjective::TurnCountObjective(const ob::SpaceInformationPtr &si)
    : ob::OptimizationObjective(si), embedding_(embeddingWithHeading(si->getStateSpace().get()))
{
    description_ = "Turn count";
}

ob::Cost TurnCountObjective::stateCost(const ob::State *) const
{
    return identityCost();
}

ob::Cost TurnCountObjective::motionCost(const ob::State *s1, const ob::State *s2) const
{
    const MotionTurns turns = turnsOf(embedding_, s1, s2);
    return ob::Cost((turns.departure > leastTurnRad ? 1.0 : 0.0) + (turns.arrival > leastTurnRad ? 1.0 : 0.0));
}

}  // namespace seahex
