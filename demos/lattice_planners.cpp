// HexAStar and OMPL's planners on the cells of a hexagonal lattice: a discrete state space, two walls, and what each
// planner's path costs.

#include <seahex/planning/HexAStar.h>
#include <seahex/planning/Setup.h>
#include <seahex/world/OccupancyBuilder.h>

#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include <iomanip>
#include <iostream>

namespace ob = ompl::base;
namespace og = ompl::geometric;

seahex::Shape wall(const seahex::Point &from, const seahex::Point &to)
{
    seahex::Shape shape;
    shape.lines = {{from, to}};
    return shape;
}

int main()
{
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);

    // Two walls across a square of 100 by 100, with a gap at opposite ends. A cell is blocked if a wall touches it.
    seahex::OccupancyBuilder builder(seahex::HexLattice::covering({{0, 0}, {100, 100}}, 2.5));
    builder.block(wall({32, 0}, {32, 80}), 2.0);
    builder.block(wall({66, 100}, {66, 20}), 2.0);
    const auto occupancy = builder.build();

    // A state is a cell, a motion the straight line between two centres.
    og::SimpleSetup setup(seahex::latticeSpace(*occupancy));
    seahex::useOccupancy(setup, occupancy);
    seahex::setStartAndGoal(setup, {10, 10}, {90, 90});

    const ob::SpaceInformationPtr &si = setup.getSpaceInformation();
    const std::vector<ob::PlannerPtr> planners = {
        std::make_shared<seahex::HexAStar>(si), std::make_shared<og::RRTConnect>(si), std::make_shared<og::RRTstar>(si),
        std::make_shared<og::PRMstar>(si),
        // any other planner of OMPL's: a line here
    };

    std::cout << "planner       cost  legs\n" << std::fixed << std::setprecision(1);
    for (const ob::PlannerPtr &planner : planners)
    {
        setup.clear();
        setup.setPlanner(planner);
        if (setup.solve(1.0) != ob::PlannerStatus::EXACT_SOLUTION)
            return 1;
        const og::PathGeometric &path = setup.getSolutionPath();
        std::cout << std::left << std::setw(12) << planner->getName() << std::right << std::setw(6)
                  << path.cost(setup.getOptimizationObjective()).value() << std::setw(6) << path.getStateCount() - 1
                  << '\n';
    }
    return 0;
}
