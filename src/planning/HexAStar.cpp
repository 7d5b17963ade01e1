#include "seahex/planning/HexAStar.h"

#include "planning/AnytimeSearch.h"
#include "planning/EndStates.h"
#include "planning/ProblemLattice.h"
#include "planning/SearchTree.h"
#include "seahex/planning/PlanarEmbedding.h"

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex
{
namespace
{

std::string inFull(double value)
{
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << value;
    return text.str();
}

}  // namespace

HexAStar::HexAStar(const ob::SpaceInformationPtr &si)
    : ob::Planner(si, "HexAStar"), ends_(std::make_unique<EndStates>(si)), board_(std::make_unique<ProgressBoard>())
{
    static_cast<void>(PlanarEmbedding(si_->getStateSpace().get()));  // throws unless the space is planar
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.optimizingPaths = true;
    specs_.directed = false;
    specs_.approximateSolutions = false;
    specs_.canReportIntermediateSolutions = true;
    declareParameters();
    declareProgress();
}

HexAStar::~HexAStar() = default;

void HexAStar::declareParameters()
{
    declareParam<int>("rings", this, &HexAStar::setRings, &HexAStar::getRings, "1:1:3");
    params_.declareParam<std::string>(
        "guidance", [this](const std::string &name) { setGuidance(name); }, [this] { return getGuidance(); });
    params_["guidance"].setRangeSuggestion("none,distance,cheng,tie_break");
    declareParam<bool>("anytime", this, &HexAStar::setAnytime, &HexAStar::getAnytime, "0,1");
    declareParam<bool>("smoothing", this, &HexAStar::setSmoothing, &HexAStar::getSmoothing, "0,1");
    declareParam<bool>("approximate", this, &HexAStar::setApproximate, &HexAStar::getApproximate, "0,1");
    declareParam<bool>("all_jumps", this, &HexAStar::setAllJumps, &HexAStar::getAllJumps, "0,1");
    declareParam<bool>("direct", this, &HexAStar::setDirect, &HexAStar::getDirect, "0,1");
    declareParam<double>("cell_size", this, &HexAStar::setCellSize, &HexAStar::getCellSize, "0.:.01:1000000.");
}

void HexAStar::declareProgress()
{
    addPlannerProgressProperty("best cost REAL", [this] { return inFull(board_->bestCost); });
    addPlannerProgressProperty("lower bound REAL", [this] { return inFull(board_->lowerBound); });
    addPlannerProgressProperty("expanded INTEGER", [this] { return std::to_string(board_->expanded); });
    addPlannerProgressProperty("open INTEGER", [this] { return std::to_string(board_->open); });
}

void HexAStar::setRings(int rings)
{
    if (rings < 1 || rings > 3)
        throw ompl::Exception("HexAStar", "rings must be 1, 2 or 3, not " + std::to_string(rings));
    rings_ = rings;
    forgetSearch();
}

void HexAStar::setGuidance(Guidance guidance)
{
    guidance_ = guidance;
    forgetSearch();
}

void HexAStar::setGuidance(const std::string &name)
{
    const std::optional<Guidance> guidance = guidanceFromString(name);
    if (!guidance)
        throw ompl::Exception("HexAStar", "guidance must be none, distance, cheng or tie_break, not '" + name + "'");
    setGuidance(*guidance);
}

void HexAStar::setAnytime(bool anytime)
{
    anytime_ = anytime;
    forgetSearch();
}

void HexAStar::setSmoothing(bool smoothing)
{
    smoothing_ = smoothing;
    forgetSearch();
}

void HexAStar::setApproximate(bool approximate)
{
    approximate_ = approximate;
    specs_.approximateSolutions = approximate;
}

void HexAStar::setAllJumps(bool all)
{
    allJumps_ = all;
    forgetSearch();
}

void HexAStar::setDirect(bool direct)
{
    direct_ = direct;
    forgetSearch();
    setup_ = false;
}

void HexAStar::setCellSize(double pitch)
{
    if (!std::isfinite(pitch) || pitch < 0.0)
        throw ompl::Exception("HexAStar", "the cell size must be 0 or more, not " + std::to_string(pitch));
    requestedCellSize_ = pitch;
    forgetSearch();
    setup_ = false;
}

void HexAStar::setTracing(bool tracing)
{
    tracing_ = tracing;
    forgetSearch();
}

void HexAStar::setup()
{
    ob::Planner::setup();
    setup_ = false;  // unless all of the following goes well
    const PlanarEmbedding embedding(si_->getStateSpace().get());
    chart_ = sharedOccupancy(*si_);
    occupancy_ = chart_ ? withinBounds(chart_, embedding.bounds()) : nullptr;
    lattice_ = occupancy_ ? occupancy_->lattice() : layLattice(embedding, requestedCellSize_);
    if (occupancy_ && !direct_)
        requireAskable(*lattice_);
    if (!pdef_)
        return;
    problemObjective_ = pdef_->getOptimizationObjective();
    objective_ = problemObjective_ ? problemObjective_ : std::make_shared<ob::PathLengthOptimizationObjective>(si_);
    forgetSearch();
    setup_ = true;
}

void HexAStar::clear()
{
    ob::Planner::clear();
    forgetSearch();
    ends_->clear();
    trace_.clear();
    improvements_.clear();
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

void HexAStar::forgetSearch()
{
    tree_.reset();
    search_.reset();
    const double worst = objective_ ? objective_->infiniteCost().value() : std::numeric_limits<double>::infinity();
    board_->clear(worst, objective_ ? objective_->identityCost().value() : 0.0);
}

ob::PlannerStatus HexAStar::solve(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    if (isOutdated())
    {
        clear();
        checkValidity();
    }
    begin_ = std::chrono::steady_clock::now();
    counters_ = {};
    trace_.clear();
    improvements_.clear();
    outcome_ = PlanningOutcome::None;
    if (dynamic_cast<const ob::GoalSampleableRegion *>(pdef_->getGoal().get()) == nullptr)
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;

    if (search_ && search_->best())
        improvements_.push_back({0.0, search_->bestCost().value()});
    try
    {
        outcome_ = plan(ptc);
    }
    catch (...)
    {
        clear();  // an expansion that was cut short by the user's code would be missing from the search
        throw;
    }
    if (search_)
    {
        counters_ = search_->query() != nullptr ? search_->query()->counters() : SearchCounters{};
        trace_ = search_->trace();
    }
    searchMs_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin_).count();
    return tell();
}

PlanningOutcome HexAStar::plan(const ob::PlannerTerminationCondition &ptc)
{
    const ob::Goal &goal = *pdef_->getGoal();
    bool isNew = ends_->takeStarts(pis_);
    if (ends_->starts().empty())
        return PlanningOutcome::InvalidStart;
    isNew = ends_->takeGoals(pis_, goal, ptc) || isNew;
    isNew = ends_->awaitGoal(pis_, goal, ptc) || isNew;
    if (ends_->goals().empty())
        return pis_.haveMoreGoalStates() ? PlanningOutcome::OutOfTime : PlanningOutcome::InvalidGoal;
    if (isNew || !search_)
        beginSearch();
    search_->work(ptc);
    while (pis_.haveMoreGoalStates() && !ptc && ends_->takeGoals(pis_, goal, ptc))
    {
        beginSearch();
        search_->work(ptc);
    }
    return search_->outcome();
}

void HexAStar::beginSearch()
{
    if (!tree_)
        tree_ = std::make_unique<SearchTree>(si_);
    if (!search_)
    {
        const SearchSettings settings{rings_, guidance_, anytime_, smoothing_, allJumps_, direct_, tracing_};
        search_ = std::make_unique<AnytimeSearch>(
            SearchGround{si_, objective_, *lattice_, chart_, occupancy_}, settings, *board_,
            [this](const og::PathGeometric &path, ob::Cost cost) { note(path, cost); });
    }
    search_->begin({ends_->starts().begin(), ends_->starts().end()}, {ends_->goals().begin(), ends_->goals().end()});
}

void HexAStar::note(const og::PathGeometric &path, ob::Cost cost)
{
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin_;
    improvements_.push_back({since.count(), cost.value()});
    const auto &callback = pdef_->getIntermediateSolutionCallback();
    if (!callback)
        return;
    const auto &states = const_cast<og::PathGeometric &>(path).getStates();
    callback(this, {states.begin(), states.end()}, cost);
}

ob::PlannerStatus HexAStar::tell()
{
    if (search_ && search_->best())
    {
        addSolution(*search_->best(), false);
        return ob::PlannerStatus::EXACT_SOLUTION;
    }
    if (outcome_ == PlanningOutcome::InvalidStart)
        return ob::PlannerStatus::INVALID_START;
    if (outcome_ == PlanningOutcome::InvalidGoal)
        return ob::PlannerStatus::INVALID_GOAL;
    const auto towardsGoal = approximate_ && search_ ? search_->towardsGoal() : nullptr;
    if (!towardsGoal)
        return ob::PlannerStatus::TIMEOUT;
    const bool isExact = pdef_->getGoal()->isSatisfied(towardsGoal->getStates().back());
    addSolution(*towardsGoal, !isExact);
    return isExact ? ob::PlannerStatus::EXACT_SOLUTION : ob::PlannerStatus::APPROXIMATE_SOLUTION;
}

void HexAStar::addSolution(const og::PathGeometric &path, bool isApproximate)
{
    // A copy, because whoever has the solution may simplify it in place.
    auto copy = std::make_shared<og::PathGeometric>(path);
    const ob::Cost cost = copy->cost(objective_);
    double distance = 0.0;
    if (isApproximate)
        pdef_->getGoal()->isSatisfied(copy->getStates().back(), &distance);
    ob::PlannerSolution solution(copy);
    solution.setPlannerName(getName());
    solution.setOptimized(objective_, cost, !isApproximate && objective_->isSatisfied(cost));
    if (isApproximate)
        solution.setApproximate(distance);
    pdef_->addSolutionPath(solution);
}

void HexAStar::getPlannerData(ob::PlannerData &data) const
{
    ob::Planner::getPlannerData(data);
    if (!search_)
        return;
    if (search_->query() != nullptr)
        tree_->write(*search_->query(), *objective_, data);
    if (search_->best())
        tree_->write(search_->best(), *ends_, *lattice_, *objective_, data);
}

}  // namespace seahex
