#include "PlannerCatalogue.h"

#include "Failure.h"

#include <seahex/planning/HexAStar.h>
#include <seahex/planning/SquareAStar.h>

#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>

#include <functional>
#include <map>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace demos
{
namespace
{

using Maker = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr &)>;

template <class Planner>
Maker maker()
{
    return [](const ob::SpaceInformationPtr &si)
    {
        return std::make_shared<Planner>(si);
    };
}

const std::map<std::string, Maker> &otherPlanners()
{
    static const std::map<std::string, Maker> planners = {{"ABITstar", maker<og::ABITstar>()},
                                                          {"AITstar", maker<og::AITstar>()},
                                                          {"BFMT", maker<og::BFMT>()},
                                                          {"BITstar", maker<og::BITstar>()},
                                                          {"FMT", maker<og::FMT>()},
                                                          {"InformedRRTstar", maker<og::InformedRRTstar>()},
                                                          {"LazyPRM", maker<og::LazyPRM>()},
                                                          {"LazyPRMstar", maker<og::LazyPRMstar>()},
                                                          {"PRM", maker<og::PRM>()},
                                                          {"PRMstar", maker<og::PRMstar>()},
                                                          {"RRT", maker<og::RRT>()},
                                                          {"RRTConnect", maker<og::RRTConnect>()},
                                                          {"RRTsharp", maker<og::RRTsharp>()},
                                                          {"RRTstar", maker<og::RRTstar>()},
                                                          {"SquareAStar", maker<seahex::SquareAStar>()}};
    return planners;
}

}  // namespace

std::string plannerNames()
{
    std::string names;
    for (const auto &[name, make] : otherPlanners())
        names += (names.empty() ? "" : ", ") + name;
    return names;
}

bool isPlannerName(const std::string &name)
{
    return name == "HexAStar" || otherPlanners().count(name) > 0;
}

ob::PlannerPtr makePlanner(const std::string &name, const ob::SpaceInformationPtr &si)
{
    if (name == "HexAStar")
        return std::make_shared<seahex::HexAStar>(si);
    const auto found = otherPlanners().find(name);
    if (found == otherPlanners().end())
        throw Failure(Exit::Usage, "there is no planner '" + name + "'; known are HexAStar, " + plannerNames());
    return found->second(si);
}

}  // namespace demos
