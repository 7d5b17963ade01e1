#include "seahex/planning/OccupancyValidityChecker.h"

#include "seahex/world/Clearance.h"
#include "seahex/world/SegmentValidity.h"

#include <ompl/base/SpaceInformation.h>

namespace ob = ompl::base;

namespace seahex
{

OccupancyValidityChecker::OccupancyValidityChecker(const ob::SpaceInformationPtr &si,
                                                   std::shared_ptr<const Occupancy> occupancy)
    : ob::StateValidityChecker(si), embedding_(si->getStateSpace().get()), occupancy_(std::move(occupancy))
{
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::EXACT;
}

bool OccupancyValidityChecker::isValid(const ob::State *state) const
{
    const Point p = embedding_.position(state);
    return si_->satisfiesBounds(state) && isFree(*occupancy_, p, p);
}

bool OccupancyValidityChecker::isValid(const ob::State *state, double &dist) const
{
    dist = clearance(state);
    return isValid(state);
}

double OccupancyValidityChecker::clearance(const ob::State *state) const
{
    return signedClearance(*occupancy_, embedding_.position(state));
}

}  // namespace seahex
