#include "support/PlannerConformance.h"

#include <seahex/planning/HexAStar.h>
#include <seahex/planning/SquareAStar.h>

#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/util/RandomNumbers.h>

#include <gtest/gtest.h>

#include <set>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

/// OMPL's planners draw the same numbers in every run: the seed has to be set before the first of them.
[[maybe_unused]] const bool isSeeded = []
{
    ompl::RNG::setSeed(2);
    return true;
}();

/// What HexAStar and SquareAStar promise alike.
PlannerUnderTest latticeAStar(const std::string &name)
{
    PlannerUnderTest planner;
    planner.name = name;
    planner.deterministic = true;
    planner.finishes = true;
    planner.questionsBetweenLooks = 120;  // a motion of half a turn, and 13 before it
    planner.progress = {"best cost REAL", "lower bound REAL", "expanded INTEGER", "open INTEGER"};
    planner.refusedSettings = {
        {"guidance", "hope"}, {"guidance", ""}, {"jumps", "hop"}, {"jumps", ""}, {"cell_size", "-0.01"}};
    return planner;
}

/// HexAStar; where there is no chart its cells are small enough for the arenas' gaps and not many.
PlannerUnderTest hexAStar(const std::string &name, int rings, const std::function<void(HexAStar &)> &configure)
{
    PlannerUnderTest planner = latticeAStar(name);
    planner.make = [rings, configure](const ob::SpaceInformationPtr &si)
    {
        auto made = std::make_shared<HexAStar>(si);
        made->setCellSize(1.0);
        made->setRings(rings);
        configure(*made);
        return made;
    };
    planner.rings = rings;
    planner.refusedSettings.insert(planner.refusedSettings.end(), {{"rings", "0"}, {"rings", "4"}});
    planner.arenas = "(bay|strait|open|archipelago|ocean|discs) .*";
    return planner;
}

std::vector<PlannerUnderTest> everyHexAStar()
{
    const auto asItComes = [](HexAStar &) {
    };
    const auto lattice = [](HexAStar &planner)
    {
        planner.setAnytime(false);
        planner.setSmoothing(false);
    };
    const auto blind = [](HexAStar &planner)
    {
        planner.setGuidance(Guidance::None);
        planner.setSmoothing(false);
    };
    const auto indirect = [](HexAStar &planner)
    {
        planner.setDirect(false);
        planner.setGuidance(Guidance::TieBreak);
    };
    const auto approximate = [](HexAStar &planner)
    {
        planner.setApproximate(true);
        planner.setAllJumps(true);
        planner.setGuidance(Guidance::Cheng);  // which may miss the optimum
    };
    // finer than the chart's cells, whose gaps are otherwise too narrow
    const auto onSquares = [](HexAStar &planner)
    {
        planner.setCellSize(0.3);
    };
    std::vector<PlannerUnderTest> planners = {
        hexAStar("as it comes", 3, asItComes),           hexAStar("neither anytime nor smoothing", 3, lattice),
        hexAStar("no guidance, no smoothing", 1, blind), hexAStar("not direct", 3, indirect),
        hexAStar("approximate", 2, approximate),         hexAStar("on a chart of squares", 2, onSquares),
    };
    planners[1].optimal = true;
    planners[2].optimal = true;
    planners[4].rings = 0;
    planners[2].arenas = planners[4].arenas = "(bay|strait|discs) .*";
    planners[5].arenas = "square bay in (R2|SE2)";
    return planners;
}

PlannerUnderTest squareAStar(const std::string &name, int neighbours,
                             const std::function<void(SquareAStar &)> &configure)
{
    PlannerUnderTest planner = latticeAStar(name);
    planner.make = [neighbours, configure](const ob::SpaceInformationPtr &si)
    {
        auto made = std::make_shared<SquareAStar>(si);
        made->setCellSize(1.0);
        made->setNeighbours(neighbours);
        configure(*made);
        return made;
    };
    planner.neighbours = neighbours;
    planner.refusedSettings.insert(planner.refusedSettings.end(),
                                   {{"neighbours", "0"}, {"neighbours", "5"}, {"neighbours", "16"}});
    planner.arenas = "(square .*|discs) in (R2|SE2)";
    return planner;
}

std::vector<PlannerUnderTest> everySquareAStar()
{
    const auto asItComes = [](SquareAStar &) {
    };
    const auto lattice = [](SquareAStar &planner)
    {
        planner.setSmoothing(false);
    };
    const auto blind = [](SquareAStar &planner)
    {
        planner.setGuidance(Guidance::None);
        planner.setSmoothing(false);
    };
    const auto indirect = [](SquareAStar &planner)
    {
        planner.setDirect(false);
        planner.setGuidance(Guidance::TieBreak);
    };
    const auto approximate = [](SquareAStar &planner)
    {
        planner.setApproximate(true);
        planner.setGuidance(Guidance::Wang);
    };
    const auto onHexagons = [](SquareAStar &planner)
    {
        planner.setCellSize(0.25);
    };
    std::vector<PlannerUnderTest> planners = {
        squareAStar("as it comes", 8, asItComes),
        squareAStar("no smoothing", 8, lattice),
        squareAStar("4 neighbours, no guidance, no smoothing", 4, blind),
        squareAStar("not direct", 8, indirect),
        squareAStar("approximate", 8, approximate),
        squareAStar("on a chart of hexagons", 8, onHexagons),
    };
    planners[1].optimal = true;
    planners[2].optimal = true;
    planners[4].arenas = "(square bay|discs) in (R2|SE2)";
    planners[5].arenas = "bay in (R2|SE2)";
    return planners;
}

