#include "seahex/planning/LatticeAStar.h"

#include "planning/AnytimeSearch.h"
#include "planning/ChartSearches.h"
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

LatticeAStar::LatticeAStar(const ob::SpaceInformationPtr &si, const std::string &name)
    : ob::Planner(si, name), ends_(std::make_unique<EndStates>(si)), board_(std::make_unique<ProgressBoard>())
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

LatticeAStar::~LatticeAStar() = default;

void LatticeAStar::declareParameters()
{
    params_.declareParam<std::string>(
        "guidance", [this](const std::string &name) { setGuidance(name); }, [this] { return getGuidance(); });
    params_["guidance"].setRangeSuggestion(guidanceNames());
    params_.declareParam<std::string>(
        "jumps", [this](const std::string &rule) { setJumps(rule); }, [this] { return getJumps(); });
    params_["jumps"].setRangeSuggestion("safe,hopping");
    declareParam<bool>("smoothing", this, &LatticeAStar::setSmoothing, &LatticeAStar::getSmoothing, "0,1");
    declareParam<bool>("approximate", this, &LatticeAStar::setApproximate, &LatticeAStar::getApproximate, "0,1");
    declareParam<bool>("direct", this, &LatticeAStar::setDirect, &LatticeAStar::getDirect, "0,1");
    declareParam<double>("cell_size", this, &LatticeAStar::setCellSize, &LatticeAStar::getCellSize, "0.:.01:1000000.");
}

void LatticeAStar::declareProgress()
{
    addPlannerProgressProperty("best cost REAL", [this] { return inFull(board_->bestCost); });
    addPlannerProgressProperty("lower bound REAL", [this] { return inFull(board_->lowerBound); });
    addPlannerProgressProperty("expanded INTEGER", [this] { return std::to_string(board_->expanded); });
    addPlannerProgressProperty("open INTEGER", [this] { return std::to_string(board_->open); });
}

void LatticeAStar::setGuidance(Guidance guidance)
{
    guidance_ = guidance;
    forgetSearch();
    setup_ = false;
}

void LatticeAStar::setGuidance(const std::string &name)
{
    const std::optional<Guidance> guidance = guidanceFromString(name);
    if (!guidance)
        throw ompl::Exception(getName(), "guidance must be one of " + guidanceNames() + ", not '" + name + "'");
    setGuidance(*guidance);
}

void LatticeAStar::setSmoothing(bool smoothing)
{
    smoothing_ = smoothing;
    forgetSearch();
}

bool LatticeAStar::isProvenShortest() const
{
    return search_ && search_->isProven();
}

void LatticeAStar::setApproximate(bool approximate)
{
    approximate_ = approximate;
    specs_.approximateSolutions = approximate;
}

void LatticeAStar::setJumps(JumpRule rule)
{
    jumpRule_ = rule;
    forgetSearch();
}

void LatticeAStar::setJumps(const std::string &rule)
{
    if (rule != toString(JumpRule::Safe) && rule != toString(JumpRule::Hopping))
        throw ompl::Exception(getName(), "jumps must be safe or hopping, not '" + rule + "'");
    setJumps(rule == toString(JumpRule::Safe) ? JumpRule::Safe : JumpRule::Hopping);
}

void LatticeAStar::setDirect(bool direct)
{
    direct_ = direct;
    forgetSearch();
    setup_ = false;
}

void LatticeAStar::setCellSize(double pitch)
{
    if (!std::isfinite(pitch) || pitch < 0.0)
        throw ompl::Exception(getName(), "the cell size must be 0 or more, not " + std::to_string(pitch));
    requestedCellSize_ = pitch;
    forgetSearch();
    setup_ = false;
}

void LatticeAStar::setTracing(bool tracing)
{
    tracing_ = tracing;
    forgetSearch();
}

void LatticeAStar::setup()
{
    ob::Planner::setup();
    setup_ = false;  // unless all of the following goes well
    const PlanarEmbedding embedding(si_->getStateSpace().get());
    const Box bounds = embedding.bounds();
    const auto chart = ownChart();
    if (chart != chart_ || bounds.min != bounds_.min || bounds.max != bounds_.max)
        occupancy_ = chart ? withinBounds(chart, bounds) : nullptr;
    chart_ = chart;
    bounds_ = bounds;
    const auto hexagons = std::dynamic_pointer_cast<const HexOccupancy>(occupancy_);
    if (!hexagons || !direct_ || guidance_ != Guidance::Automatic)
        searches_.reset();
    else if (!searches_ || searches_->occupancy() != hexagons)
        searches_ = std::make_shared<ChartSearches>(hexagons);
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

void LatticeAStar::clear()
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

void LatticeAStar::setProblemDefinition(const ob::ProblemDefinitionPtr &pdef)
{
    if (pdef != pdef_)
        clear();
    ob::Planner::setProblemDefinition(pdef);
}

std::shared_ptr<const Occupancy> LatticeAStar::ownChart() const
{
    auto chart = sharedOccupancy(*si_);
    return chart && isOwn(chart->lattice()) ? chart : nullptr;
}

bool LatticeAStar::isOutdated() const
{
    return ownChart() != chart_ || pdef_->getOptimizationObjective() != problemObjective_;
}

void LatticeAStar::forgetSearch()
{
    tree_.reset();
    search_.reset();
    const double worst = objective_ ? objective_->infiniteCost().value() : std::numeric_limits<double>::infinity();
    board_->clear(worst, objective_ ? objective_->identityCost().value() : 0.0);
}

ob::PlannerStatus LatticeAStar::solve(const ob::PlannerTerminationCondition &ptc)
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

PlanningOutcome LatticeAStar::plan(const ob::PlannerTerminationCondition &ptc)
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

void LatticeAStar::beginSearch()
{
    if (!tree_)
        tree_ = std::make_unique<SearchTree>(si_);
    if (!search_)
    {
        const SearchSettings settings{jumpChoice(), guidance_, searchesTwice(), smoothing_,
                                      isExact(),    direct_,   tracing_};
        search_ = std::make_unique<AnytimeSearch>(
            SearchGround{si_, objective_, *lattice_, chart_, occupancy_, searches_}, settings, *board_,
            [this](const og::PathGeometric &path, ob::Cost cost) { note(path, cost); });
    }
    search_->begin({ends_->starts().begin(), ends_->starts().end()}, {ends_->goals().begin(), ends_->goals().end()});
}

void LatticeAStar::note(const og::PathGeometric &path, ob::Cost cost)
{
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begin_;
    improvements_.push_back({since.count(), cost.value()});
    const auto &callback = pdef_->getIntermediateSolutionCallback();
    if (!callback)
        return;
    const auto &states = const_cast<og::PathGeometric &>(path).getStates();
    callback(this, {states.begin(), states.end()}, cost);
}

ob::PlannerStatus LatticeAStar::tell()
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

void LatticeAStar::addSolution(const og::PathGeometric &path, bool isApproximate)
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

void LatticeAStar::getPlannerData(ob::PlannerData &data) const
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
