#include "seahex/planning/OccupancyMotionValidator.h"

#include "seahex/world/SegmentValidity.h"

#include <ompl/base/SpaceInformation.h>

#include <cstdint>

namespace ob = ompl::base;

namespace seahex
{

OccupancyMotionValidator::OccupancyMotionValidator(const ob::SpaceInformationPtr &si,
                                                   std::shared_ptr<const Occupancy> occupancy)
    : ob::MotionValidator(si), embedding_(si->getStateSpace().get()), occupancy_(std::move(occupancy))
{
}

bool OccupancyMotionValidator::checkMotion(const ob::State *s1, const ob::State *s2) const
{
    // The bounds are convex, or those of a lattice, which contain what a motion is interpolated by: the ends stand for
    // the whole.
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
    // A state of our own, because callers may have the last valid one written over s2.
    ob::State *state = si_->allocState();
    lastValid.second =
        embedding_.lattice() != nullptr ? lastValidStep(s1, s2, state) : lastValidFraction(s1, s2, state);
    if (lastValid.first != nullptr)
    {
        si_->copyState(state, s1);
        if (lastValid.second > 0.0)
            si_->getStateSpace()->interpolate(s1, s2, lastValid.second, state);
        if (lastValid.second > 0.0 && !si_->satisfiesBounds(state))
            si_->enforceBounds(state);  // a yaw half way between two others may come out as pi, which is -pi
        si_->copyState(lastValid.first, state);
    }
    si_->freeState(state);
    return false;
}

double OccupancyMotionValidator::lastValidFraction(const ob::State *s1, const ob::State *s2, ob::State *state) const
{
    const Point a = embedding_.position(s1);
    if (!si_->satisfiesBounds(s1))
        return 0.0;
    // Each fraction is tried with the state that the space makes of it, rounded as it may be, so the motion to the last
    // valid one holds as it is. A prefix of a valid motion is valid, so it can be bisected for.
    double valid = 0.0;
    double invalid = 1.0;
    for (int i = 0; i < 40; ++i)
    {
        const double middle = 0.5 * (valid + invalid);
        si_->getStateSpace()->interpolate(s1, s2, middle, state);
        const Point p = embedding_.position(state);
        embedding_.place(state, p);  // with a yaw that is no matter
        const bool holds = si_->satisfiesBounds(state) && isFree(*occupancy_, a, p);
        (holds ? valid : invalid) = middle;
    }
    return valid;
}

double OccupancyMotionValidator::lastValidStep(const ob::State *s1, const ob::State *s2, ob::State *state) const
{
    const Point a = embedding_.position(s1);
    const Point b = embedding_.position(s2);
    const std::optional<double> free = lastFree(*occupancy_, a, b);
    if (!si_->satisfiesBounds(s1) || !free)
        return 0.0;
    const HexLattice &lattice = *embedding_.lattice();
    const std::int64_t steps = hexDistance(lattice.cellAt(a), lattice.cellAt(b));
    const auto count = static_cast<double>(steps);
    for (auto step = static_cast<std::int64_t>(*free * count); step > 0; --step)
    {
        const double fraction = static_cast<double>(step) / count;
        si_->getStateSpace()->interpolate(s1, s2, fraction, state);
        if (si_->satisfiesBounds(state) && isFree(*occupancy_, a, embedding_.position(state)))
            return fraction;
    }
    return 0.0;
}

}  // namespace seahex
