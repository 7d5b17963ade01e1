#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <ompl/base/objectives/MaximizeMinClearanceObjective.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/objectives/StateCostIntegralObjective.h>

#include <algorithm>
#include <limits>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// The problem's objective: whose it is, what it costs, and when it is satisfied.

/// Path length, with a toll at both ends.
class Tolled : public ob::PathLengthOptimizationObjective
{
public:
    using ob::PathLengthOptimizationObjective::PathLengthOptimizationObjective;
    ob::Cost initialCost(const ob::State *) const override { return ob::Cost(7.0); }
    ob::Cost terminalCost(const ob::State *) const override { return ob::Cost(3.0); }
};

/// Farther east is dearer.
class Eastern : public ob::StateCostIntegralObjective
{
public:
    explicit Eastern(const Trial &trial) : ob::StateCostIntegralObjective(trial.si(), false), trial_(trial) {}
    ob::Cost stateCost(const ob::State *state) const override
    {
        return ob::Cost(1.0 + 0.1 * (trial_.positionOf(state).x() - trial_.arena().bounds.min.x()));
    }

private:
    const Trial &trial_;
};

/// That cost is the objective's own, tolls included, is judged with every solution.
void solveFor(Trial &trial, const ob::OptimizationObjectivePtr &objective, const std::string &what)
{
    const auto problem = trial.problem('A', 'B');
    trial.setObjective(problem, objective);
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, what);
    trial.expect(problem->getOptimizationObjective() == objective, what + ": the problem has another objective now");
    problem->clearSolutionPaths();
    trial.mustSolve(planner, what + ", again");
}

void tollsAtBothEndsCount(Trial &trial)
{
    solveFor(trial, std::make_shared<Tolled>(trial.si()), "tolls at both ends");
}

void costsAreTheObjectives(Trial &trial)
{
    solveFor(trial, std::make_shared<Eastern>(trial), "state costs");
    solveFor(trial, std::make_shared<ob::MaximizeMinClearanceObjective>(trial.si()), "least clearance");
}

void anotherObjectiveIsNoticed(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    const auto planner = trial.planner(problem);
    trial.mustSolve(planner, "path length");
    problem->clearSolutionPaths();
    trial.setObjective(problem, std::make_shared<Tolled>(trial.si()));
    trial.mustSolve(planner, "another objective");
}

void aProblemWithoutObjectiveStaysWithout(Trial &trial)
{
    const auto problem = trial.problem('A', 'B');
    problem->setOptimizationObjective(nullptr);
    const auto planner = trial.planner(problem);
    planner->setup();
    trial.solve(planner, trial.patience(true), "no objective");
    trial.expect(!problem->hasOptimizationObjective(), "the planner wrote an objective into the problem");
    if (trial.subject().finishes)
    {
        problem->clearSolutionPaths();
        const double length = trial.mustSolve(planner, "no objective");
        const auto shortest = trial.problem('A', 'B');
        trial.mustSolve(trial.planner(shortest), "path length");
        trial.expect(isClose(length, bestCost(shortest)), "no objective: not the path of least length");
    }
}

ob::OptimizationObjectivePtr lengthBelow(const Trial &trial, double threshold)
{
    auto objective = std::make_shared<ob::PathLengthOptimizationObjective>(trial.si());
    objective->setCostThreshold(ob::Cost(threshold));
    return objective;
}

void theThresholdDecidesWhatIsOptimised(Trial &trial)
{
    const auto shortest = trial.problem('A', 'B');
    const double cost = trial.mustSolve(trial.planner(shortest), "path length");
    for (const double threshold : {0.0, 0.99 * cost, 1.01 * cost, 5.0 * cost, std::numeric_limits<double>::infinity()})
    {
        const std::string when = "a threshold of " + toText(threshold);
        const auto problem = trial.problem('A', 'B');
        problem->setOptimizationObjective(lengthBelow(trial, threshold));
        const ob::PlannerStatus status = trial.solve(trial.planner(problem), trial.patience(true), when);
        if (!trial.subject().finishes)
            continue;
        trial.expect(status == ob::PlannerStatus::EXACT_SOLUTION, when + ": " + nameOf(status));
        trial.expect(problem->hasOptimizedSolution() == (cost < threshold),
                     when + ": " + (cost < threshold ? "a path below it was not found" : "it can't be satisfied"));
    }
}

/// Nothing is reported after a cost that was good enough.
void aSatisfiedThresholdEndsTheSearch(Trial &trial)
{
    const double cost = trial.mustSolve(trial.planner(trial.problem('A', 'B')), "path length");
    for (const double threshold : {1.01 * cost, 1.5 * cost, std::numeric_limits<double>::infinity()})
    {
        if (!trial.subject().finishes && threshold < std::numeric_limits<double>::infinity())
            continue;
        const auto problem = trial.problem('A', 'B');
        const auto objective = lengthBelow(trial, threshold);
        problem->setOptimizationObjective(objective);
        std::vector<ob::Cost> costs;
        problem->setIntermediateSolutionCallback([&](const ob::Planner *, const std::vector<const ob::State *> &,
                                                     const ob::Cost reported) { costs.push_back(reported); });
        trial.mustSolve(trial.planner(problem), "a threshold of " + toText(threshold));
        const auto satisfied = [&](const ob::Cost &reported)
        {
            return objective->isSatisfied(reported);
        };
        trial.expect(std::count_if(costs.begin(), costs.end(), satisfied) <= 1,
                     "a threshold of " + toText(threshold) + ": the search went on when it was satisfied");
    }
}

}  // namespace

std::vector<PlannerCheck> objectiveChecks()
{
    return {
        {"TollsAtBothEndsCount", tollsAtBothEndsCount},
        {"CostsAreTheObjectives", costsAreTheObjectives},
        {"AnotherObjectiveIsNoticed", anotherObjectiveIsNoticed},
        {"AProblemWithoutObjectiveStaysWithout", aProblemWithoutObjectiveStaysWithout},
        {"TheThresholdDecidesWhatIsOptimised", theThresholdDecidesWhatIsOptimised},
        {"ASatisfiedThresholdEndsTheSearch", aSatisfiedThresholdEndsTheSearch},
    };
}

}  // namespace seahex::test
