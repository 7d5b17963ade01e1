#include "seahex/planning/DiveSetup.h"

#include "seahex/planning/DiveStates.h"
#include "seahex/planning/SeabedMotionValidator.h"
#include "seahex/planning/SeabedValidityChecker.h"

#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ob = ompl::base;

namespace seahex
{

ob::StateSpacePtr diveSpace(const DiveArena &arena)
{
    ob::RealVectorBounds bounds(3);
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
        bounds.setLow(axis, arena.lowest()[axis]);
        bounds.setHigh(axis, arena.highest()[axis]);
    }
    auto space = std::make_shared<ob::RealVectorStateSpace>(3);
    space->setBounds(bounds);
    return space;
}

void useDiveArena(ompl::geometric::SimpleSetup &setup, const std::shared_ptr<const DiveArena> &arena)
{
    const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
    si->setStateValidityChecker(std::make_shared<SeabedValidityChecker>(si, arena));
    si->setMotionValidator(std::make_shared<SeabedMotionValidator>(si, arena));
    if (!setup.getProblemDefinition()->hasOptimizationObjective())
        setup.setOptimizationObjective(std::make_shared<ob::PathLengthOptimizationObjective>(si));
}

void setStartAndGoal(ompl::geometric::SimpleSetup &setup, const Point3 &start, const Point3 &goal)
{
    demandDiveSpace(*setup.getStateSpace());
    ob::ScopedState<> from(setup.getStateSpace());
    ob::ScopedState<> to(setup.getStateSpace());
    placeInWater(from.get(), start);
    placeInWater(to.get(), goal);
    setup.setStartAndGoalStates(from, to);
}

}  // namespace seahex
