#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/PlannerDataStorage.h>
#include <ompl/base/goals/GoalStates.h>

#include <algorithm>
#include <set>
#include <sstream>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// What getPlannerData() exports: vertices, edges with weights, starts and goals; whose states they are, and for how
// long.

/// Positions of the vertices, in their order.
std::vector<Point> positions(const Trial &trial, const ob::PlannerData &data)
{
    std::vector<Point> points;
    for (unsigned int v = 0; v < data.numVertices(); ++v)
        points.push_back(trial.positionOf(data.getVertex(v).getState()));
    return points;
}

/// The vertices that edges lead to from the starts.
std::set<unsigned int> reachedFromStarts(const ob::PlannerData &data)
{
    std::vector<unsigned int> open;
    for (unsigned int i = 0; i < data.numStartVertices(); ++i)
        open.push_back(data.getStartIndex(i));
    std::set<unsigned int> reached(open.begin(), open.end());
    while (!open.empty())
    {
        std::vector<unsigned int> next;
        data.getEdges(open.back(), next);
        open.pop_back();
        for (const unsigned int v : next)
            if (reached.insert(v).second)
                open.push_back(v);
    }
    return reached;
}

/// Calls visit(from, to, weight) for each edge.
template <class Visit>
void forEachEdge(const ob::PlannerData &data, Visit &&visit)
{
    for (unsigned int from = 0; from < data.numVertices(); ++from)
    {
        std::vector<unsigned int> ends;
        data.getEdges(from, ends);
        for (const unsigned int to : ends)
        {
            ob::Cost weight;
            data.getEdgeWeight(from, to, &weight);
            visit(from, to, weight.value());
        }
    }
}

void exportAtAnyTime(Trial &trial)
{
    const auto planner = trial.planner();
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    trial.expect(data.numVertices() == 0, "vertices before there is a problem");
    planner->setProblemDefinition(trial.problem('A', 'B'));
    planner->setup();
    planner->getPlannerData(data);
    trial.solve(planner, ob::plannerAlwaysTerminatingCondition(), "no time");
    planner->getPlannerData(data);
    data.clear();
    planner->clear();
    planner->getPlannerData(data);
    trial.expect(data.numVertices() == 0, "vertices after clear");
    trial.mustSolve(planner, "solve");
    planner->getPlannerData(data);
    trial.expect(data.numVertices() > 0, "no vertices after solve");
}

void startsAndGoalsAreMarked(Trial &trial)
{
    const auto problem = trial.problem("AC", trial.goalStates("BD"));
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    trial.expect(data.numStartVertices() == 2,
                 std::to_string(data.numStartVertices()) + " start vertices of two starts");
    for (unsigned int i = 0; i < data.numStartVertices(); ++i)
        trial.expect(problem->hasStartState(data.getStartVertex(i).getState()), "a start vertex is no start");
    trial.expect(data.numGoalVertices() > 0, "no goal vertex");
    for (unsigned int i = 0; i < data.numGoalVertices(); ++i)
        trial.expect(problem->getGoal()->isSatisfied(data.getGoalVertex(i).getState()), "a goal vertex is no goal");
}

/// Whichever of them the best path leads to.
void everyGoalThatIsExportedIsMarked(Trial &trial)
{
    const auto problem = trial.problem("AC", trial.goalStates("BD"));
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    for (unsigned int v = 0; v < data.numVertices(); ++v)
        trial.expect(data.isGoalVertex(v) || !problem->getGoal()->isSatisfied(data.getVertex(v).getState()),
                     "a goal is a vertex and not marked");
}

void verticesAndEdgesAreValid(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    const std::vector<Point> points = positions(trial, data);
    for (unsigned int v = 0; v < data.numVertices(); ++v)
        if (!trial.expect(trial.si()->isValid(data.getVertex(v).getState()), "a vertex is no valid state"))
            break;
    trial.expect(data.numEdges() > 0, "no edges");
    bool valid = true;
    forEachEdge(data,
                [&](unsigned int from, unsigned int to, double)
                {
                    valid = valid && trial.arena().isClear(points[from], points[to]) &&
                            trial.si()->checkMotion(data.getVertex(from).getState(), data.getVertex(to).getState());
                });
    trial.expect(valid, "an edge is no valid motion");
}

void weightsAreCosts(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    double worst = 0.0;
    forEachEdge(data,
                [&](unsigned int from, unsigned int to, double weight)
                {
                    const double cost = problem->getOptimizationObjective()
                                            ->motionCost(data.getVertex(from).getState(), data.getVertex(to).getState())
                                            .value();
                    worst = isClose(weight, cost) ? worst : std::max(worst, std::abs(weight - cost));
                });
    trial.expect(worst == 0.0, "the weight of an edge is off its cost by " + toText(worst));
}

void theGoalHangsTogetherWithTheStart(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    const std::set<unsigned int> reached = reachedFromStarts(data);
    bool goal = false;
    for (unsigned int i = 0; i < data.numGoalVertices(); ++i)
        goal = goal || reached.count(data.getGoalIndex(i)) > 0;
    trial.expect(goal, "no edges lead from a start to a goal");
}

void everyVertexHangsTogetherWithAStart(Trial &trial)
{
    const auto planner = trial.planner(trial.problem('A', 'B'));
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    for (unsigned int i = 0; i < data.numGoalVertices(); ++i)  // goals that were not reached are told as well
        trial.expect(data.numVertices() > data.numStartVertices(), "nothing but starts");
    const std::size_t apart = data.numVertices() - reachedFromStarts(data).size();
    trial.expect(apart == 0, std::to_string(apart) + " vertices of " + std::to_string(data.numVertices()) +
                                 " hang together with no start");
}

