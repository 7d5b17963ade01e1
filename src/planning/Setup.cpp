#include "seahex/planning/Setup.h"

#include "seahex/planning/HexStateSpace.h"
#include "seahex/planning/OccupancyMotionValidator.h"
#include "seahex/planning/OccupancyValidityChecker.h"
#include "seahex/planning/PlanarEmbedding.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ob = ompl::base;

namespace seahex
{

ob::StateSpacePtr planarSpace(const Occupancy &occupancy)
{
    const Box box = occupancy.lattice().bounds();
    ob::RealVectorBounds bounds(2);
    for (unsigned int axis = 0; axis < 2; ++axis)
    {
        bounds.setLow(axis, box.min[axis]);
        bounds.setHigh(axis, box.max[axis]);
    }
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(bounds);
    return space;
}

ob::StateSpacePtr latticeSpace(const HexOccupancy &occupancy)
{
    return std::make_shared<HexStateSpace>(occupancy.lattice());
}

void useOccupancy(ompl::geometric::SimpleSetup &setup, const std::shared_ptr<const Occupancy> &occupancy)
{
    const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
    si->setStateValidityChecker(std::make_shared<OccupancyValidityChecker>(si, occupancy));
    si->setMotionValidator(std::make_shared<OccupancyMotionValidator>(si, occupancy));
    if (!setup.getProblemDefinition()->hasOptimizationObjective())
        setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
}

void setStartAndGoal(ompl::geometric::SimpleSetup &setup, const Point &start, const Point &goal)
{
    const PlanarEmbedding embedding(setup.getStateSpace().get());
    ob::ScopedState<> from(setup.getStateSpace());
    ob::ScopedState<> to(setup.getStateSpace());
    embedding.place(from.get(), start);
    embedding.place(to.get(), goal);
    setup.setStartAndGoalStates(from, to);
}

}  // namespace seahex
