#include "seahex/planning/DiveStates.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Exception.h>

#include <algorithm>

namespace ob = ompl::base;

namespace seahex
{

void demandDiveSpace(const ob::StateSpace &space)
{
    if (dynamic_cast<const ob::RealVectorStateSpace *>(&space) == nullptr || space.getDimension() != 3)
        throw ompl::Exception("a dive needs a real vector space of three dimensions, and '" + space.getName() +
                              "' is none");
}

Point3 positionInWater(const ob::State *state)
{
    return Point3(state->as<ob::RealVectorStateSpace::StateType>()->values);
}

void placeInWater(ob::State *state, const Point3 &p)
{
    std::copy(p.data(), p.data() + 3, state->as<ob::RealVectorStateSpace::StateType>()->values);
}

}  // namespace seahex
