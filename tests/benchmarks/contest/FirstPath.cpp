#include "contest/FirstPath.h"

#include "contest/Median.h"

#include <seahex/planning/HexAStar.h>
#include <seahex/planning/Setup.h>

#include <ompl/util/Console.h>

#include <stdexcept>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::contest
{

double firstPathMs(const Course &course)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const HexLattice &lattice = course.world().occupancy->lattice();
    std::vector<double> ms;
    for (const Query &query : course.queries())
    {
        og::SimpleSetup setup(planarSpace(*course.world().occupancy));
        useOccupancy(setup, course.world().occupancy);
        setStartAndGoal(setup, lattice.centre(query.start), lattice.centre(query.goal));
        const auto planner = std::make_shared<HexAStar>(setup.getSpaceInformation());
        setup.setPlanner(planner);
        setup.setup();
        // asks no clock: the first path is what counts, and the planner notes when it had it
        planner->solve(ob::PlannerTerminationCondition([&planner] { return !planner->improvements().empty(); }));
        if (planner->improvements().empty())
            throw std::runtime_error("HexAStar found no path on " + course.world().name);
        ms.push_back(1e3 * planner->improvements().front().seconds);
    }
    return medianOf(std::move(ms));
}

}  // namespace seahex::contest
