#include "seahex/planning/OccupancyMotionValidator.h"

#include "seahex/world/SegmentValidity.h"

#include <ompl/base/SpaceInformation.h>

namespace ob = ompl::base;

namespace seahex
{

OccupancyMotionValidator::OccupancyMotionValidator(const ob::SpaceInformationPtr &si,
                                                   std::shared_ptr<const HexOccupancy> occupancy)
  : ob::MotionValidator(si), embedding_(si->getStateSpace().get()), occupancy_(std::move(occupancy))
{
}

bool OccupancyMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
{
    // The bounds are convex, so the ends stand for the whole motion.
    const bool valid = si_->satisfiesBounds(s1) && si_->satisfiesBounds(s2) &&
                       isFree(*occupancy_, embedding_.position(s1), embedding_.position(s2));
    valid ? ++valid_ : ++invalid_;
    return valid;
}

bool OccupancyMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2,
                                           std::pair<ob::State *, double> &lastValid) const
{
    if (checkMotion(s1, s2))
        return true;
    const Point a = embedding_.position(s1);
    const Point b = embedding_.position(s2);
    lastValid.second = si_->satisfiesBounds(s1) ? lastFree(*occupancy_, a, b).value_or(0.0) : 0.0;
    if (lastValid.first == nullptr)
        return false;
    // The interpolated state is rounded by the space: step back until the motion to it holds as it is.
    double fraction = lastValid.second;
    for (;;)
    {
        si_->getStateSpace()->interpolate(s1, s2, fraction, lastValid.first);
        if (fraction == 0.0 || (si_->satisfiesBounds(lastValid.first) &&
                                isFree(*occupancy_, a, embedding_.position(lastValid.first))))
            break;
        fraction = fraction > 1e-12 ? fraction * (1.0 - 1e-9) - 1e-13 : 0.0;
    }
    lastValid.second = fraction;
    return false;
}

}  // namespace seahex