/// Each state of the solution is a vertex, and each leg an edge.
void theSolutionIsExported(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    const auto path = bestPath(problem);
    if (!path)
        return;
    std::set<std::pair<const ob::State *, const ob::State *>> found;
    const auto &states = path->getStates();
    std::size_t legs = 0;
    forEachEdge(data,
                [&](unsigned int from, unsigned int to, double)
                {
                    for (std::size_t i = 1; i < states.size(); ++i)
                        if (trial.si()->equalStates(states[i - 1], data.getVertex(from).getState()) &&
                            trial.si()->equalStates(states[i], data.getVertex(to).getState()) &&
                            found.insert({states[i - 1], states[i]}).second)
                            ++legs;
                });
    trial.expect(legs == states.size() - 1,
                 std::to_string(legs) + " of " + std::to_string(states.size() - 1) + " legs of the solution are edges");
}

void secondExportAddsOnly(Trial &trial)
{
    const auto goals = std::dynamic_pointer_cast<ob::GoalStates>(trial.goalStates("B"));
    const auto problem = trial.problem("A", goals);
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    const unsigned int vertices = data.numVertices();
    const unsigned int edges = data.numEdges();
    planner->getPlannerData(data);
    trial.expect(data.numVertices() == vertices && data.numEdges() == edges,
                 "another export with nothing done in between adds to it");

    // the planner goes on; what was exported is to be kept until clear()
    const std::vector<Point> before = positions(trial, data);
    std::vector<const ob::State *> states;
    for (unsigned int v = 0; v < data.numVertices(); ++v)
        states.push_back(trial.counted(data.getVertex(v).getState()));
    goals->addState(trial.stateAt('D'));
    problem->clearSolutionPaths();
    trial.mustSolve(planner, "one more goal");
    if (!trial.expect(
            std::all_of(states.begin(), states.end(), [&](const auto *state) { return trial.isAlive(state); }),
            "going on frees states that were exported"))
        return;
    trial.expect(positions(trial, data) == before, "going on changes states that were exported");
    planner->getPlannerData(data);
    trial.expect(data.numVertices() >= vertices && data.numEdges() >= edges, "another export takes away");
}

void exportSurvivesThePlanner(Trial &trial)
{
    ob::PlannerData data(trial.si());
    std::vector<Point> before;
    {
        const auto problem = trial.problem('A', 'B');
        const auto planner = trial.planner(problem);
        trial.mustSolve(planner, "solve");
        planner->getPlannerData(data);
        before = positions(trial, data);
        data.decoupleFromPlanner();
    }
    trial.expect(positions(trial, data) == before, "decoupled states change when the planner is gone");
}

void exportIsStoredAndLoaded(Trial &trial)
{
    const auto planner = trial.planner(trial.problem('A', 'B'));
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    std::stringstream file;
    ob::PlannerDataStorage storage;
    storage.store(data, file);
    ob::PlannerData loaded(trial.si());
    storage.load(file, loaded);

    trial.expect(positions(trial, loaded) == positions(trial, data), "stored and loaded: other vertices");
    using Edges = std::map<std::pair<unsigned int, unsigned int>, double>;
    const auto edgesOf = [](const ob::PlannerData &graph)
    {
        Edges edges;
        forEachEdge(graph, [&](unsigned int from, unsigned int to, double weight) { edges[{from, to}] = weight; });
        return edges;
    };
    trial.expect(edgesOf(loaded) == edgesOf(data), "stored and loaded: other edges or weights");
    for (unsigned int v = 0; v < data.numVertices(); ++v)
        if (!trial.expect(data.isStartVertex(v) == loaded.isStartVertex(v) &&
                              data.isGoalVertex(v) == loaded.isGoalVertex(v) &&
                              data.getVertex(v).getTag() == loaded.getVertex(v).getTag(),
                          "stored and loaded: other starts, goals or tags"))
            break;
}

void propertiesAreExported(Trial &trial)
{
    const auto planner = trial.planner(trial.problem('A', 'B'));
    trial.mustSolve(planner, "solve");
    ob::PlannerData data(trial.si());
    planner->getPlannerData(data);
    for (const auto &[name, getter] : planner->getPlannerProgressProperties())
        trial.expect(data.properties.count(name) == 1 && data.properties.at(name) == getter(),
                     "the progress property " + inQuotes(name) + " is not exported");
}

}  // namespace

std::vector<PlannerCheck> plannerDataChecks()
{
    return {
        {"ExportAtAnyTime", exportAtAnyTime},
        {"StartsAndGoalsAreMarked", startsAndGoalsAreMarked},
        {"EveryGoalThatIsExportedIsMarked", everyGoalThatIsExportedIsMarked},
        {"VerticesAndEdgesAreValid", verticesAndEdgesAreValid},
        {"WeightsAreCosts", weightsAreCosts},
        {"TheGoalHangsTogetherWithTheStart", theGoalHangsTogetherWithTheStart},
        {"EveryVertexHangsTogetherWithAStart", everyVertexHangsTogetherWithAStart},
        {"TheSolutionIsExported", theSolutionIsExported},
        {"SecondExportAddsOnly", secondExportAddsOnly},
        {"ExportSurvivesThePlanner", exportSurvivesThePlanner},
        {"ExportIsStoredAndLoaded", exportIsStoredAndLoaded},
        {"PropertiesAreExported", propertiesAreExported},
    };
}

}  // namespace seahex::test
