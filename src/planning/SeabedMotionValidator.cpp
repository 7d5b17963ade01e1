#include "seahex/planning/SeabedMotionValidator.h"

#include "seahex/planning/DiveStates.h"

#include <ompl/base/SpaceInformation.h>

namespace ob = ompl::base;

namespace seahex
{

SeabedMotionValidator::SeabedMotionValidator(const ob::SpaceInformationPtr &si, std::shared_ptr<const DiveArena> arena)
    : ob::MotionValidator(si), arena_(std::move(arena))
{
    demandDiveSpace(*si->getStateSpace());
}

bool SeabedMotionValidator::isValid(const ob::State *s1, const ob::State *s2) const
{
    // The bounds are convex: the ends stand for the whole.
    return si_->satisfiesBounds(s1) && si_->satisfiesBounds(s2) &&
           arena_->isFree(positionInWater(s1), positionInWater(s2));
}

bool SeabedMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
{
    const bool valid = isValid(s1, s2);
    valid ? ++valid_ : ++invalid_;
    return valid;
}

bool SeabedMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                        std::pair<ob::State *, double> &lastValid) const
{
    if (checkMotion(s1, s2))
        return true;
    // States of our own, because callers may have the last valid one written over s2. Each fraction is tried with the
    // state that the space makes of it, rounded as it may be, so the motion to the last valid one holds as it is. A
    // prefix of a valid motion is valid, so it can be bisected for.
    ob::State *state = si_->cloneState(s1);
    ob::State *best = si_->cloneState(s1);
    double valid = 0.0;
    double invalid = 1.0;
    for (int i = 0; i < 40; ++i)
    {
        const double middle = 0.5 * (valid + invalid);
        si_->getStateSpace()->interpolate(s1, s2, middle, state);
        const bool holds = isValid(s1, state);
        (holds ? valid : invalid) = middle;
        if (holds)
            si_->copyState(best, state);
    }
    lastValid.second = valid;
    if (lastValid.first != nullptr)
        si_->copyState(lastValid.first, best);
    si_->freeState(state);
    si_->freeState(best);
    return false;
}

}  // namespace seahex
