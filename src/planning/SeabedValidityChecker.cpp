#include "seahex/planning/SeabedValidityChecker.h"

#include "seahex/planning/DiveStates.h"

#include <ompl/base/SpaceInformation.h>

namespace ob = ompl::base;

namespace seahex
{

SeabedValidityChecker::SeabedValidityChecker(const ob::SpaceInformationPtr &si, std::shared_ptr<const DiveArena> arena)
    : ob::StateValidityChecker(si), arena_(std::move(arena))
{
    demandDiveSpace(*si->getStateSpace());
    specs_.clearanceComputationType = ob::StateValidityCheckerSpecs::APPROXIMATE;
}

bool SeabedValidityChecker::isValid(const ob::State *state) const
{
    return si_->satisfiesBounds(state) && arena_->isFree(positionInWater(state));
}

bool SeabedValidityChecker::isValid(const ob::State *state, double &dist) const
{
    dist = clearance(state);
    return isValid(state);
}

double SeabedValidityChecker::clearance(const ob::State *state) const
{
    return arena_->room(positionInWater(state));
}

}  // namespace seahex
