#include "seahex/planning/TurnAngleObjective.h"

#include "planning/MotionTurns.h"
#include "planning/UpperBoundSampler.h"

#include <ompl/base/SpaceInformation.h>

#include <algorithm>

namespace ob = ompl::base;

namespace seahex
{

TurnAngleObjective::TurnAngleObjective(const ob::SpaceInformationPtr &si)
    : ob::OptimizationObjective(si), embedding_(embeddingWithHeading(si->getStateSpace().get()))
{
    description_ = "Turn angle";
}

ob::Cost TurnAngleObjective::stateCost(const ob::State *) const
{
    return identityCost();
}

ob::Cost TurnAngleObjective::motionCost(const ob::State *s1, const ob::State *s2) const
{
    const MotionTurns turns = turnsOf(embedding_, s1, s2);
    return ob::Cost(turns.departure + turns.arrival);
}

// No path turns less than the straight motion. If the two states are at one place, that is the triangle inequality of
// angles. Else let all angles be measured from the straight course d, which is 0, and follow the heading along a path
// from yaw s to yaw g.
// - If it passes through d, it turns at least from s to d and from d to g, as the straight motion does.
// - If not, it keeps between 0 and 2 pi; let a be the least and b the greatest heading on the way. The legs add up to a
//   vector along d, which no sum of courses in [a, b] does if b - a <= pi. So b - a > pi. If a comes before b, the path
//   turns by (s - a) + (b - a) + (b - g) at least, which is s + (2 pi - g) + 2 (b - a - pi): more than s + (2 pi - g),
//   and the straight motion's turns are not more than s and 2 pi - g. If b comes first, the same with all signs
//   changed.
ob::Cost TurnAngleObjective::motionCostHeuristic(const ob::State *s1, const ob::State *s2) const
{
    constexpr double rounding = 1e-9;
    return ob::Cost(std::max(motionCost(s1, s2).value() - rounding, 0.0));
}

ob::InformedSamplerPtr TurnAngleObjective::allocInformedStateSampler(const ob::ProblemDefinitionPtr &problem,
                                                                     unsigned int maxNumberCalls) const
{
    return std::make_shared<UpperBoundSampler>(problem, maxNumberCalls);
}

}  // namespace seahex
