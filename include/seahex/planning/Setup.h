#pragma once

#include <seahex/geometry/Point.h>
#include <seahex/world/Occupancy.h>

#include <ompl/base/StateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include <memory>

namespace seahex
{

/// A plain R^2 whose bounds are those of the occupancy's lattice.
ompl::base::StateSpacePtr planarSpace(const Occupancy &occupancy);

/// The cells of the occupancy's lattice as a space (HexStateSpace): planners see centres only.
/// @throws ompl::Exception as HexStateSpace
ompl::base::StateSpacePtr latticeSpace(const HexOccupancy &occupancy);

/// Makes a problem the occupancy's: validity checker, exact motion validator, and path length as the objective if there
/// is none yet (some planners would otherwise write their own into the shared problem).
/// @throws ompl::Exception if the setup's space is not planar (PlanarEmbedding)
void useOccupancy(ompl::geometric::SimpleSetup &setup, const std::shared_ptr<const Occupancy> &occupancy);

/// Start and goal as points of the plane; yaw 0 where states have one. In a HexStateSpace they become the cells that
/// the points lie in, and a path joins the centres of these; points outside its lattice are out of bounds, and no
/// planner takes them.
void setStartAndGoal(ompl::geometric::SimpleSetup &setup, const Point &start, const Point &goal);

}  // namespace seahex