/// BIT* whose progress may be read while it runs.
class SafeBitStar : public og::BITstar
{
public:
    explicit SafeBitStar(const ob::SpaceInformationPtr &si) : og::BITstar(si)
    {
        plannerProgressProperties_.clear();
        addPlannerProgressProperty("best cost REAL", [this] { return std::to_string(bestCost().value()); });
    }
};

// What OMPL 1.5.2's own planners do not keep, as found by these checks.

PlannerUnderTest bitStar()
{
    PlannerUnderTest planner;
    planner.name = "BitStar";
    planner.arenas = "(bay|discs) .*";
    planner.make = [](const ob::SpaceInformationPtr &si)
    {
        return std::make_shared<SafeBitStar>(si);
    };
    planner.questionsBetweenLooks = 2000;
    planner.freesEveryState = false;
    const std::string timeout = "answers TIMEOUT";
    const std::string waits = "waits for a valid one as long as there is time";
    const std::string tolls = "leaves the costs of start and goal out of the solution's";
    planner.exceptions = {
        {"AForeignSpaceIsRefused", "plans in any space"},
        {"AProblemWithoutObjectiveStaysWithout", "writes path length into the problem"},
        {"ARegionWithNoEndOfSamples", "takes all samples of a goal before it begins"},
        {"AnInvalidGoalIsTold", timeout},
        {"AnInvalidStartIsTold", timeout},
        {"AnUnknownGoalTypeIsTold", "throws"},
        {"AnotherObjectiveIsNoticed", tolls},
        {"AnotherProblemIsNoticed", "goes on with the states of the first problem"},
        {"EveryGoalThatIsExportedIsMarked", "marks the goal of its best path only"},
        {"EveryVertexHangsTogetherWithAStart", "exports samples as well"},
        {"EverythingInTheRangesIsTaken", "some parameters exclude each other"},
        {"NoValidGoalOfSeveralIsTold", timeout},
        {"NoValidStartOfSeveralIsTold", timeout},
        {"OneValidStartIsEnough", waits},
        {"ReportsArePathsFromStartToGoal", "reports paths from goal to start"},
        {"SetupAtAnyTime", "does not mark the solution as optimised after a second setup"},
        {"TheBestCostIsTheSolutions", "has a best cost of 0 before there is a problem"},
        {"TheBestPairOfStatesWins", waits},
        {"TollsAtBothEndsCount", tolls},
        {"WeightsAreCosts", "exports weights of 1"},
    };
    return planner;
}

PlannerUnderTest prmStar()
{
    PlannerUnderTest planner;
    planner.name = "PrmStar";
    planner.arenas = "(bay|discs) .*";
    planner.make = [](const ob::SpaceInformationPtr &si)
    {
        return std::make_shared<og::PRMstar>(si);
    };
    planner.questionsBetweenLooks = 2000;
    const std::string first = "keeps the objective of the first problem";
    const std::string hurry = "looks for a path only while there is time";
    planner.exceptions = {
        {"AForeignSpaceIsRefused", "plans in any space"},
        {"AnotherObjectiveIsNoticed", first},
        {"AnotherProblemAfterClear", first},
        {"AnotherProblemIsNoticed", first},
        {"EveryGoalThatIsExportedIsMarked", "may draw a sample where a goal is"},
        {"EveryVertexHangsTogetherWithAStart", "exports all parts of its roadmap"},
        {"PropertiesMayBeReadFromAnotherThread", "forgets its best cost when solve() is called again"},
        {"SlicesOfTimeAddUp", hurry},
        {"TheBestCostIsTheSolutions", "may end before its second thread has noted what it found"},
        {"WeightsAreCosts", "exports weights of 1"},
        {"WhatIsKnownIsToldInNoTime", hurry},
    };
    return planner;
}

/// A planner, in all its variants, and a check.
struct Case
{
    std::string name;
    std::vector<PlannerUnderTest> planners;
    PlannerCheck check;

    friend void PrintTo(const Case &one, std::ostream *out) { *out << one.name; }
};

std::vector<Case> everyCase()
{
    std::vector<Case> cases;
    for (const PlannerCheck &check : plannerChecks())
    {
        cases.push_back({"HexAStar_" + check.name, everyHexAStar(), check});
        cases.push_back({"SquareAStar_" + check.name, everySquareAStar(), check});
        cases.push_back({"BitStar_" + check.name, {bitStar()}, check});
        cases.push_back({"PrmStar_" + check.name, {prmStar()}, check});
    }
    return cases;
}

class PlannerConformance : public ::testing::TestWithParam<Case>
{
};

TEST_P(PlannerConformance, Holds)
{
    const PlannerCheck &check = GetParam().check;
    for (const PlannerUnderTest &planner : GetParam().planners)
    {
        const auto exception = planner.exceptions.find(check.name);
        if (exception != planner.exceptions.end())
            GTEST_SKIP() << planner.name << ": " << exception->second;
        for (const PlannerArena &arena : arenasFor(planner))
            for (const std::string &violation : violationsOf(check, planner, arena))
                ADD_FAILURE() << planner.name << ", " << violation;
    }
}

INSTANTIATE_TEST_SUITE_P(Planners, PlannerConformance, ::testing::ValuesIn(everyCase()),
                         [](const auto &test) { return test.param.name; });

/// An exception to a check that does not exist would except nothing.
TEST(PlannerConformanceExceptions, NameChecks)
{
    std::set<std::string> names;
    for (const PlannerCheck &check : plannerChecks())
        EXPECT_TRUE(names.insert(check.name).second) << "two checks are called " << check.name;
    for (const PlannerUnderTest &planner : {bitStar(), prmStar()})
        for (const auto &exception : planner.exceptions)
            EXPECT_EQ(names.count(exception.first), 1u) << planner.name << ": " << exception.first;
}

}  // namespace
}  // namespace seahex::test
