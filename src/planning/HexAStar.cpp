#include "seahex/planning/HexAStar.h"

#include "planning/LatticeQuery.h"
#include "seahex/planning/OccupancyMotionValidator.h"
#include "seahex/planning/OccupancyValidityChecker.h"
#include "seahex/planning/PlanarEmbedding.h"

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <chrono>
#include <cmath>
#include <stdexcept>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex
{
namespace
{

constexpr std::int64_t mostCells = 1000000;  // of a lattice that the planner lays itself

/// The occupancy that checker and motion validator of a problem share; nullptr if the problem is another.
std::shared_ptr<const HexOccupancy> sharedOccupancy(const ob::SpaceInformation &si)
{
    const auto *checker = dynamic_cast<const OccupancyValidityChecker *>(si.getStateValidityChecker().get());
    const auto *validator = dynamic_cast<const OccupancyMotionValidator *>(si.getMotionValidator().get());
    if (checker == nullptr || validator == nullptr || checker->occupancy() != validator->occupancy())
        return nullptr;
    return checker->occupancy();
}

HexLattice layLattice(const Box &bounds, double requestedCellSize)
{
    const Point extent = bounds.max - bounds.min;
    const double pitch = requestedCellSize > 0.0 ? requestedCellSize : extent.maxCoeff() / 200.0;
    const HexLattice lattice = HexLattice::covering(bounds, pitch);
    if (lattice.cellCount() > mostCells)
        throw ompl::Exception("HexAStar", "a cell size of " + std::to_string(pitch) + " makes " +
                                              std::to_string(lattice.cellCount()) + " cells; at most " +
                                              std::to_string(mostCells) + " are allowed");
    return lattice;
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
        throw std::domain_error("rings must be 1, 2 or 3, not " + std::to_string(rings));
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
        throw std::domain_error("guidance must be none, distance, cheng or tie_break, not '" + name + "'");
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
        throw std::domain_error("the cell size must be 0 or more, not " + std::to_string(pitch));
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
    query_.reset();
    occupancy_ = sharedOccupancy(*si_);
    lattice_ = occupancy_ ? occupancy_->lattice()
                          : layLattice(PlanarEmbedding(si_->getStateSpace().get()).bounds(), requestedCellSize_);
    if (!pdef_)
    {
        setup_ = false;
        return;
    }
    objective_ = pdef_->hasOptimizationObjective() ? pdef_->getOptimizationObjective()
                                                   : std::make_shared<ob::PathLengthOptimizationObjective>(si_);
}

void HexAStar::clear()
{
    ob::Planner::clear();
    query_.reset();
    freeStates();
    solution_.reset();
    trace_.clear();
    tracedIndices_.clear();
    counters_ = {};
    searchMs_ = 0.0;
    outcome_ = PlanningOutcome::None;
    setup_ = false;
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

bool HexAStar::collectStates(const ob::PlannerTerminationCondition &ptc)
{
    const std::size_t known = starts_.size() + goals_.size();
    while (const ob::State *state = pis_.nextStart())
        starts_.push_back(si_->cloneState(state));
    // wait for a first goal as long as there is time; take others only as they are there
    if (goals_.empty())
        if (const ob::State *state = pis_.nextGoal(ptc))
            goals_.push_back(si_->cloneState(state));
    while (const ob::State *state = pis_.nextGoal())
        goals_.push_back(si_->cloneState(state));
    return starts_.size() + goals_.size() > known;
}

ob::PlannerStatus HexAStar::solve(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    const auto *goal = dynamic_cast<const ob::GoalSampleableRegion *>(pdef_->getGoal().get());
    if (goal == nullptr)
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    const auto begin = std::chrono::steady_clock::now();
    if (collectStates(ptc))
        query_.reset();
    if (starts_.empty())
        return finish(PlanningOutcome::InvalidStart);
    if (goals_.empty())
        return finish(PlanningOutcome::InvalidGoal);
    if (solveInOneCell())
        return finish(PlanningOutcome::Found);

    if (!query_)
        startQuery();
    if (!query_->hasStart())
        return finish(PlanningOutcome::InvalidStart);
    if (!query_->hasGoal())
        return finish(PlanningOutcome::InvalidGoal);
    const SearchStatus status = query_->run(ptc);
    counters_ = query_->counters();
    searchMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();

    trace_.clear();
    const CellLayout layout(lattice_->columns(), lattice_->rows());
    for (const CellIndex index : tracedIndices_)
        trace_.push_back(layout.cell(index));
    if (status == SearchStatus::Stopped)
        return finish(PlanningOutcome::OutOfTime);
    if (status == SearchStatus::Exhausted)
        return finish(PlanningOutcome::Exhausted);
    addSolution(query_->path());
    return finish(PlanningOutcome::Found);
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

bool HexAStar::solveInOneCell()
{
    // A detour over the cell's centre would serve nothing.
    const PlanarEmbedding embedding(si_->getStateSpace().get());
    for (const ob::State *start : starts_)
        for (const ob::State *goal : goals_)
            if (lattice_->cellAt(embedding.position(start)) == lattice_->cellAt(embedding.position(goal)) &&
                si_->checkMotion(start, goal))
            {
                auto path = std::make_shared<og::PathGeometric>(si_, start, goal);
                addSolution(path);
                return true;
            }
    return false;
}

void HexAStar::addSolution(const ob::PathPtr &path)
{
    solution_ = path;
    const ob::Cost cost = path->cost(objective_);
    ob::PlannerSolution solution(path);
    solution.setPlannerName(getName());
    solution.setOptimized(objective_, cost, objective_->isSatisfied(cost));
    pdef_->addSolutionPath(solution);
}

ob::PlannerStatus HexAStar::finish(PlanningOutcome outcome)
{
    outcome_ = outcome;
    switch (outcome)
    {
        case PlanningOutcome::Found:
            return ob::PlannerStatus::EXACT_SOLUTION;
        case PlanningOutcome::InvalidStart:
            return ob::PlannerStatus::INVALID_START;
        case PlanningOutcome::InvalidGoal:
            return ob::PlannerStatus::INVALID_GOAL;
        default:
            return ob::PlannerStatus::TIMEOUT;
    }
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
