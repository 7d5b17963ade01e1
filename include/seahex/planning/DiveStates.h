#pragma once

#include <seahex/geometry/Point3.h>

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>

namespace seahex
{

// States of a dive: R^3, x east, y north, z down, metres.

/// @throws ompl::Exception if the space is not a RealVectorStateSpace of three dimensions
void demandDiveSpace(const ompl::base::StateSpace &space);

Point3 positionInWater(const ompl::base::State *state);

void placeInWater(ompl::base::State *state, const Point3 &p);

}  // namespace seahex
