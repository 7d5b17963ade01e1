#include "support/conformance/Trial.h"

#include "support/conformance/Footing.h"

#include <ompl/base/goals/GoalRegion.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <sstream>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{
namespace
{

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds littleTime(10);
constexpr std::chrono::seconds allTime(20);

void noteQuestion(Observed &observed)
{
    if (observed.isJudging)
        return;
    const int question = ++observed.questions;
    const int since = ++observed.sinceLook;
    if (since > observed.mostBetween)
        observed.mostBetween = since;
    if (observed.ended)
        ++observed.afterTheEnd;
    if (observed.onQuestion)
        observed.onQuestion(question);
}

bool isSolution(ob::PlannerStatus::StatusType status)
{
    return status == ob::PlannerStatus::EXACT_SOLUTION || status == ob::PlannerStatus::APPROXIMATE_SOLUTION;
}

}  // namespace

Trial::Trial(const PlannerUnderTest &planner, const PlannerArena &arena)
    : subject_(planner), arena_(arena), observed_(std::make_shared<Observed>()), census_(std::make_shared<Census>()),
      si_(spaceInformation(arena, census_, [observed = observed_] { noteQuestion(*observed); }))
{
    // OMPL tells the console about every state that is no good
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
}

bool Trial::expect(bool condition, const std::string &violation)
{
    if (!condition)
        violations_.push_back(violation);
    return condition;
}

ob::ScopedState<> Trial::stateAt(const Point &p, double heading) const
{
    ob::ScopedState<> state(si_);
    Footing(si_->getStateSpace().get()).place(state.get(), p, heading);
    return state;
}

bool Trial::turnsMatter() const
{
    return Footing(si_->getStateSpace().get()).hasHeading();
}

const ob::State *Trial::counted(const ob::State *state) const
{
    return turnsMatter() ? state->as<ob::CompoundState>()->components[1] : state;
}

Point Trial::positionOf(const ob::State *state) const
{
    return Footing(si_->getStateSpace().get()).position(state);
}

void Trial::setObjective(const ob::ProblemDefinitionPtr &problem, const ob::OptimizationObjectivePtr &objective) const
{
    if (!subject_.finishes)
        objective->setCostThreshold(objective->infiniteCost());
    problem->setOptimizationObjective(objective);
}

ob::ProblemDefinitionPtr Trial::problem(const std::string &starts, const ob::GoalPtr &goal) const
{
    auto problem = std::make_shared<ob::ProblemDefinition>(si_);
    for (const char start : starts)
        problem->addStartState(stateAt(start));
    problem->setGoal(goal);
    setObjective(problem, std::make_shared<ob::PathLengthOptimizationObjective>(si_));
    return problem;
}

ob::ProblemDefinitionPtr Trial::problem(char start, char goal) const
{
    auto problem = this->problem(std::string(1, start), nullptr);
    problem->setGoalState(stateAt(goal));
    return problem;
}

ob::GoalPtr Trial::goalStates(const std::string &places) const
{
    auto goal = std::make_shared<ob::GoalStates>(si_);
    for (const char place : places)
        goal->addState(stateAt(place));
    return goal;
}

ob::PlannerPtr Trial::planner(const ob::ProblemDefinitionPtr &problem) const
{
    auto planner = this->planner();
    planner->setProblemDefinition(problem);
    return planner;
}

ob::PlannerTerminationCondition Trial::condition(const std::function<bool(int)> &stop)
{
    for (std::atomic<int> *count : {&observed_->looks, &observed_->questions, &observed_->sinceLook,
                                    &observed_->mostBetween, &observed_->afterTheEnd})
        *count = 0;
    observed_->ended = false;
    observed_->timedOut = false;
    observed_->isJudging = false;
    const auto look = [observed = observed_, stop, deadline = Clock::now() + allTime]
    {
        observed->sinceLook = 0;
        const int number = ++observed->looks;
        if (observed->ended)
            return true;
        if (stop(number))
            observed->ended = true;
        else if (Clock::now() > deadline)
            observed->ended = observed->timedOut = true;
        return observed->ended.load();
    };
    return ob::PlannerTerminationCondition(look);
}

ob::PlannerTerminationCondition Trial::patience(bool mayBeInVain)
{
    const bool limited = mayBeInVain && !subject_.finishes;
    return condition([limited, deadline = Clock::now() + littleTime](int)
                     { return limited && Clock::now() > deadline; });
}

ob::PlannerStatus Trial::solve(const ob::PlannerPtr &planner, const ob::PlannerTerminationCondition &condition,
                               const std::string &when)
{
    const ob::ProblemDefinitionPtr problem = planner->getProblemDefinition();
    const std::vector<ob::PlannerSolution> before = problem->getSolutions();
    const ob::PlannerStatus status = planner->solve(condition);
    observed_->isJudging = true;
    expect(!observed_->timedOut, when + ": did not end within 20 s");

    bool added = false;
    for (const ob::PlannerSolution &solution : problem->getSolutions())
        if (std::find(before.begin(), before.end(), solution) == before.end())
        {
            added = true;
            judgeSolution(planner, solution, when);
        }
    const ob::PlannerStatus::StatusType type = status;
    expect(type > ob::PlannerStatus::UNKNOWN && type < ob::PlannerStatus::TYPE_COUNT, when + ": no status at all");
    if (type == ob::PlannerStatus::EXACT_SOLUTION)
        expect(problem->hasExactSolution(), when + ": EXACT_SOLUTION, and the problem has none");
    if (type == ob::PlannerStatus::APPROXIMATE_SOLUTION)
        expect(planner->getSpecs().approximateSolutions && problem->hasSolution(),
               when + ": APPROXIMATE_SOLUTION, and the specs promise none or the problem has none");
    expect(isSolution(type) || !added, when + ": " + nameOf(status) + ", and a solution was added");
    return status;
}

