#include "Roster.h"

#include "common/PlannerCatalogue.h"

#include <ompl/geometric/planners/fmt/FMT.h>
#include <seahex/planning/HexAStar.h>

#include <functional>
#include <stdexcept>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace benchmark_planners
{
namespace
{

using Maker = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr &)>;

struct Entry
{
    const char *name;
    Maker make;
    Finish finish = Finish::None;
};

/// One of the catalogue's planners as it comes, with OMPL's defaults.
Maker plain(const char *name)
{
    return [name](const ob::SpaceInformationPtr &si)
    {
        return demos::makePlanner(name, si);
    };
}

/// The lattice's best path for a number of rings and nothing after it.
Maker lattice(int rings)
{
    return [rings](const ob::SpaceInformationPtr &si)
    {
        auto planner = std::make_shared<seahex::HexAStar>(si);
        planner->setRings(rings);
        planner->setAnytime(false);
        planner->setSmoothing(false);
        return planner;
    };
}

Maker fastMarchingTree(unsigned samples)
{
    return [samples](const ob::SpaceInformationPtr &si)
    {
        auto planner = std::make_shared<og::FMT>(si);
        planner->setNumSamples(samples);
        return planner;
    };
}

/// To compare another planner, add its line.
const std::vector<Entry> &roster()
{
    static const std::vector<Entry> entries = {
        {"HexAStar", plain("HexAStar")},
        {"HexAStar-1", lattice(1)},
        {"HexAStar-2", lattice(2)},
        {"HexAStar-3", lattice(3)},
        {"RRTConnect+simplify", plain("RRTConnect"), Finish::Simplify},
        {"RRTstar", plain("RRTstar")},
        {"InformedRRTstar", plain("InformedRRTstar")},
        {"PRMstar", plain("PRMstar")},
        {"LazyPRMstar", plain("LazyPRMstar")},
        {"FMT-1000", fastMarchingTree(1000)},
        {"FMT-10000", fastMarchingTree(10000)},
        {"BITstar", plain("BITstar")},
        {"ABITstar", plain("ABITstar")},
        {"AITstar", plain("AITstar")},
    };
    return entries;
}

}  // namespace

std::vector<std::string> rosterNames()
{
    std::vector<std::string> names;
    for (const Entry &entry : roster())
        names.emplace_back(entry.name);
    return names;
}

std::shared_ptr<RecordedPlanner> makeFromRoster(const std::string &name, const ob::SpaceInformationPtr &si)
{
    for (const Entry &entry : roster())
        if (entry.name == name)
            return std::make_shared<RecordedPlanner>(name, entry.make(si), entry.finish);
    throw std::out_of_range("there is no planner " + name);
}

}  // namespace benchmark_planners
