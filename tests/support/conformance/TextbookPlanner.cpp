#include "support/conformance/TextbookPlanner.h"

#include <seahex/planning/PlanarEmbedding.h>

#include <ompl/base/PlannerData.h>
#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <algorithm>
#include <cmath>
#include <typeinfo>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex::test
{

TextbookPlanner::TextbookPlanner(const ob::SpaceInformationPtr &si) : ob::Planner(si, "Textbook")
{
    static_cast<void>(PlanarEmbedding(si_->getStateSpace().get()));
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.optimizingPaths = true;
    specs_.canReportIntermediateSolutions = true;
    declareParam<int>("points", this, &TextbookPlanner::setPoints, &TextbookPlanner::getPoints, "10:1:1000");
    addPlannerProgressProperty("best cost REAL", [this] { return std::to_string(bestCost_.load()); });
    addPlannerProgressProperty("expanded INTEGER", [this] { return std::to_string(expanded_.load()); });
}

TextbookPlanner::~TextbookPlanner()
{
    TextbookPlanner::clear();
}

void TextbookPlanner::setPoints(int points)
{
    if (points < 10 || points > 1000)
        throw ompl::Exception("Textbook", "10 to 1000 points");
    points_ = points;
}

void TextbookPlanner::setup()
{
    ob::Planner::setup();
    const Box bounds = PlanarEmbedding(si_->getStateSpace().get()).bounds();
    low_ = bounds.min;
    high_ = bounds.max;
    setup_ = pdef_ != nullptr;
}

void TextbookPlanner::clear()
{
    ob::Planner::clear();
    for (const Node &node : nodes_)
        si_->freeState(node.state);
    nodes_.clear();
    grid_.clear();
    open_ = {};
    solution_.reset();
    bestCost_ = std::numeric_limits<double>::infinity();
    expanded_ = 0;
    setup_ = false;
}

void TextbookPlanner::setProblemDefinition(const ob::ProblemDefinitionPtr &pdef)
{
    if (pdef != pdef_)
        clear();
    ob::Planner::setProblemDefinition(pdef);
}

std::size_t TextbookPlanner::countOf(Kind kind) const
{
    return static_cast<std::size_t>(
        std::count_if(nodes_.begin(), nodes_.end(), [&](const Node &node) { return node.kind == kind; }));
}

void TextbookPlanner::addNode(const ob::State *state, Kind kind)
{
    nodes_.push_back({si_->cloneState(state), kind, 0.0, none, false, false});
}

void TextbookPlanner::layGrid()
{
    const PlanarEmbedding embedding(si_->getStateSpace().get());
    spacing_ = (high_ - low_).maxCoeff() / points_;
    columns_ = static_cast<std::size_t>((high_ - low_).x() / spacing_) + 1;
    const auto rows = static_cast<std::size_t>((high_ - low_).y() / spacing_) + 1;
    ob::State *state = si_->allocState();
    for (std::size_t i = 0; i < rows * columns_; ++i)
    {
        const std::size_t row = i / columns_;
        const Point p = low_ + spacing_ * Point(static_cast<double>(i % columns_), static_cast<double>(row));
        embedding.place(state, p.cwiseMin(high_));
        grid_.push_back(nodes_.size());
        addNode(state, Kind::Grid);
    }
    si_->freeState(state);
}

/// @return true if there are new ones
bool TextbookPlanner::collectStates(const ob::PlannerTerminationCondition &ptc)
{
    const std::size_t before = nodes_.size();
    while (const ob::State *state = pis_.nextStart())
        addNode(state, Kind::Start);
    if (countOf(Kind::Start) == 0)
        return false;
    const ob::Goal &goal = *pdef_->getGoal();
    const bool isList = typeid(goal) == typeid(ob::GoalState) || typeid(goal) == typeid(ob::GoalStates);
    while (pis_.haveMoreGoalStates() && (isList || pis_.getSampledGoalsCount() < 50))
    {
        const unsigned int sampled = pis_.getSampledGoalsCount();
        if (const ob::State *state = pis_.nextGoal())
            addNode(state, Kind::Goal);
        if (pis_.getSampledGoalsCount() == sampled)
            break;
    }
    if (countOf(Kind::Goal) == 0 && !isList)
        if (const ob::State *state = pis_.nextGoal(ptc))
            addNode(state, Kind::Goal);
    return nodes_.size() > before;
}

void TextbookPlanner::beginAgain()
{
    if (grid_.empty())
        layGrid();
    const auto isLater = [objective = objective_](const Entry &a, const Entry &b)
    {
        return objective->isCostBetterThan(ob::Cost(b.first), ob::Cost(a.first)) ||
               (a.first == b.first && a.second > b.second);
    };
    open_ = decltype(open_)(isLater);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
    {
        nodes_[i].isReached = nodes_[i].kind == Kind::Start;
        nodes_[i].isExpanded = false;
        nodes_[i].parent = none;
        nodes_[i].cost = objective_->initialCost(nodes_[i].state).value();
        if (nodes_[i].isReached)
            open_.emplace(nodes_[i].cost, i);
    }
    solution_.reset();
}

void TextbookPlanner::relax(std::size_t from, std::size_t to)
{
    Node &node = nodes_[to];
    if (node.isExpanded || node.kind == Kind::Start)
        return;
    const ob::Cost cost =
        objective_->combineCosts(ob::Cost(nodes_[from].cost), objective_->motionCost(nodes_[from].state, node.state));
    if (node.isReached && !objective_->isCostBetterThan(cost, ob::Cost(node.cost)))
        return;
    if (!si_->isValid(node.state) || !si_->checkMotion(nodes_[from].state, node.state))
        return;
    node.isReached = true;
    node.cost = cost.value();
    node.parent = from;
    open_.emplace(node.cost, to);
}

void TextbookPlanner::expand(std::size_t node)
{
    nodes_[node].isExpanded = true;
    ++expanded_;
    const PlanarEmbedding embedding(si_->getStateSpace().get());
    const Point p = embedding.position(nodes_[node].state);
    const double reach = 1.5 * spacing_;
    const auto column = static_cast<std::ptrdiff_t>(std::lround((p.x() - low_.x()) / spacing_));
    const auto row = static_cast<std::ptrdiff_t>(std::lround((p.y() - low_.y()) / spacing_));
    const auto columns = static_cast<std::ptrdiff_t>(columns_);
    for (std::ptrdiff_t y = row - 1; y <= row + 1; ++y)
        for (std::ptrdiff_t x = column - 1; x <= column + 1; ++x)
            if (x >= 0 && x < columns && y >= 0 && y * columns + x < static_cast<std::ptrdiff_t>(grid_.size()))
                relax(node, grid_[static_cast<std::size_t>(y * columns + x)]);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (nodes_[i].kind == Kind::Goal && (embedding.position(nodes_[i].state) - p).norm() <= reach)
            relax(node, i);
}

/// @return false if interrupted
bool TextbookPlanner::search(const ob::PlannerTerminationCondition &ptc)
{
    while (!solution_ && !open_.empty())
    {
        if (ptc)
            return false;
        const std::size_t node = open_.top().second;
        open_.pop();
        if (nodes_[node].isExpanded)
            continue;
        if (nodes_[node].kind == Kind::Goal)
            report(node);
        else
            expand(node);
    }
    return true;
}

void TextbookPlanner::report(std::size_t goal)
{
    std::vector<const ob::State *> states;
    for (std::size_t node = goal; node != none; node = nodes_[node].parent)
        states.push_back(nodes_[node].state);
    std::reverse(states.begin(), states.end());
    solution_ = std::make_shared<og::PathGeometric>(si_);
    for (const ob::State *state : states)
        solution_->append(state);
    const ob::Cost cost = solution_->cost(objective_);
    const bool isNews = !(bestCost_ <= cost.value());
    bestCost_ = cost.value();
    if (isNews && pdef_->getIntermediateSolutionCallback())
        pdef_->getIntermediateSolutionCallback()(this, states, cost);
}

ob::PlannerStatus TextbookPlanner::solve(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    if (dynamic_cast<const ob::GoalSampleableRegion *>(pdef_->getGoal().get()) == nullptr)
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    const bool isAnother = !objective_ || pdef_->getOptimizationObjective() != problemObjective_;
    if (isAnother)
    {
        problemObjective_ = pdef_->getOptimizationObjective();
        objective_ = problemObjective_ ? problemObjective_ : std::make_shared<ob::PathLengthOptimizationObjective>(si_);
        bestCost_ = std::numeric_limits<double>::infinity();
    }
    const bool hasNew = collectStates(ptc);
    if (countOf(Kind::Start) == 0)
        return ob::PlannerStatus::INVALID_START;
    if (countOf(Kind::Goal) == 0)
        return pis_.haveMoreGoalStates() ? ob::PlannerStatus::TIMEOUT : ob::PlannerStatus::INVALID_GOAL;
    if (hasNew || isAnother)
        beginAgain();
    search(ptc);
    if (!solution_)
        return ob::PlannerStatus::TIMEOUT;
    const ob::Cost cost = solution_->cost(objective_);
    ob::PlannerSolution solution(std::make_shared<og::PathGeometric>(*solution_));
    solution.setPlannerName(getName());
    solution.setOptimized(objective_, cost, objective_->isSatisfied(cost));
    pdef_->addSolutionPath(solution);
    return ob::PlannerStatus::EXACT_SOLUTION;
}

void TextbookPlanner::getPlannerData(ob::PlannerData &data) const
{
    ob::Planner::getPlannerData(data);
    for (const Node &node : nodes_)
    {
        const ob::PlannerDataVertex vertex(node.state);
        if (node.kind == Kind::Start)
            data.addStartVertex(vertex);
        if (!node.isReached || node.parent == none)
            continue;
        if (node.kind == Kind::Goal)
            data.addGoalVertex(vertex);
        const ob::State *parent = nodes_[node.parent].state;
        data.addEdge(ob::PlannerDataVertex(parent), vertex, ob::PlannerDataEdge(),
                     objective_->motionCost(parent, node.state));
    }
}

}  // namespace seahex::test
