#include "DiveCatalogue.h"

#include "Failure.h"
#include "PlannerCatalogue.h"

#include <seahex/planning/AntColony.h>
#include <seahex/planning/LayeredPlanner.h>
#include <seahex/planning/PrismAStar.h>

#include <algorithm>
#include <functional>
#include <map>
#include <sstream>

namespace ob = ompl::base;

namespace demos
{
namespace
{

using Maker = std::function<ob::PlannerPtr(const ob::SpaceInformationPtr &, const DivePlannerSettings &)>;

std::shared_ptr<seahex::SlicePlanner> sliced(const std::shared_ptr<seahex::SlicePlanner> &planner,
                                             const DivePlannerSettings &settings)
{
    planner->setLengthWeight(settings.lengthWeight);
    planner->setVehicleLength(settings.vehicleLengthM);
    planner->setSlices(settings.slices);
    planner->setAcross(settings.across);
    planner->setLevels(settings.levels);
    return planner;
}

ob::PlannerPtr makeLayered(const ob::SpaceInformationPtr &si, const DivePlannerSettings &settings,
                           seahex::LayeredPlanner::Mode mode)
{
    const auto planner = std::make_shared<seahex::LayeredPlanner>(si);
    planner->setMode(mode);
    return sliced(planner, settings);
}

ob::PlannerPtr makeAnts(const ob::SpaceInformationPtr &si, const DivePlannerSettings &settings)
{
    const auto planner = std::make_shared<seahex::AntColony>(si);
    planner->setSeed(settings.seed);
    return sliced(planner, settings);
}

ob::PlannerPtr makeExact(const ob::SpaceInformationPtr &si, const DivePlannerSettings &settings)
{
    return makeLayered(si, settings, seahex::LayeredPlanner::Mode::Exact);
}

ob::PlannerPtr makeGreedy(const ob::SpaceInformationPtr &si, const DivePlannerSettings &settings)
{
    return makeLayered(si, settings, seahex::LayeredPlanner::Mode::Greedy);
}

ob::PlannerPtr makePrisms(const ob::SpaceInformationPtr &si, const DivePlannerSettings &settings)
{
    const auto planner = std::make_shared<seahex::PrismAStar>(si);
    planner->setRings(settings.rings);
    planner->setCellSize(settings.cellSizeM);
    planner->setLayerThickness(settings.layerM);
    planner->setClimb(settings.climb);
    return planner;
}

/// This project's, which know dives only.
const std::map<std::string, Maker> &ownPlanners()
{
    static const std::map<std::string, Maker> planners = {{"AntColony", makeAnts},
                                                          {"LayeredPlanner", makeExact},
                                                          {"LayeredPlanner-greedy", makeGreedy},
                                                          {"PrismAStar", makePrisms}};
    return planners;
}

/// Those of the plane's catalogue that are at home in any space.
bool isOmpls(const std::string &name)
{
    return isPlannerName(name) && name != "HexAStar" && name != "SquareAStar";
}

}  // namespace

double sliceDistanceM(const seahex::Point3 &start, const seahex::Point3 &goal, unsigned slices)
{
    return std::max(seahex::horizontal(seahex::Point3(goal - start)).norm() / (slices - 1), 1e-3);
}

std::string divePlannerNames()
{
    std::string names;
    for (const auto &[name, make] : ownPlanners())
        names += (names.empty() ? "" : ", ") + name;
    std::istringstream all(plannerNames());
    for (std::string name; std::getline(all >> std::ws, name, ',');)
        names += isOmpls(name) ? ", " + name : "";
    return names;
}

bool isDivePlannerName(const std::string &name)
{
    return ownPlanners().count(name) > 0 || isOmpls(name);
}

bool plansOnSlices(const std::string &name)
{
    return ownPlanners().count(name) > 0 && !plansOnPrisms(name);
}

bool plansOnPrisms(const std::string &name)
{
    return name == "PrismAStar";
}

ob::PlannerPtr makeDivePlanner(const std::string &name, const ob::SpaceInformationPtr &si,
                               const DivePlannerSettings &settings)
{
    const auto own = ownPlanners().find(name);
    if (own != ownPlanners().end())
        return own->second(si, settings);
    if (!isOmpls(name))
        throw Failure(Exit::Usage, "there is no planner of dives '" + name + "'; known are " + divePlannerNames());
    return makePlanner(name, si);
}

}  // namespace demos
