#include "support/conformance/Themes.h"
#include "support/conformance/Trial.h"

#include <ompl/base/goals/GoalLazySamples.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <limits>

namespace ob = ompl::base;

namespace seahex::test
{
namespace
{

// Several starts, several goals, regions with no end of samples, and goals that turn up late.

/// The states within half a unit of a place, sampled without end.
class Region : public ob::GoalSampleableRegion
{
public:
    Region(const Trial &trial, char place)
        : ob::GoalSampleableRegion(trial.si()), trial_(trial), centre_(trial.positionOf(trial.stateAt(place).get())),
          random_(5)
    {
    }

    double distanceGoal(const ob::State *state) const override
    {
        return std::max(0.0, (trial_.positionOf(state) - centre_).norm() - radius_);
    }

    void sampleGoal(ob::State *state) const override
    {
        do
        {
            const Point p = centre_ + Point(random_.real(-radius_, radius_), random_.real(-radius_, radius_));
            si_->copyState(state, trial_.stateAt(p).get());
        } while (distanceGoal(state) > 0.0);
    }

    unsigned int maxSampleCount() const override { return std::numeric_limits<unsigned int>::max(); }

private:
    const Trial &trial_;
    Point centre_;
    double radius_ = 0.5;
    mutable Random random_;
};

void expectCost(Trial &trial, const ob::ProblemDefinitionPtr &problem, const std::string &starts,
                const std::string &goals, const std::string &what)
{
    trial.mustSolve(trial.planner(problem), what);
    double best = std::numeric_limits<double>::infinity();
    for (const char start : starts)
        for (const char goal : goals)
        {
            const auto one = trial.problem(start, goal);
            best = std::min(best, trial.mustSolve(trial.planner(one), what + ", a pair of them"));
        }
    if (trial.subject().optimal && !trial.turnsMatter())
        trial.expect(isClose(bestCost(problem), best),
                     what + ": cost " + toText(bestCost(problem)) + ", the best pair's is " + toText(best));
}

void theBestPairOfStatesWins(Trial &trial)
{
    const std::string bad = trial.arena().has('X') ? "X" : "O";
    expectCost(trial, trial.problem("A", trial.goalStates("BCD")), "A", "BCD", "several goals");
    expectCost(trial, trial.problem("BCD", trial.goalStates("A")), "BCD", "A", "several starts");
    expectCost(trial, trial.problem("AC", trial.goalStates("BD")), "AC", "BD", "two starts, two goals");
    expectCost(trial, trial.problem("A", trial.goalStates(bad + "B" + bad + "C" + bad)), "A", "BC",
               "goals, some of them invalid");
}

void aRegionWithNoEndOfSamples(Trial &trial)
{
    for (const char place : {'B', 'C'})
    {
        const auto problem = trial.problem("A", std::make_shared<Region>(trial, place));
        const double cost = trial.mustSolve(trial.planner(problem), "a region");
        const auto again = trial.problem("A", std::make_shared<Region>(trial, place));
        const double same = trial.mustSolve(trial.planner(again), "the same region");
        if (trial.subject().deterministic)
            trial.expect(cost == same, "the same region: another cost");
    }
}

/// A goal is sampled in a thread of its own once the planner has looked at the condition three times.
void aGoalThatTurnsUpLate(Trial &trial)
{
    std::promise<void> begun;
    std::shared_future<void> hasBegun(begun.get_future());
    const auto sampler = [&trial, hasBegun, calls = 0](const ob::GoalLazySamples *, ob::State *state) mutable
    {
        hasBegun.wait_for(std::chrono::seconds(10));
        trial.si()->copyState(state, trial.stateAt(++calls == 1 ? 'B' : 'C').get());
        return calls <= 2;
    };
    const auto goal = std::make_shared<ob::GoalLazySamples>(trial.si(), sampler);
    const auto problem = trial.problem("A", goal);
    const auto planner = trial.planner(problem);
    const auto condition = trial.condition(
        [&](int look)
        {
            if (look == 3)
                begun.set_value();
            return false;
        });
    const ob::PlannerStatus status = trial.solve(planner, condition, "a late goal");
    trial.expect(status == ob::PlannerStatus::EXACT_SOLUTION, "a late goal: " + nameOf(status));
    trial.expect(trial.observed().looks >= 3, "a late goal: nobody waited for it");
    if (trial.observed().looks < 3)
        begun.set_value();
    while (goal->isSampling() && goal->getStateCount() < 2)
        std::this_thread::yield();
    goal->stopSampling();
    problem->clearSolutionPaths();
    const double cost = trial.mustSolve(planner, "one more goal");
    const auto both = trial.problem("A", trial.goalStates("BC"));
    const double expected = trial.mustSolve(trial.planner(both), "both goals at once");
    if (trial.subject().optimal && !trial.turnsMatter())
        trial.expect(isClose(cost, expected),
                     "one more goal: cost " + toText(cost) + " instead of " + toText(expected));
}

void aGoalThatNeverTurnsUp(Trial &trial)
{
    const auto goal = std::make_shared<ob::GoalLazySamples>(trial.si(), [](const ob::GoalLazySamples *, ob::State *)
                                                            { return false; });
    const ob::PlannerStatus::StatusType status =
        trial.mustNotSolve(trial.planner(trial.problem("A", goal)), "no goal ever");
    trial.expect(status == ob::PlannerStatus::INVALID_GOAL || status == ob::PlannerStatus::TIMEOUT,
                 "no goal ever: " + nameOf(status));
    goal->stopSampling();
}

/// Waiting for a goal must not outlast the condition.
void waitingForAGoalHasAnEnd(Trial &trial)
{
    std::atomic<bool> over{false};
    const auto sampler = [&](const ob::GoalLazySamples *, ob::State *)
    {
        while (!over)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return false;
    };
    const auto goal = std::make_shared<ob::GoalLazySamples>(trial.si(), sampler);
    const auto condition = trial.condition([](int look) { return look > 3; });
    const ob::PlannerStatus::StatusType status =
        trial.solve(trial.planner(trial.problem("A", goal)), condition, "waiting for a goal");
    trial.expect(status == ob::PlannerStatus::INVALID_GOAL || status == ob::PlannerStatus::TIMEOUT,
                 "waiting for a goal: " + nameOf(status));
    over = true;
    goal->stopSampling();
}

}  // namespace

std::vector<PlannerCheck> goalChecks()
{
    return {
        {"TheBestPairOfStatesWins", theBestPairOfStatesWins}, {"ARegionWithNoEndOfSamples", aRegionWithNoEndOfSamples},
        {"AGoalThatTurnsUpLate", aGoalThatTurnsUpLate},       {"AGoalThatNeverTurnsUp", aGoalThatNeverTurnsUp},
        {"WaitingForAGoalHasAnEnd", waitingForAGoalHasAnEnd},
    };
}

}  // namespace seahex::test
