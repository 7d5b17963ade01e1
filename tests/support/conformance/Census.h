#pragma once

#include <seahex/geometry/HexLattice.h>

#include <ompl/base/StateSpace.h>

#include <memory>
#include <mutex>
#include <unordered_set>

namespace seahex::test
{

/// The states of a space that are alive. Several threads may allocate and free them.
class Census
{
public:
    void count(const ompl::base::State *state);
    void discount(const ompl::base::State *state);

    std::size_t size() const;
    bool has(const ompl::base::State *state) const;

private:
    mutable std::mutex mutex_;
    std::unordered_set<const ompl::base::State *> states_;
};

/// Shared, because a planner may keep states longer than it lives.
using CensusPtr = std::shared_ptr<Census>;

/// R^2 whose states are counted: a class derived from OMPL's, which planners take for it.
ompl::base::StateSpacePtr countingPlane(const Box &bounds, const CensusPtr &census);

/// R^3 over these bounds, from 0 to 4 high, whose states are counted.
ompl::base::StateSpacePtr countingSolid(const Box &bounds, const CensusPtr &census);

/// SE(2) whose states are counted. It is OMPL's class itself, because Dubins' and Reeds and Shepp's cars derive from it
/// and planners therefore may insist on it: what is in the census is the yaw of each state, not the state.
ompl::base::StateSpacePtr countingPoses(const Box &bounds, const CensusPtr &census);

/// The cells of a lattice, counted: a class derived from the library's.
ompl::base::StateSpacePtr countingCells(const HexLattice &lattice, const CensusPtr &census);

}  // namespace seahex::test
