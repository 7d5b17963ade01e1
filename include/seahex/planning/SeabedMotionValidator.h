#pragma once

#include <seahex/world/DiveArena.h>

#include <ompl/base/MotionValidator.h>

#include <memory>
#include <utility>

namespace seahex
{

/// A motion is valid if its whole straight line is free in the arena (DiveArena), and both its ends are within the
/// space's bounds: exact, without a sampling resolution, symmetric. Const; thread-safe but for OMPL's own counters of
/// valid and invalid motions, which may miss some where several threads ask.
class SeabedMotionValidator : public ompl::base::MotionValidator
{
public:
    /// @throws ompl::Exception if the space is not one of dives (DiveStates)
    SeabedMotionValidator(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<const DiveArena> arena);

    bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2) const override;

    /// If the motion is invalid, lastValid.second is the largest fraction of it that is valid, to a 2^-40th of the way,
    /// and lastValid.first, if not null, the state there; it may be s2 itself. The motion from s1 to that state is
    /// itself valid. 0 and s1 where s1 is invalid.
    bool checkMotion(const ompl::base::State *s1, const ompl::base::State *s2,
                     std::pair<ompl::base::State *, double> &lastValid) const override;

    const std::shared_ptr<const DiveArena> &arena() const { return arena_; }

private:
    bool isValid(const ompl::base::State *s1, const ompl::base::State *s2) const;

    std::shared_ptr<const DiveArena> arena_;
};

}  // namespace seahex
