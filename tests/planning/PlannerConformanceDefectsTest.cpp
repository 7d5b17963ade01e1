#include "support/PlannerConformance.h"
#include "support/conformance/SpoiltPlanner.h"

#include <ompl/geometric/planners/prm/PRMstar.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// The checks are checked: a healthy planner passes them all, and each of them finds a defect.

PlannerUnderTest spoilt(const std::function<void(SpoiltPlanner &)> &spoil)
{
    PlannerUnderTest planner;
    planner.name = "Textbook";
    planner.make = [spoil](const ob::SpaceInformationPtr &si)
    {
        auto made = std::make_shared<SpoiltPlanner>(si);
        spoil(*made);
        return made;
    };
    planner.deterministic = true;
    planner.finishes = true;
    planner.optimal = true;
    planner.questionsBetweenLooks = 300;
    planner.progress = {"best cost REAL", "expanded INTEGER"};
    planner.refusedSettings = {{"points", "9"}, {"points", "1001"}};
    planner.arenas = "(bay|discs) in R2";
    return planner;
}

PlannerUnderTest healthy()
{
    return spoilt([](SpoiltPlanner &) {});
}

const PlannerCheck &checkNamed(const std::string &name)
{
    const auto &checks = plannerChecks();
    const auto found =
        std::find_if(checks.begin(), checks.end(), [&](const auto &check) { return check.name == name; });
    if (found == checks.end())
        throw std::runtime_error("there is no check " + name);
    return *found;
}

/// What the check says of the planner, in the first arena where it says these words, or else in all.
std::string verdict(const std::string &check, const PlannerUnderTest &planner, const std::string &words)
{
    std::string said;
    for (const PlannerArena &arena : arenasFor(planner))
    {
        for (const std::string &violation : violationsOf(checkNamed(check), planner, arena))
            said += violation + "\n";
        if (said.find(words) != std::string::npos)
            break;
    }
    return said;
}

std::vector<Defect> everyDefect()
{
    std::vector<Defect> defects = lifecycleDefects();
    for (const auto &more : {budgetDefects(), answerDefects(), reportDefects()})
        defects.insert(defects.end(), more.begin(), more.end());
    return defects;
}

TEST(PlannerConformanceDefects, AHealthyPlannerHasNone)
{
    PlannerUnderTest planner = healthy();
    planner.arenas = "(bay|strait|open|archipelago|discs) in (R2|SE2)";
    for (const PlannerArena &arena : arenasFor(planner))
        for (const PlannerCheck &check : plannerChecks())
            for (const std::string &violation : violationsOf(check, planner, arena))
                ADD_FAILURE() << check.name << ": " << violation;
}

TEST(PlannerConformanceDefects, EachIsFound)
{
    for (const Defect &defect : everyDefect())
        for (const auto &[check, words] : defect.foundBy)
        {
            const std::string said = verdict(check, spoilt(defect.spoil), words);
            EXPECT_NE(said.find(words), std::string::npos)
                << defect.name << ": " << check << " does not say '" << words << "', but\n"
                << said;
        }
}

/// Two that are no defects of a planner in itself: a space that it should refuse, and a promise that is too great.
TEST(PlannerConformanceDefects, FalsePromisesAreFound)
{
    PlannerUnderTest everywhere = healthy();
    everywhere.make = [](const ob::SpaceInformationPtr &si)
    {
        return std::make_shared<ompl::geometric::PRMstar>(si);
    };
    EXPECT_NE(verdict("AForeignSpaceIsRefused", everywhere, "R^3"), "");

    for (const bool isOptimal : {false, true})
    {
        PlannerUnderTest best = healthy();
        best.rings = 3;
        best.optimal = isOptimal;
        EXPECT_NE(verdict("TheCostIsTheOptimum", best, "the optimum of the lattice is"), "");
    }
}

TEST(PlannerConformanceDefects, EveryCheckFindsOne)
{
    std::set<std::string> proven = {"AForeignSpaceIsRefused", "TheCostIsTheOptimum"};
    for (const Defect &defect : everyDefect())
        for (const auto &found : defect.foundBy)
            proven.insert(found.first);
    for (const PlannerCheck &check : plannerChecks())
        EXPECT_EQ(proven.count(check.name), 1u) << check.name << " was never seen to fail";
}

}  // namespace
}  // namespace seahex::test
