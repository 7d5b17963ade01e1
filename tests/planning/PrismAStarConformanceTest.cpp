#include "support/PlannerConformance.h"

#include <seahex/planning/PrismAStar.h>

#include <gtest/gtest.h>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

PlannerUnderTest prisms(const std::string &name, bool smoothing, double climb)
{
    PlannerUnderTest planner;
    planner.name = name;
    planner.arenas = "columns in R3";
    planner.make = [=](const ob::SpaceInformationPtr &si)
    {
        auto made = std::make_shared<PrismAStar>(si);
        made->setRings(1);
        made->setCellSize(1.0);
        made->setLayerThickness(2.0);
        made->setSmoothing(smoothing);
        made->setClimb(climb);
        return made;
    };
    planner.deterministic = true;
    planner.finishes = true;
    planner.questionsBetweenLooks = 120;  // 16, and a motion of up to 100 states
    planner.progress = {"best cost REAL", "expanded INTEGER", "open INTEGER"};
    planner.refusedSettings = {{"rings", "0"},
                               {"rings", "4"},
                               {"rings", "-1"},
                               {"cell_size", "-1"},
                               {"cell_size", "nan"},
                               {"layer_thickness", "-0.1"},
                               {"layer_thickness", "inf"},
                               {"climb", "-1"},
                               {"climb", "nan"}};
    return planner;
}

std::vector<PlannerUnderTest> everyPlanner()
{
    return {prisms("prisms", true, 0.0), prisms("prisms, not smoothed", false, 0.0),
            prisms("prisms of little climb", true, 1.5)};
}

class PrismAStarConformance : public ::testing::TestWithParam<std::string>
{
};

TEST_P(PrismAStarConformance, Holds)
{
    for (const PlannerCheck &check : plannerChecks())
    {
        if (check.name != GetParam())
            continue;
        for (const PlannerUnderTest &planner : everyPlanner())
        {
            const std::vector<PlannerArena> arenas = arenasFor(planner);
            ASSERT_FALSE(arenas.empty());
            for (const PlannerArena &arena : arenas)
                for (const std::string &violation : violationsOf(check, planner, arena))
                    ADD_FAILURE() << planner.name << ", " << violation;
        }
    }
}

std::vector<std::string> everyCheck()
{
    std::vector<std::string> names;
    for (const PlannerCheck &check : plannerChecks())
        names.push_back(check.name);
    return names;
}

INSTANTIATE_TEST_SUITE_P(Planners, PrismAStarConformance, ::testing::ValuesIn(everyCheck()),
                         [](const auto &test) { return test.param; });

}  // namespace
}  // namespace seahex::test
