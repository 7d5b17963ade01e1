#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include "support/ExplicitGraph.h"

#include <ompl/geometric/PathSimplifier.h>

#include <cmath>
#include <optional>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

// What a solution is, beyond what every solve() of a trial is judged by.

/// Between places at random, with any yaw. On a chart it is known whether there is a way.
void pathsBetweenRandomPlaces(Trial &trial)
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
    {
        Random random(seed);
        const std::string when = "random places, " + random.seedText();
        const Point from = trial.arena().somewhere(random);
        const Point to = trial.arena().somewhere(random);
        const auto problem = trial.problem('A', 'B');
        problem->clearStartStates();
        problem->addStartState(trial.stateAt(from, random.real(-3.0, 3.0)));
        problem->setGoalState(trial.stateAt(to, random.real(-3.0, 3.0)));
        const auto planner = trial.planner(problem);
        const ob::PlannerStatus status = trial.solve(planner, trial.patience(true), when);
        if (trial.arena().chart && trial.subject().finishes)
            trial.expect((status == ob::PlannerStatus::EXACT_SOLUTION) == trial.arena().areJoined(from, to),
                         when + ": " + nameOf(status) + ", and that is wrong");
        else if (trial.arena().chart)
            trial.expect(status != ob::PlannerStatus::EXACT_SOLUTION || trial.arena().areJoined(from, to),
                         when + ": a path where there is no way");
    }
}

/// The graph whose optimum the planner promises on the arena's chart; empty if it promises nothing there.
std::optional<ExplicitGraph> promisedGraph(const Trial &trial)
{
    const auto &chart = trial.arena().chart;
    if (const auto *hexagons = dynamic_cast<const HexOccupancy *>(chart.get()))
        if (trial.subject().rings > 0)
            return jumpGraph(*hexagons, trial.subject().rings, LengthMetric::Euclidean);
    if (const auto *squares = dynamic_cast<const SquareOccupancy *>(chart.get()))
        if (trial.subject().neighbours > 0)
            return stepGraph(*squares, trial.subject().neighbours);
    return std::nullopt;
}

void theCostIsTheOptimum(Trial &trial)
{
    const PlannerUnderTest &subject = trial.subject();
    const std::optional<ExplicitGraph> graph = promisedGraph(trial);
    if (!graph || trial.turnsMatter())
        return;
    const Lattice &lattice = trial.arena().chart->lattice();
    for (std::uint64_t seed = 1; seed <= 8; ++seed)
    {
        Random random(seed);
        const OffsetCoord from = lattice.cellAt(trial.arena().somewhere(random));
        const OffsetCoord to = lattice.cellAt(trial.arena().somewhere(random));
        if (from == to || !trial.arena().areJoined(lattice.centre(from), lattice.centre(to)))
            continue;
        const double optimum =
            lattice.pitch() * graph->cheapest({{vertexOf(lattice, from), 0.0}}, {{vertexOf(lattice, to), 0.0}});
        const auto problem = trial.problem('A', 'B');
        problem->clearStartStates();
        problem->addStartState(trial.stateAt(lattice.centre(from)));
        problem->setGoalState(trial.stateAt(lattice.centre(to)));
        const double cost = trial.mustSolve(trial.planner(problem), random.seedText());
        const bool asPromised = isClose(cost, optimum) || (!subject.optimal && cost < optimum);
        trial.expect(asPromised, random.seedText() + ": cost " + toText(cost) + ", the optimum of the lattice is " +
                                     toText(optimum));
    }
}

void theSameQuestionHasTheSameAnswer(Trial &trial)
{
    if (!trial.subject().deterministic)
        return;
    const auto first = trial.problem('A', 'B');
    trial.mustSolve(trial.planner(first), "first planner");
    for (int i = 0; i < 2; ++i)
    {
        const auto second = trial.problem('A', 'B');
        trial.mustSolve(trial.planner(second), "second planner");
        const auto one = bestPath(first);
        const auto other = bestPath(second);
        bool same = one && other && one->getStateCount() == other->getStateCount();
        for (unsigned int k = 0; same && k < one->getStateCount(); ++k)
            same = trial.si()->equalStates(one->getState(k), other->getState(k));
        trial.expect(same, "two planners, one question, two paths");
    }
}

/// Whoever has a solution may simplify it, or do worse to it.
void aChangedSolutionDoesNoHarm(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    double known = trial.mustSolve(planner, "solve");
    const auto solveAgain = [&](const std::string &when)
    {
        problem->clearSolutionPaths();
        const double cost = trial.mustSolve(planner, when);
        trial.expect(cost <= known || isClose(cost, known),
                     when + ": cost " + toText(cost) + " after " + toText(known));
        known = std::min(cost, known);
    };
    if (const auto path = bestPath(problem))
        og::PathSimplifier(trial.si()).simplifyMax(*path);
    solveAgain("the first solution was simplified");
    if (const auto path = bestPath(problem))
        for (ob::State *state : path->getStates())
            trial.si()->copyState(state, trial.stateAt('D').get());
    solveAgain("the second solution was spoilt");
    if (const auto path = bestPath(problem))
        path->clear();
    solveAgain("the third solution was emptied");
}

/// A longer path, there and back and there again, is in the problem already.
void theBetterOfTwoSolutionsIsTheProblems(Trial &trial)
{
    const auto first = trial.problem('A', 'B');
    trial.mustSolve(trial.planner(first), "solve");
    const auto path = bestPath(first);
    if (!path)
        return;
    const auto detour = std::make_shared<og::PathGeometric>(*path);
    og::PathGeometric back(*path);
    back.reverse();
    detour->append(back);
    detour->append(*path);

    const auto problem = trial.problem('A', 'B');
    ob::PlannerSolution known(detour);
    known.setPlannerName("someone else");
    known.setOptimized(problem->getOptimizationObjective(), detour->cost(problem->getOptimizationObjective()),
                       !trial.subject().finishes);
    problem->addSolutionPath(known);
    trial.mustSolve(trial.planner(problem), "a solution was there");
    trial.expect(problem->getSolutionCount() == 2, "a solution was there: the planner's was not added");
    ob::PlannerSolution best(nullptr);
    trial.expect(problem->getSolution(best) && best.plannerName_ != "someone else",
                 "a solution was there, and the planner's better one is not the problem's best");
}

void theProblemKeepsItsStates(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const ob::GoalPtr goal = problem->getGoal();
    trial.mustSolve(trial.planner(problem), "solve");
    trial.expect(problem->getStartStateCount() == 1 &&
                     trial.si()->equalStates(problem->getStartState(0), trial.stateAt('A').get()),
                 "the problem's start was changed");
    trial.expect(problem->getGoal() == goal && goal->isSatisfied(trial.stateAt('B').get()),
                 "the problem's goal was changed");
}

}  // namespace

std::vector<PlannerCheck> resultChecks()
{
    return {
        {"PathsBetweenRandomPlaces", pathsBetweenRandomPlaces},
        {"TheCostIsTheOptimum", theCostIsTheOptimum},
        {"TheSameQuestionHasTheSameAnswer", theSameQuestionHasTheSameAnswer},
        {"AChangedSolutionDoesNoHarm", aChangedSolutionDoesNoHarm},
        {"TheBetterOfTwoSolutionsIsTheProblems", theBetterOfTwoSolutionsIsTheProblems},
        {"TheProblemKeepsItsStates", theProblemKeepsItsStates},
    };
}

}  // namespace seahex::test
