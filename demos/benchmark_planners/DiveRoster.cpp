#include "DiveRoster.h"

#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <seahex/planning/PrismAStar.h>

#include <functional>
#include <stdexcept>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace benchmark_planners
{
namespace
{

using Maker = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr &, const demos::DivePlannerSettings &)>;

struct Entry
{
    const char *name;
    Maker make;
    Finish finish = Finish::None;
};

/// One of the catalogue's planners with its defaults.
Maker plain(const char *name)
{
    return [name](const ob::SpaceInformationPtr &si, const demos::DivePlannerSettings &settings)
    {
        return demos::makeDivePlanner(name, si, settings);
    };
}

/// As it comes, but for a vehicle that climbs a fifth of its way over ground at most (11 degrees).
ob::PlannerPtr climbingPrisms(const ob::SpaceInformationPtr &si, const demos::DivePlannerSettings &)
{
    auto planner = std::make_shared<seahex::PrismAStar>(si);
    planner->setClimb(0.2);
    return planner;
}

/// As it comes, but without pruning. Over hundreds of miles of shallow water few samples can better a path, so they
/// pile up, and OMPL 1.5.2 prunes them one by one, for minutes, without a look at the clock.
ob::PlannerPtr unprunedTrees(const ob::SpaceInformationPtr &si, const demos::DivePlannerSettings &)
{
    auto planner = std::make_shared<og::BITstar>(si);
    planner->setPruning(false);
    return planner;
}

/// To compare another planner, add its line.
const std::vector<Entry> &roster()
{
    static const std::vector<Entry> entries = {
        {"LayeredPlanner-greedy", plain("LayeredPlanner-greedy")},
        {"LayeredPlanner-exact", plain("LayeredPlanner")},
        {"AntColony", plain("AntColony")},
        {"PrismAStar", plain("PrismAStar")},
        {"PrismAStar-climb", climbingPrisms},
        {"RRTConnect+simplify", plain("RRTConnect"), Finish::Simplify},
        {"RRTstar", plain("RRTstar")},
        {"InformedRRTstar", plain("InformedRRTstar")},
        {"PRMstar", plain("PRMstar")},
        {"BITstar", unprunedTrees},
    };
    return entries;
}

}  // namespace

std::vector<std::string> diveRosterNames()
{
    std::vector<std::string> names;
    for (const Entry &entry : roster())
        names.emplace_back(entry.name);
    return names;
}

std::shared_ptr<RecordedPlanner> makeFromDiveRoster(const std::string &name, const ob::SpaceInformationPtr &si,
                                                    const demos::DivePlannerSettings &settings)
{
    for (const Entry &entry : roster())
        if (entry.name == name)
            return std::make_shared<RecordedPlanner>(name, entry.make(si, settings), entry.finish);
    throw std::out_of_range("there is no planner of dives " + name);
}

}  // namespace benchmark_planners
