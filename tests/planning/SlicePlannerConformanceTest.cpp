#include "support/PlannerConformance.h"

#include <seahex/planning/AntColony.h>
#include <seahex/planning/LayeredPlanner.h>

#include <gtest/gtest.h>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

template <class Planner>
PlannerUnderTest onSlices(const std::string &name, const std::function<void(Planner &)> &configure)
{
    PlannerUnderTest planner;
    planner.name = name;
    planner.arenas = "columns in R3";
    planner.make = [configure](const ob::SpaceInformationPtr &si)
    {
        auto made = std::make_shared<Planner>(si);
        made->setSlices(14);
        made->setAcross(12);
        made->setLevels(3);
        configure(*made);
        return made;
    };
    planner.deterministic = true;
    planner.finishes = true;
    planner.questionsBetweenLooks = 120;  // 16, and a motion of up to 100 states
    planner.progress = {"best cost REAL", "points INTEGER", "legs INTEGER"};
    planner.refusedSettings = {{"slices", "1"},
                               {"slices", "1001"},
                               {"slices", "-1"},
                               {"across", "1"},
                               {"levels", "1"},
                               {"neighbourhood", "4"},
                               {"neighbourhood", "1"},
                               {"neighbourhood", "11"},
                               {"K", "-0.01"},
                               {"K", "1.01"},
                               {"vehicle_length", "0"},
                               {"vehicle_length", "-1"},
                               {"K", "nan"},
                               {"vehicle_length", "nan"},
                               {"axis", "z"},
                               {"axis", ""}};
    return planner;
}

PlannerUnderTest layered(const std::string &name, const std::function<void(LayeredPlanner &)> &configure)
{
    PlannerUnderTest planner = onSlices<LayeredPlanner>(name, configure);
    planner.refusedSettings.emplace_back("mode", "hope");
    return planner;
}

PlannerUnderTest ants(const std::string &name, const std::function<void(AntColony &)> &configure)
{
    PlannerUnderTest planner = onSlices<AntColony>(name,
                                                   [configure](AntColony &colony)
                                                   {
                                                       colony.setIterations(4);
                                                       colony.setReach(6);
                                                       configure(colony);
                                                   });
    for (const char *parameter : {"evaporation", "alpha", "beta", "elite"})
        planner.refusedSettings.insert(planner.refusedSettings.end(), {{parameter, "-0.01"}, {parameter, "1001"}});
    for (const char *parameter : {"ants", "iterations", "reach"})
        planner.refusedSettings.insert(planner.refusedSettings.end(), {{parameter, "0"}, {parameter, "-1"}});
    return planner;
}

std::vector<PlannerUnderTest> everyPlanner()
{
    std::vector<PlannerUnderTest> planners = {
        layered("exact", [](LayeredPlanner &) {}),
        layered("exact, not optimised", [](LayeredPlanner &planner) { planner.setOptimise(false); }),
        layered("greedy", [](LayeredPlanner &planner) { planner.setMode(LayeredPlanner::Mode::Greedy); }),
        ants("ants", [](AntColony &) {}),
        ants("ants, not optimised", [](AntColony &colony) { colony.setOptimise(false); }),
    };
    planners[2].exceptions = {{"TheBestPairOfStatesWins", "walks into a dead end between two of them"}};
    return planners;
}

/// A check, for all planners.
struct Case
{
    PlannerCheck check;

    friend void PrintTo(const Case &one, std::ostream *out) { *out << one.check.name; }
};

std::vector<Case> everyCase()
{
    std::vector<Case> cases;
    for (const PlannerCheck &check : plannerChecks())
        cases.push_back({check});
    return cases;
}

class SlicePlannerConformance : public ::testing::TestWithParam<Case>
{
};

TEST_P(SlicePlannerConformance, Holds)
{
    const PlannerCheck &check = GetParam().check;
    for (const PlannerUnderTest &planner : everyPlanner())
    {
        Violations violations;
        const std::vector<PlannerArena> arenas = arenasFor(planner);
        ASSERT_FALSE(arenas.empty());
        for (const PlannerArena &arena : arenas)
            for (const std::string &violation : violationsOf(check, planner, arena))
                violations.push_back(violation);
        if (planner.exceptions.count(check.name) > 0)
        {
            EXPECT_FALSE(violations.empty()) << planner.name << " keeps it, and an exception says otherwise";
            continue;
        }
        for (const std::string &violation : violations)
            ADD_FAILURE() << planner.name << ", " << violation;
    }
}

INSTANTIATE_TEST_SUITE_P(Planners, SlicePlannerConformance, ::testing::ValuesIn(everyCase()),
                         [](const auto &test) { return test.param.check.name; });

}  // namespace
}  // namespace seahex::test
