#include "support/conformance/SpoiltPlanner.h"

#include <ompl/base/OptimizationObjective.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <string>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

using Condition = SpoiltPlanner::Condition;
using States = std::vector<const ob::State *>;
using Callback = ob::ReportIntermediateSolutionFn;

/// Solves with the problem's callback in the hands of another.
std::function<void(SpoiltPlanner &)>
report(const std::function<void(const Callback &, const ob::Planner *, States, ob::Cost)> &instead)
{
    return [instead](SpoiltPlanner &planner)
    {
        planner.onSolve = [&planner, instead](const Condition &condition)
        {
            const auto problem = planner.getProblemDefinition();
            const Callback callback = problem->getIntermediateSolutionCallback();
            if (callback)
                problem->setIntermediateSolutionCallback(
                    [&](const ob::Planner *who, const States &states, const ob::Cost cost)
                    { instead(callback, who, states, cost); });
            const ob::PlannerStatus status = planner.solveWell(condition);
            problem->setIntermediateSolutionCallback(callback);
            return status;
        };
    };
}

/// What is exported is changed.
std::function<void(SpoiltPlanner &)>
afterExport(const std::function<void(const SpoiltPlanner &, ob::PlannerData &)> &change)
{
    return [change](SpoiltPlanner &planner)
    {
        planner.onExport = [&planner, change](ob::PlannerData &data)
        {
            planner.TextbookPlanner::getPlannerData(data);
            change(planner, data);
        };
    };
}

void setWeights(ob::PlannerData &data, double weight)
{
    for (unsigned int from = 0; from < data.numVertices(); ++from)
        for (unsigned int to = 0; to < data.numVertices(); ++to)
            data.setEdgeWeight(from, to, ob::Cost(weight));
}

std::vector<Defect> improvementDefects()
{
    return {
        {"nothing is reported",
         {{"CostsFallToTheSolutions", "no solution was reported"}},
         report([](const Callback &, const ob::Planner *, const States &, ob::Cost) {})},
        {"a satisfying solution is followed by another",
         {{"ASatisfiedThresholdEndsTheSearch", "went on"}},
         report(
             [](const Callback &callback, const ob::Planner *who, const States &states, ob::Cost cost)
             {
                 callback(who, states, cost);
                 callback(who, states, ob::Cost(0.99 * cost.value()));
             })},
        {"paths are reported from goal to start",
         {{"ReportsArePathsFromStartToGoal", "does not begin at the start"}},
         report(
             [](const Callback &callback, const ob::Planner *who, States states, ob::Cost cost)
             {
                 std::reverse(states.begin(), states.end());
                 callback(who, states, cost);
             })},
        {"a condition that comes true by reports is an exception",
         {{"CostConvergenceIsACondition", "an exception"}},
         [](SpoiltPlanner &planner)
         {
             report(
                 [](const Callback &callback, const ob::Planner *who, const States &states, ob::Cost cost)
                 {
                     for (int i = 0; i < 3; ++i)
                         callback(who, states, cost);
                 })(planner);
             planner.onSolve = [solve = planner.onSolve](const Condition &condition)
             {
                 const ob::PlannerStatus status = solve(condition);
                 if (condition)
                     throw ompl::Exception("interrupted");
                 return status;
             };
         }},
        {"what is known is reported in every call",
         {{"WhatIsKnownIsNotReportedAgain", "was reported after"}},
         [](SpoiltPlanner &planner)
         {
             planner.onSolve = [&planner, calls = 0](const Condition &condition) mutable
             {
                 const ob::PlannerStatus status = planner.solveWell(condition);
                 const auto &problem = planner.getProblemDefinition();
                 if (++calls > 1 && problem->getIntermediateSolutionCallback() && problem->hasSolution())
                     problem->getIntermediateSolutionCallback()(
                         &planner, {}, problem->getSolutionPath()->cost(problem->getOptimizationObjective()));
                 return status;
             };
         }},
    };
}

std::vector<Defect> progressDefects()
{
    return {
        {"a property without a type",
         {{"PropertiesAreColumns", "'words TYPE'"}},
         [](SpoiltPlanner &planner)
         {
             planner.addPlannerProgressProperty("best-cost", [] { return std::string("1"); });
         }},
        {"a property that is no number before there is one",
         {{"PropertiesMayBeReadAtAnyTime", "'none'"}},
         [](SpoiltPlanner &planner)
         {
             planner.addPlannerProgressProperty("gap REAL", [] { return std::string("none"); });
         }},
        {"a best cost that is another's",
         {{"TheBestCostIsTheSolutions", "and the solution's is"}},
         [](SpoiltPlanner &planner)
         {
             const auto well = planner.getPlannerProgressProperties().at("best cost REAL");
             planner.addPlannerProgressProperty("best cost REAL",
                                                [well] { return std::to_string(std::stod(well()) + 1.0); });
         }},
        {"a best cost that survives clear()",
         {{"TheBestCostIsTheSolutions", "survives clear"}},
         [](SpoiltPlanner &planner)
         {
             const auto well = planner.getPlannerProgressProperties().at("best cost REAL");
             const auto best = std::make_shared<double>(std::numeric_limits<double>::infinity());
             planner.addPlannerProgressProperty("best cost REAL",
                                                [well, best]
                                                {
                                                    *best = std::min(*best, std::stod(well()));
                                                    return std::to_string(*best);
                                                });
         }},
        {"a best cost that rises",
         {{"PropertiesMayBeReadFromAnotherThread", "rises"}},
         [](SpoiltPlanner &planner)
         {
             const auto reads = std::make_shared<std::atomic<int>>(0);
             planner.addPlannerProgressProperty("best cost REAL", [reads] { return std::to_string(1.0 + ++*reads); });
         }},
    };
}

