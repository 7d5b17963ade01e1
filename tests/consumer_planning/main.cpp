// Plans across a plain square and prints the path's length.

#include <seahex/planning/HexAStar.h>

#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/SimpleSetup.h>

#include <iostream>

int main()
{
    auto space = std::make_shared<ompl::base::RealVectorStateSpace>(2);
    space->setBounds(0.0, 100.0);
    ompl::geometric::SimpleSetup setup(space);
    setup.setStateValidityChecker([](const ompl::base::State *) { return true; });
    ompl::base::ScopedState<> start(space), goal(space);
    start[0] = start[1] = 10.0;
    goal[0] = goal[1] = 90.0;
    setup.setStartAndGoalStates(start, goal);
    setup.setPlanner(std::make_shared<seahex::HexAStar>(setup.getSpaceInformation()));
    if (!setup.solve(10.0))
        return 1;
    std::cout << "length " << setup.getSolutionPath().length() << "\n";
    return 0;
}
