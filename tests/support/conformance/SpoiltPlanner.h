#pragma once

#include "support/PlannerConformance.h"
#include "support/conformance/TextbookPlanner.h"

#include <ompl/base/PlannerData.h>
#include <ompl/base/ProblemDefinition.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace seahex::test
{

/// The textbook planner with one thing spoilt: what a hook is given for, it does instead.
class SpoiltPlanner : public TextbookPlanner
{
public:
    using Condition = ompl::base::PlannerTerminationCondition;

    using TextbookPlanner::TextbookPlanner;
    ~SpoiltPlanner() override
    {
        if (onDeath)
            onDeath();
    }

    std::function<ompl::base::PlannerStatus(const Condition &)> onSolve;
    std::function<void()> onSetup;
    std::function<void()> onClear;
    std::function<void()> onClearQuery;
    std::function<void(const ompl::base::ProblemDefinitionPtr &)> onProblem;
    std::function<void(ompl::base::PlannerData &)> onExport;
    std::function<void()> onDeath;

    ompl::base::PlannerStatus solve(const Condition &condition) override
    {
        return onSolve ? onSolve(condition) : solveWell(condition);
    }
    void setup() override { onSetup ? onSetup() : TextbookPlanner::setup(); }
    void clear() override { onClear ? onClear() : TextbookPlanner::clear(); }
    void clearQuery() override { onClearQuery ? onClearQuery() : clear(); }
    void setProblemDefinition(const ompl::base::ProblemDefinitionPtr &problem) override
    {
        onProblem ? onProblem(problem) : TextbookPlanner::setProblemDefinition(problem);
    }
    void getPlannerData(ompl::base::PlannerData &data) const override
    {
        onExport ? onExport(data) : TextbookPlanner::getPlannerData(data);
    }

    ompl::base::PlannerStatus solveWell(const Condition &condition) { return TextbookPlanner::solve(condition); }
    void takeProblem(const ompl::base::ProblemDefinitionPtr &problem) { Planner::setProblemDefinition(problem); }
    /// Solves a problem in place of the one that was given, which gets the solutions.
    ompl::base::PlannerStatus solveInstead(const ompl::base::ProblemDefinitionPtr &other, const Condition &condition);

    /// Solves, and changes the solution before anyone sees it.
    ompl::base::PlannerStatus solveAndChange(const Condition &condition,
                                             const std::function<void(ompl::base::PlannerSolution &)> &change);
    /// Makes a solution go there and back and there again.
    void addDetour(ompl::base::PlannerSolution &solution) const;

    ompl::base::PlannerSpecs &specs() { return specs_; }
    using Planner::addPlannerProgressProperty;
    using Planner::declareParam;
};

/// Something that is wrong with a planner, and the checks that have to find it with words of what they say then.
struct Defect
{
    std::string name;
    std::vector<std::pair<std::string, std::string>> foundBy;
    std::function<void(SpoiltPlanner &)> spoil;
};

// A file a group.
std::vector<Defect> lifecycleDefects();
std::vector<Defect> budgetDefects();
std::vector<Defect> answerDefects();
std::vector<Defect> reportDefects();

}  // namespace seahex::test
