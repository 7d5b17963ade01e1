#include "seahex/planning/HexAStar.h"

#include "planning/LatticeQuery.h"
#include "planning/ProblemLattice.h"
#include "seahex/planning/PlanarEmbedding.h"

#include <ompl/base/goals/GoalState.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <typeinfo>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex
{
namespace
{

constexpr unsigned int mostSamples = 100;  // of a goal region that is no list of states

/// True for goals whose states are all there from the beginning: none will turn up later.
bool isListOfStates(const ob::Goal &goal)
{
    return typeid(goal) == typeid(ob::GoalState) || typeid(goal) == typeid(ob::GoalStates);
}

}  // namespace

HexAStar::HexAStar(const ob::SpaceInformationPtr &si) : ob::Planner(si, "HexAStar")
{
    static_cast<void>(PlanarEmbedding(si_->getStateSpace().get()));  // throws unless the space is planar
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.optimizingPaths = true;
    specs_.directed = false;
    specs_.approximateSolutions = false;
    declareParameters();
}

HexAStar::~HexAStar()
{
    query_.reset();
    freeStates();
}

void HexAStar::declareParameters()
{
    declareParam<int>("rings", this, &HexAStar::setRings, &HexAStar::getRings, "1:1:3");
    params_.declareParam<std::string>(
        "guidance", [this](const std::string &name) { setGuidance(name); }, [this] { return getGuidance(); });
    params_["guidance"].setRangeSuggestion("none,distance,cheng,tie_break");
    declareParam<bool>("all_jumps", this, &HexAStar::setAllJumps, &HexAStar::getAllJumps, "0,1");
    declareParam<double>("cell_size", this, &HexAStar::setCellSize, &HexAStar::getCellSize, "0.:.01:1000000.");
}

void HexAStar::setRings(int rings)
{
    if (rings < 1 || rings > 3)
        throw ompl::Exception("HexAStar", "rings must be 1, 2 or 3, not " + std::to_string(rings));
    rings_ = rings;
    query_.reset();
}

void HexAStar::setGuidance(Guidance guidance)
{
    guidance_ = guidance;
    query_.reset();
}

void HexAStar::setGuidance(const std::string &name)
{
    const std::optional<Guidance> guidance = guidanceFromString(name);
    if (!guidance)
        throw ompl::Exception("HexAStar", "guidance must be none, distance, cheng or tie_break, not '" + name + "'");
    setGuidance(*guidance);
}

void HexAStar::setAllJumps(bool all)
{
    allJumps_ = all;
    query_.reset();
}

void HexAStar::setCellSize(double pitch)
{
    if (!std::isfinite(pitch) || pitch < 0.0)
        throw ompl::Exception("HexAStar", "the cell size must be 0 or more, not " + std::to_string(pitch));
    requestedCellSize_ = pitch;
    query_.reset();
    setup_ = false;
}

void HexAStar::setTracing(bool tracing)
{
    tracing_ = tracing;
    query_.reset();
}

void HexAStar::setup()
{
    ob::Planner::setup();
    setup_ = false;  // unless all of the following goes well
    forgetQuery();
    const Box bounds = PlanarEmbedding(si_->getStateSpace().get()).bounds();
    chart_ = sharedOccupancy(*si_);
    occupancy_ = chart_ ? withinBounds(chart_, bounds) : nullptr;
    lattice_ = occupancy_ ? occupancy_->lattice() : layLattice(bounds, requestedCellSize_);
    if (!pdef_)
        return;
    problemObjective_ = pdef_->getOptimizationObjective();
    objective_ = problemObjective_ ? problemObjective_ : std::make_shared<ob::PathLengthOptimizationObjective>(si_);
    setup_ = true;
}

void HexAStar::clear()
{
    ob::Planner::clear();
    forgetQuery();
    freeStates();
    solution_.reset();
    trace_.clear();
    tracedIndices_.clear();
    counters_ = {};
    searchMs_ = 0.0;
    outcome_ = PlanningOutcome::None;
    setup_ = false;
}

void HexAStar::setProblemDefinition(const ob::ProblemDefinitionPtr &pdef)
{
    if (pdef != pdef_)
        clear();
    ob::Planner::setProblemDefinition(pdef);
}

bool HexAStar::isOutdated() const
{
    return sharedOccupancy(*si_) != chart_ || pdef_->getOptimizationObjective() != problemObjective_;
}

void HexAStar::forgetQuery()
{
    query_.reset();
    comparedPairs_ = 0;
    directPath_.reset();
}

void HexAStar::freeStates()
{
    for (ob::State *state : starts_)
        si_->freeState(state);
    for (ob::State *state : goals_)
        si_->freeState(state);
    starts_.clear();
    goals_.clear();
}

void HexAStar::collectStarts()
{
    while (const ob::State *state = pis_.nextStart())
    {
        starts_.push_back(si_->cloneState(state));
        forgetQuery();
    }
}

void HexAStar::collectGoals(const ob::PlannerTerminationCondition &ptc)
{
    const auto take = [this](const ob::State *state)
    {
        goals_.push_back(si_->cloneState(state));
        forgetQuery();
    };
    const bool isList = isListOfStates(*pdef_->getGoal());
    const unsigned int most = isList ? std::numeric_limits<unsigned int>::max() : mostSamples;
    // Those that are there; nextGoal() makes one attempt, and none at all if the region can't give a sample now.
    for (bool goOn = true; goOn && pis_.haveMoreGoalStates() && pis_.getSampledGoalsCount() < most;)
    {
        const unsigned int sampled = pis_.getSampledGoalsCount();
        if (const ob::State *state = pis_.nextGoal())
            take(state);
        goOn = pis_.getSampledGoalsCount() > sampled && (!pis_.haveMoreGoalStates() || !ptc);
    }
    // If there is none, one may turn up while there is time.
    if (goals_.empty() && !isList)
        if (const ob::State *state = pis_.nextGoal(ptc))
            take(state);
}

ob::PlannerStatus HexAStar::solve(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    if (isOutdated())
    {
        clear();
        checkValidity();
    }
    outcome_ = PlanningOutcome::None;
    if (dynamic_cast<const ob::GoalSampleableRegion *>(pdef_->getGoal().get()) == nullptr)
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;

    const auto begin = std::chrono::steady_clock::now();
    counters_ = {};
    trace_.clear();
    solution_.reset();
    outcome_ = plan(ptc);
    searchMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    if (solution_)
    {
        addSolution();
        return ob::PlannerStatus::EXACT_SOLUTION;
    }
    if (outcome_ == PlanningOutcome::InvalidStart)
        return ob::PlannerStatus::INVALID_START;
    if (outcome_ == PlanningOutcome::InvalidGoal)
        return ob::PlannerStatus::INVALID_GOAL;
    return ob::PlannerStatus::TIMEOUT;
}

PlanningOutcome HexAStar::plan(const ob::PlannerTerminationCondition &ptc)
{
    collectStarts();
    if (starts_.empty())
        return PlanningOutcome::InvalidStart;
    collectGoals(ptc);
    if (goals_.empty())
        return pis_.haveMoreGoalStates() ? PlanningOutcome::OutOfTime : PlanningOutcome::InvalidGoal;
    const bool compared = joinDirectly(ptc);
    solution_ = directPath_;
    if (solution_ && starts_.size() == 1 && goals_.size() == 1)
        return PlanningOutcome::Found;
    return compared ? searchLattice(ptc) : PlanningOutcome::OutOfTime;
}

bool HexAStar::joinDirectly(const ob::PlannerTerminationCondition &ptc)
{
    // A detour over the cell's centre would serve nothing.
    const PlanarEmbedding embedding(si_->getStateSpace().get());
    const auto cellOf = [&](const ob::State *state)
    {
        return lattice_->cellAt(embedding.position(state));
    };
    int motions = 0;
    for (; comparedPairs_ < starts_.size() * goals_.size(); ++comparedPairs_)
    {
        const ob::State *start = starts_[comparedPairs_ / goals_.size()];
        const ob::State *goal = goals_[comparedPairs_ % goals_.size()];
        if (cellOf(start) != cellOf(goal))
            continue;
        if (++motions % 8 == 0 && ptc)
            return false;
        if (!si_->checkMotion(start, goal))
            continue;
        auto path = std::make_shared<og::PathGeometric>(si_, start, goal);
        if (!directPath_ || objective_->isCostBetterThan(path->cost(objective_), directPath_->cost(objective_)))
            directPath_ = std::move(path);
    }
    return true;
}

PlanningOutcome HexAStar::searchLattice(const ob::PlannerTerminationCondition &ptc)
{
    if (!query_)
        startQuery();
    const SearchStatus status = query_->run(ptc);
    counters_ = query_->counters();
    const CellLayout layout(lattice_->columns(), lattice_->rows());
    for (const CellIndex index : tracedIndices_)
        trace_.push_back(layout.cell(index));
    if (status == SearchStatus::Stopped)
        return PlanningOutcome::OutOfTime;
    if (status == SearchStatus::Found)
    {
        const ob::PathPtr path = query_->path();
        if (!solution_ || objective_->isCostBetterThan(path->cost(objective_), solution_->cost(objective_)))
            solution_ = path;
    }
    if (solution_)
        return PlanningOutcome::Found;
    if (!query_->hasStart())
        return PlanningOutcome::InvalidStart;
    return query_->hasGoal() ? PlanningOutcome::Exhausted : PlanningOutcome::InvalidGoal;
}

void HexAStar::startQuery()
{
    LatticeQuestion question{si_, objective_, *lattice_, occupancy_, {}, {}};
    question.rings = rings_;
    question.allJumps = allJumps_;
    question.guidance = guidance_;
    question.starts.assign(starts_.begin(), starts_.end());
    question.goals.assign(goals_.begin(), goals_.end());
    tracedIndices_.clear();
    question.trace = tracing_ ? &tracedIndices_ : nullptr;
    query_ = makeLatticeQuery(question);
}

void HexAStar::addSolution()
{
    const ob::Cost cost = solution_->cost(objective_);
    // A copy, because whoever has the solution may simplify it in place.
    ob::PlannerSolution solution(
        std::make_shared<og::PathGeometric>(static_cast<const og::PathGeometric &>(*solution_)));
    solution.setPlannerName(getName());
    solution.setOptimized(objective_, cost, objective_->isSatisfied(cost));
    pdef_->addSolutionPath(solution);
}

void HexAStar::getPlannerData(ob::PlannerData &data) const
{
    ob::Planner::getPlannerData(data);
    const auto *path = dynamic_cast<const og::PathGeometric *>(solution_.get());
    if (path == nullptr)
        return;
    for (std::size_t i = 0; i < path->getStateCount(); ++i)
    {
        const ob::PlannerDataVertex vertex(path->getState(static_cast<unsigned int>(i)));
        if (i == 0)
            data.addStartVertex(vertex);
        else if (i + 1 == path->getStateCount())
            data.addGoalVertex(vertex);
        if (i > 0)
            data.addEdge(ob::PlannerDataVertex(path->getState(static_cast<unsigned int>(i - 1))), vertex);
    }
}

}  // namespace seahex
