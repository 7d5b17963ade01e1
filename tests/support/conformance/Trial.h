#pragma once

#include "support/PlannerConformance.h"

#include <ompl/base/Goal.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/geometric/PathGeometric.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>

namespace seahex::test
{

/// What was seen of a planner through its termination condition and a user's checker; from several threads.
struct Observed
{
    std::atomic<int> looks{0};            ///< at the condition
    std::atomic<int> questions{0};        ///< states that the checker was asked for since the condition was made
    std::atomic<int> sinceLook{0};        ///< of them, those since the last look
    std::atomic<int> mostBetween{0};      ///< most of them between two looks
    std::atomic<int> afterTheEnd{0};      ///< of them, those since the condition first held
    std::atomic<bool> ended{false};       ///< the condition held
    std::atomic<bool> isJudging{false};   ///< questions are not the planner's, and not counted
    std::atomic<bool> timedOut{false};    ///< it held because 20 s were over, which nothing here takes
    std::function<void(int)> onQuestion;  ///< called with the number of the question
};

/// The workbench of a check: one planner on one arena, with what is needed to make problems, solve them and judge the
/// answers.
class Trial
{
public:
    Trial(const PlannerUnderTest &planner, const PlannerArena &arena);

    const PlannerUnderTest &subject() const { return subject_; }
    const PlannerArena &arena() const { return arena_; }
    const ompl::base::SpaceInformationPtr &si() const { return si_; }
    Observed &observed() { return *observed_; }
    std::size_t statesAlive() const { return census_->size(); }
    /// What of a living state is in the census: to be remembered, and asked for when the state may be gone.
    const ompl::base::State *counted(const ompl::base::State *state) const;
    bool isAlive(const ompl::base::State *counted) const { return census_->has(counted); }
    const Violations &violations() const { return violations_; }

    /// States have a yaw, so turns count in OMPL's path length. Planners that search among positions find short paths
    /// there, and not always the best.
    bool turnsMatter() const;

    /// Remembers the violation unless the condition holds, which is returned.
    bool expect(bool condition, const std::string &violation);

    ompl::base::ScopedState<> stateAt(const Point &p, double heading = 0.0) const;
    ompl::base::ScopedState<> stateAt(char place) const { return stateAt(arena_.places.at(place)); }
    Point positionOf(const ompl::base::State *state) const;

    /// Problems have path length for their objective; for planners that do not finish, with a threshold that any path
    /// is below.
    ompl::base::ProblemDefinitionPtr problem(char start, char goal) const;
    ompl::base::ProblemDefinitionPtr problem(const std::string &starts, const ompl::base::GoalPtr &goal) const;
    /// With this objective, and its most generous threshold for planners that do not finish.
    void setObjective(const ompl::base::ProblemDefinitionPtr &problem,
                      const ompl::base::OptimizationObjectivePtr &objective) const;
    ompl::base::GoalPtr goalStates(const std::string &places) const;

    ompl::base::PlannerPtr planner() const { return subject_.make(si_); }
    ompl::base::PlannerPtr planner(const ompl::base::ProblemDefinitionPtr &problem) const;

    /// A condition whose looks are observed(), from now on. It holds when `stop`, told the number of the look
    /// from 1 on, says so, and after 20 s.
    ompl::base::PlannerTerminationCondition condition(const std::function<bool(int)> &stop);
    /// Never holds, but after 20 s; if there may be no answer, after 10 ms for planners that do not finish.
    ompl::base::PlannerTerminationCondition patience(bool mayBeInVain = false);

    /// Solves, and judges: the status says what the problem then has; every solution that was added is a valid path
    /// from a start to the goal, its cost that of the objective, optimised only if that is satisfied, and has the
    /// planner's name. `when` is put before violations.
    ompl::base::PlannerStatus solve(const ompl::base::PlannerPtr &planner,
                                    const ompl::base::PlannerTerminationCondition &condition, const std::string &when);
    /// The same, and the solution has to be exact. @return the cost of the problem's best path, infinity if there is
    /// none
    double mustSolve(const ompl::base::PlannerPtr &planner, const std::string &when);
    /// The same, and there must be no exact solution.
    ompl::base::PlannerStatus mustNotSolve(const ompl::base::PlannerPtr &planner, const std::string &when);

    /// Judges a path: each state valid and each leg clear, by the space's own motion validator and by the arena.
    bool judgePath(ompl::geometric::PathGeometric &path, const std::string &when);

private:
    void judgeSolution(const ompl::base::PlannerPtr &planner, const ompl::base::PlannerSolution &solution,
                       const std::string &when);

    const PlannerUnderTest &subject_;
    const PlannerArena &arena_;
    std::shared_ptr<Observed> observed_;
    CensusPtr census_;
    ompl::base::SpaceInformationPtr si_;
    Violations violations_;
};

/// The path of the best solution; nullptr if there is none.
std::shared_ptr<ompl::geometric::PathGeometric> bestPath(const ompl::base::ProblemDefinitionPtr &problem);
/// Its cost by the problem's objective, path length if there is none; infinity if there is no path.
double bestCost(const ompl::base::ProblemDefinitionPtr &problem);

bool isClose(double a, double b);
std::string toText(double value);
std::string inQuotes(const std::string &text);
std::string nameOf(const ompl::base::PlannerStatus &status);

}  // namespace seahex::test
