#include "seahex/planning/PlanarEmbedding.h"

#include "seahex/planning/HexStateSpace.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/util/Exception.h>

#include <typeinfo>

namespace ob = ompl::base;

namespace seahex
{

PlanarEmbedding::PlanarEmbedding(const ob::StateSpace *space)
    : space_(space), hasHeading_(space != nullptr && typeid(*space) == typeid(ob::SE2StateSpace))
{
    if (const auto *cells = dynamic_cast<const HexStateSpace *>(space))
        lattice_ = &cells->lattice();
    const auto *plane = dynamic_cast<const ob::RealVectorStateSpace *>(space);
    if (!hasHeading_ && lattice_ == nullptr && (plane == nullptr || plane->getDimension() != 2))
        throw ompl::Exception("seahex", "the space '" + (space == nullptr ? std::string("null") : space->getName()) +
                                            "' is neither R^2 nor SE(2) nor a HexStateSpace: its states have no place "
                                            "on a lattice");
}

Point PlanarEmbedding::position(const ob::State *state) const
{
    if (hasHeading_)
    {
        const auto *pose = state->as<ob::SE2StateSpace::StateType>();
        return {pose->getX(), pose->getY()};
    }
    if (lattice_ != nullptr)
        return lattice_->centre(state->as<HexStateSpace::StateType>()->cell());
    const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    return {values[0], values[1]};
}

double PlanarEmbedding::heading(const ob::State *state) const
{
    return hasHeading_ ? state->as<ob::SE2StateSpace::StateType>()->getYaw() : 0.0;
}

void PlanarEmbedding::place(ob::State *state, const Point &position, double heading) const
{
    if (hasHeading_)
    {
        auto *pose = state->as<ob::SE2StateSpace::StateType>();
        pose->setXY(position.x(), position.y());
        pose->setYaw(heading);
        // due west is pi for atan2 and -pi for this space, which asserts that states are within its bounds
        const auto *poses = space_->as<ob::SE2StateSpace>();
        poses->as<ob::SO2StateSpace>(1)->enforceBounds(pose->components[1]);
        return;
    }
    if (lattice_ != nullptr)
    {
        state->as<HexStateSpace::StateType>()->setCell(lattice_->cellAt(position));
        return;
    }
    double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    values[0] = position.x();
    values[1] = position.y();
}

Box PlanarEmbedding::bounds() const
{
    if (lattice_ != nullptr)
        return lattice_->bounds();
    const ob::RealVectorBounds &b = hasHeading_ ? space_->as<ob::SE2StateSpace>()->getBounds()
                                                : space_->as<ob::RealVectorStateSpace>()->getBounds();
    return {Point(b.low[0], b.low[1]), Point(b.high[0], b.high[1])};
}

double PlanarEmbedding::lengthWeight() const
{
    return hasHeading_ ? space_->as<ob::SE2StateSpace>()->getSubspaceWeight(0) : 1.0;
}

}  // namespace seahex
