#include "support/conformance/Footing.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ob = ompl::base;

namespace seahex::test
{

Footing::Footing(const ob::StateSpace *space)
{
    const auto *plain = dynamic_cast<const ob::RealVectorStateSpace *>(space);
    if (plain == nullptr || plain->getDimension() != 3)
        planar_.emplace(space);
}

void Footing::place(ob::State *state, const Point &p, double heading) const
{
    if (planar_)
        return planar_->place(state, p, heading);
    double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    values[0] = p.x();
    values[1] = p.y();
    values[2] = 1.7;
}

Point Footing::position(const ob::State *state) const
{
    if (planar_)
        return planar_->position(state);
    const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    return {values[0], values[1]};
}

}  // namespace seahex::test