std::vector<Defect> exportDefects()
{
    return {
        {"an export wants a problem",
         {{"ExportAtAnyTime", "an exception"}},
         afterExport(
             [](const SpoiltPlanner &planner, ob::PlannerData &)
             {
                 if (!planner.getProblemDefinition())
                     throw ompl::Exception("nothing to export");
             })},
        {"starts and goals are not marked",
         {{"StartsAndGoalsAreMarked", "0 start vertices"},
          {"EveryGoalThatIsExportedIsMarked", "not marked"},
          {"TheGoalHangsTogetherWithTheStart", "no edges lead"}},
         [](SpoiltPlanner &planner)
         {
             planner.onExport = [&](ob::PlannerData &data)
             {
                 ob::PlannerData marked(planner.getSpaceInformation());
                 planner.TextbookPlanner::getPlannerData(marked);
                 for (unsigned int v = 0; v < marked.numVertices(); ++v)
                     data.addVertex(marked.getVertex(v));
             };
         }},
        {"an edge from start to goal, whatever is in between",
         {{"VerticesAndEdgesAreValid", "no valid motion"}},
         afterExport([](const SpoiltPlanner &, ob::PlannerData &data)
                     { data.addEdge(data.getStartIndex(0), data.getGoalIndex(0)); })},
        {"weights of 1",
         {{"WeightsAreCosts", "off its cost"}},
         afterExport([](const SpoiltPlanner &, ob::PlannerData &data) { setWeights(data, 1.0); })},
        {"weights that are no numbers",
         {{"ExportIsStoredAndLoaded", "other edges or weights"}},
         afterExport([](const SpoiltPlanner &, ob::PlannerData &data)
                     { setWeights(data, std::numeric_limits<double>::quiet_NaN()); })},
        {"a goal is exported without its edge",
         {{"TheSolutionIsExported", "legs of the solution"},
          {"TheGoalHangsTogetherWithTheStart", "no edges lead"},
          {"EveryVertexHangsTogetherWithAStart", "hang together with no start"}},
         afterExport(
             [](const SpoiltPlanner &, ob::PlannerData &data)
             {
                 std::vector<unsigned int> before;
                 for (unsigned int i = 0; i < data.numGoalVertices(); ++i)
                     if (data.getIncomingEdges(data.getGoalIndex(i), before) > 0)
                         data.removeEdge(before.front(), data.getGoalIndex(i));
             })},
        {"the export dies with the planner",
         {{"ExportSurvivesThePlanner", "decoupled states"}},
         [](SpoiltPlanner &planner)
         {
             const auto exported = std::make_shared<ob::PlannerData *>(nullptr);
             planner.onExport = [&planner, exported](ob::PlannerData &data)
             {
                 planner.TextbookPlanner::getPlannerData(data);
                 *exported = &data;
             };
             planner.onDeath = [exported]
             {
                 if (*exported != nullptr)
                     (*exported)->clear();
             };
         }},
        {"progress is not exported",
         {{"PropertiesAreExported", "is not exported"}},
         afterExport([](const SpoiltPlanner &, ob::PlannerData &data) { data.properties.clear(); })},
    };
}

std::vector<Defect> settingDefects()
{
    return {
        {"a name that cuts a log's line in two",
         {{"NamesFitALog", "does not fit a log"}},
         [](SpoiltPlanner &planner)
         {
             planner.setName("Text|book");
         }},
        {"a value that its own setter refuses",
         {{"ValuesAreTakenBack", "refuses its own"}},
         [](SpoiltPlanner &planner)
         {
             planner.params().declareParam<int>(
                 "points", [&planner](int points) { planner.setPoints(points); }, [] { return 5; });
         }},
        {"a range that the value is not in",
         {{"RangesHoldTheValues", "not in '100"}},
         [](SpoiltPlanner &planner)
         {
             planner.params()["points"].setRangeSuggestion("100:1:1000");
         }},
        {"a range that is too wide",
         {{"EverythingInTheRangesIsTaken", "does not take '1'"}},
         [](SpoiltPlanner &planner)
         {
             planner.params()["points"].setRangeSuggestion("1:1:1000");
         }},
        {"bad values are made good ones",
         {{"BadValuesAreRefused", "takes '9'"}},
         [](SpoiltPlanner &planner)
         {
             planner.params().declareParam<int>(
                 "points", [&planner](int points) { planner.setPoints(std::min(1000, std::max(10, points))); },
                 [&planner] { return planner.getPoints(); });
         }},
        {"clear() clears the settings",
         {{"SettingsStay", "'points' was '40'"}},
         [](SpoiltPlanner &planner)
         {
             planner.onClear = [&]
             {
                 planner.TextbookPlanner::clear();
                 planner.setPoints(35);
             };
         }},
    };
}

}  // namespace

std::vector<Defect> reportDefects()
{
    std::vector<Defect> defects = improvementDefects();
    for (const auto &more : {progressDefects(), exportDefects(), settingDefects()})
        defects.insert(defects.end(), more.begin(), more.end());
    return defects;
}

}  // namespace seahex::test
