#pragma once

#include <seahex/geometry/Point3.h>
#include <seahex/world/DiveArena.h>

#include <ompl/base/StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include <memory>

namespace seahex
{

/// R^3, x east, y north, z down, metres, within the arena's box (DiveArena::lowest, highest).
ompl::base::StateSpacePtr diveSpace(const DiveArena &arena);

/// Makes a problem the arena's: validity checker, exact motion validator, and path length as the objective if there is
/// none yet (some planners would otherwise write their own into the shared problem).
/// @throws ompl::Exception if the setup's space is not one of dives (DiveStates)
void useDiveArena(ompl::geometric::SimpleSetup &setup, const std::shared_ptr<const DiveArena> &arena);

/// Start and goal as positions in the water.
/// @throws ompl::Exception if the setup's space is not one of dives (DiveStates)
void setStartAndGoal(ompl::geometric::SimpleSetup &setup, const Point3 &start, const Point3 &goal);

}  // namespace seahex