double Trial::mustSolve(const ob::PlannerPtr &planner, const std::string &when)
{
    const ob::PlannerStatus status = solve(planner, patience(), when);
    expect(status == ob::PlannerStatus::EXACT_SOLUTION, when + ": " + nameOf(status) + " instead of an exact solution");
    return bestCost(planner->getProblemDefinition());
}

ob::PlannerStatus Trial::mustNotSolve(const ob::PlannerPtr &planner, const std::string &when)
{
    const ob::PlannerStatus status = solve(planner, patience(true), when);
    expect(status != ob::PlannerStatus::EXACT_SOLUTION, when + ": an exact solution of a problem that has none");
    return status;
}

bool Trial::judgePath(og::PathGeometric &path, const std::string &when)
{
    const std::size_t violations = violations_.size();
    const auto &states = path.getStates();
    if (!expect(!states.empty(), when + ": a path with no states"))
        return false;
    expect(path.check(), when + ": path.check() fails");
    for (std::size_t i = 0; i < states.size(); ++i)
    {
        const ob::State *from = states[i == 0 ? 0 : i - 1];
        if (!expect(si_->isValid(states[i]), when + ": a state of the path is not valid") ||
            !expect(arena_.isClear(positionOf(from), positionOf(states[i])), when + ": a leg touches an obstacle"))
            break;
    }
    return violations == violations_.size();
}

void Trial::judgeSolution(const ob::PlannerPtr &planner, const ob::PlannerSolution &solution, const std::string &when)
{
    const ob::ProblemDefinitionPtr problem = planner->getProblemDefinition();
    auto *path = dynamic_cast<og::PathGeometric *>(solution.path_.get());
    if (!expect(path != nullptr, when + ": the solution is no geometric path") || !judgePath(*path, when))
        return;
    bool fromStart = false;
    for (unsigned int i = 0; i < problem->getStartStateCount(); ++i)
        fromStart = fromStart || si_->equalStates(problem->getStartState(i), path->getStates().front());
    expect(fromStart, when + ": the path does not begin at a start");
    double distance = 0.0;
    const bool arrives = problem->getGoal()->isSatisfied(path->getStates().back(), &distance);
    expect(arrives || solution.approximate_, when + ": an exact solution ends short of the goal");
    if (solution.approximate_)
        expect(isClose(solution.difference_, distance), when + ": a difference of " + toText(solution.difference_) +
                                                            " to the goal, and it is " + toText(distance));

    expect(solution.plannerName_ == planner->getName(), when + ": the solution lacks the planner's name");
    expect(isClose(solution.length_, path->length()), when + ": the length is not the path's");
    const ob::OptimizationObjectivePtr &objective = problem->getOptimizationObjective();
    if (objective && !solution.approximate_)
        expect(solution.opt_ == objective, when + ": the solution does not name the problem's objective");
    if (!solution.opt_)
    {
        expect(!solution.optimized_, when + ": optimised for no objective");
        return;
    }
    const double cost = path->cost(solution.opt_).value();
    expect(isClose(solution.cost_.value(), cost),
           when + ": cost " + toText(solution.cost_.value()) + " of a path of cost " + toText(cost));
    expect(solution.optimized_ == solution.opt_->isSatisfied(ob::Cost(cost)),
           when + (solution.optimized_ ? ": optimised with a cost that does not satisfy the objective"
                                       : ": not optimised though the objective is satisfied"));
}

std::shared_ptr<og::PathGeometric> bestPath(const ob::ProblemDefinitionPtr &problem)
{
    return std::dynamic_pointer_cast<og::PathGeometric>(problem->getSolutionPath());
}

double bestCost(const ob::ProblemDefinitionPtr &problem)
{
    const auto path = bestPath(problem);
    if (!path)
        return std::numeric_limits<double>::infinity();
    const ob::OptimizationObjectivePtr &objective = problem->getOptimizationObjective();
    return objective ? path->cost(objective).value() : path->length();
}

bool isClose(double a, double b)
{
    return a == b || std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

std::string toText(double value)
{
    std::ostringstream text;
    text.precision(12);
    text << value;
    return text.str();
}

std::string inQuotes(const std::string &text)
{
    return "'" + text + "'";
}

std::string nameOf(const ob::PlannerStatus &status)
{
    const ob::PlannerStatus::StatusType type = status;
    return type == ob::PlannerStatus::ABORT ? "Abort" : status.asString();  // for which OMPL 1.5 has no word
}

}  // namespace seahex::test
