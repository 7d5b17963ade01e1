#pragma once

#include <seahex/world/DiveArena.h>

#include <ompl/base/StateValidityChecker.h>

#include <memory>

namespace seahex
{

/// A state is valid if its position is free in the arena, and within the space's bounds. Const, cache-free,
/// thread-safe.
class SeabedValidityChecker : public ompl::base::StateValidityChecker
{
public:
    /// @throws ompl::Exception if the space is not one of dives (DiveStates)
    SeabedValidityChecker(const ompl::base::SpaceInformationPtr &si, std::shared_ptr<const DiveArena> arena);

    bool isValid(const ompl::base::State *state) const override;
    bool isValid(const ompl::base::State *state, double &dist) const override;

    /// DiveArena::room, metres straight up or down: not more than that is left, but a slope may be nearer.
    double clearance(const ompl::base::State *state) const override;

    const std::shared_ptr<const DiveArena> &arena() const { return arena_; }

private:
    std::shared_ptr<const DiveArena> arena_;
};

}  // namespace seahex
