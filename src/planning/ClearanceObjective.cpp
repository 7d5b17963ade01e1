#include "seahex/planning/ClearanceObjective.h"

#include "planning/LineIntegral.h"
#include "planning/UpperBoundSampler.h"

#include <ompl/base/SpaceInformation.h>
#include <ompl/util/Exception.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

double checked(const char *name, double value)
{
    if (!std::isfinite(value) || value < 0.0)
        throw ompl::Exception("ClearanceObjective",
                              std::string(name) + " must be 0 or more, not " + std::to_string(value));
    return value;
}

}  // namespace

ClearanceObjective::ClearanceObjective(const ob::SpaceInformationPtr &si, const Occupancy &occupancy,
                                       double wantedClearance, double strength)
    : ob::OptimizationObjective(si), embedding_(si->getStateSpace().get()),
      wanted_(checked("the wanted clearance", wantedClearance)), strength_(checked("the strength", strength)),
      clearances_(occupancy, wanted_ * (1.0 + 1e-6))  // as much as wanted is known as that, whatever the rounding
{
    description_ = "Clearance";
}

double ClearanceObjective::pricePerMetre(OffsetCoord cell) const
{
    const double clearance = clearances_.clearance(cell);
    return clearance >= wanted_ ? 1.0 : 1.0 + strength_ * (1.0 - clearance / wanted_);
}

ob::Cost ClearanceObjective::stateCost(const ob::State *state) const
{
    return ob::Cost(pricePerMetre(clearances_.lattice().cellAt(embedding_.position(state))));
}

ob::Cost ClearanceObjective::motionCost(const ob::State *s1, const ob::State *s2) const
{
    return ob::Cost(integrateAlong(clearances_.lattice(), embedding_.position(s1), embedding_.position(s2),
                                   [this](OffsetCoord cell) { return pricePerMetre(cell); }));
}

ob::Cost ClearanceObjective::motionCostHeuristic(const ob::State *s1, const ob::State *s2) const
{
    return ob::Cost(straightLengthBound(embedding_.position(s1), embedding_.position(s2)));
}

ob::InformedSamplerPtr ClearanceObjective::allocInformedStateSampler(const ob::ProblemDefinitionPtr &problem,
                                                                     unsigned int maxNumberCalls) const
{
    return std::make_shared<UpperBoundSampler>(problem, maxNumberCalls);
}

}  // namespace seahex
