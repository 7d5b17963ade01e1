// Plans around two walls with no chart: any R^2 problem with a validity checker of your own will do.

#include <seahex/planning/HexAStar.h>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include <iostream>

namespace ob = ompl::base;
namespace og = ompl::geometric;

// Two walls across a square of 100 by 100, with a gap at opposite ends.
bool isValid(const ob::State *state)
{
    const double *p = state->as<ob::RealVectorStateSpace::StateType>()->values;
    const bool inFirstWall = p[0] > 30 && p[0] < 34 && p[1] < 80;
    const bool inSecondWall = p[0] > 64 && p[0] < 68 && p[1] > 20;
    return !inFirstWall && !inSecondWall;
}

int main()
{
    auto space = std::make_shared<ob::RealVectorStateSpace>(2);
    space->setBounds(0, 100);
    og::SimpleSetup setup(space);
    setup.setStateValidityChecker(isValid);
    // OMPL asks about points along a motion: these lie 0.14 apart, or a leg could cut off the corner of a wall.
    setup.getSpaceInformation()->setStateValidityCheckingResolution(0.001);

    ob::ScopedState<> start(space), goal(space);
    start[0] = 10, start[1] = 10;
    goal[0] = 90, goal[1] = 90;
    setup.setStartAndGoalStates(start, goal);

    auto planner = std::make_shared<seahex::HexAStar>(setup.getSpaceInformation());
    planner->setRings(3);
    setup.setPlanner(planner);

    if (!setup.solve(10.0))
        return 1;
    setup.getSolutionPath().printAsMatrix(std::cout);
    std::cout << "length " << setup.getSolutionPath().length() << ", cell size " << planner->cellSize() << ", "
              << planner->counters().expanded << " cells expanded\n";
    return 0;
}
