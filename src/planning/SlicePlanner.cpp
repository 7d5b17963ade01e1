#include "seahex/planning/SlicePlanner.h"

#include "planning/EndStates.h"
#include "planning/PathsAsData.h"
#include "planning/SliceQuery.h"

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <limits>
#include <sstream>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex
{
namespace
{

constexpr std::size_t mostPoints = 1000000;  // of all planes

std::string inFull(double value)
{
    std::ostringstream text;
    text.precision(std::numeric_limits<double>::max_digits10);
    text << value;
    return text.str();
}

const ob::RealVectorStateSpace *solidSpace(const ob::SpaceInformation &si)
{
    const auto *space = dynamic_cast<const ob::RealVectorStateSpace *>(si.getStateSpace().get());
    return space != nullptr && space->getDimension() == 3 ? space : nullptr;
}

Eigen::AlignedBox3d boundsOf(const ob::SpaceInformation &si)
{
    const ob::RealVectorBounds &bounds = solidSpace(si)->getBounds();
    return {Eigen::Vector3d(bounds.low.data()), Eigen::Vector3d(bounds.high.data())};
}

}  // namespace

SlicePlanner::SlicePlanner(const ob::SpaceInformationPtr &si, const std::string &name)
    : ob::Planner(si, name), ends_(std::make_unique<EndStates>(si)), bestCost_(0.0),
      progress_(std::make_unique<SliceProgress>())
{
    if (solidSpace(*si_) == nullptr)
        throw ompl::Exception(getName(), "plans in RealVectorStateSpace of three dimensions only");
    specs_.recognizedGoal = ob::GOAL_SAMPLEABLE_REGION;
    specs_.optimizingPaths = true;
    specs_.directed = true;
    specs_.approximateSolutions = false;
    specs_.canReportIntermediateSolutions = true;
    declareParameters();
    declareProgress();
    progress_->clear(std::numeric_limits<double>::infinity());
}

SlicePlanner::~SlicePlanner() = default;

void SlicePlanner::declareParameters()
{
    declareParam<unsigned int>("slices", this, &SlicePlanner::setSlices, &SlicePlanner::getSlices, "2:1:1000");
    declareParam<unsigned int>("across", this, &SlicePlanner::setAcross, &SlicePlanner::getAcross, "2:1:1000");
    declareParam<unsigned int>("levels", this, &SlicePlanner::setLevels, &SlicePlanner::getLevels, "2:1:1000");
    declareParam<unsigned int>("neighbourhood", this, &SlicePlanner::setNeighbourhood, &SlicePlanner::getNeighbourhood,
                               "3:2:9");
    declareParam<double>("K", this, &SlicePlanner::setLengthWeight, &SlicePlanner::getLengthWeight, "0.:.05:1.");
    declareParam<double>("vehicle_length", this, &SlicePlanner::setVehicleLength, &SlicePlanner::getVehicleLength,
                         "0.001:0.5:1000000.");
    declareParam<bool>("inflate", this, &SlicePlanner::setInflate, &SlicePlanner::getInflate, "0,1");
    declareParam<bool>("optimise", this, &SlicePlanner::setOptimise, &SlicePlanner::getOptimise, "0,1");
    params_.declareParam<std::string>(
        "axis", [this](const std::string &axis) { setAxis(axis); }, [this] { return getAxis(); });
    params_["axis"].setRangeSuggestion("course,x,y");
}

void SlicePlanner::declareProgress()
{
    addPlannerProgressProperty("best cost REAL", [this] { return inFull(progress_->bestCost); });
    addPlannerProgressProperty("points INTEGER", [this] { return std::to_string(progress_->points); });
    addPlannerProgressProperty("legs INTEGER", [this] { return std::to_string(progress_->legs); });
}

void SlicePlanner::setup()
{
    ob::Planner::setup();
    setup_ = false;  // unless all of the following goes well
    const std::size_t points = std::size_t{getSlices()} * getAcross() * getLevels();
    if (points > mostPoints)
        throw ompl::Exception(getName(), "slices of " + std::to_string(points) + " points in all; at most " +
                                             std::to_string(mostPoints) + " are allowed");
    if (!pdef_)
        return;
    problemObjective_ = pdef_->getOptimizationObjective();
    objective_ = problemObjective_ ? problemObjective_ : std::make_shared<ob::PathLengthOptimizationObjective>(si_);
    forgetSearch();
    setup_ = true;
}

void SlicePlanner::clear()
{
    ob::Planner::clear();
    forgetSearch();
    ends_->clear();
    outcome_ = PlanningOutcome::None;
}

void SlicePlanner::forgetSearch()
{
    queries_.clear();
    pairedStarts_ = 0;
    pairedGoals_ = 0;
    paths_.clear();
    best_.reset();
    selection_.reset();
    deadEnds_.clear();
    progress_->clear(objective_ ? objective_->infiniteCost().value() : std::numeric_limits<double>::infinity());
    setup_ = false;
}

void SlicePlanner::setProblemDefinition(const ob::ProblemDefinitionPtr &pdef)
{
    if (pdef != pdef_)
        clear();
    ob::Planner::setProblemDefinition(pdef);
}

ob::PlannerStatus SlicePlanner::solve(const ob::PlannerTerminationCondition &ptc)
{
    checkValidity();
    if (pdef_->getOptimizationObjective() != problemObjective_)
    {
        clear();
        checkValidity();
    }
    outcome_ = PlanningOutcome::None;
    if (dynamic_cast<const ob::GoalSampleableRegion *>(pdef_->getGoal().get()) == nullptr)
        return ob::PlannerStatus::UNRECOGNIZED_GOAL_TYPE;
    try
    {
        outcome_ = plan(ptc);
    }
    catch (...)
    {
        clear();
        throw;
    }
    return tell();
}

PlanningOutcome SlicePlanner::plan(const ob::PlannerTerminationCondition &ptc)
{
    const ob::Goal &goal = *pdef_->getGoal();
    ends_->takeStarts(pis_);
    if (ends_->starts().empty())
        return PlanningOutcome::InvalidStart;
    ends_->takeGoals(pis_, goal, ptc);
    ends_->awaitGoal(pis_, goal, ptc);
    if (ends_->goals().empty())
        return pis_.haveMoreGoalStates() ? PlanningOutcome::OutOfTime : PlanningOutcome::InvalidGoal;
    SpaceJudge judge(si_, ptc, *progress_);
    do
    {
        addQueries();
        if (!work(judge))
            return best_ ? PlanningOutcome::Improvable : PlanningOutcome::OutOfTime;
    } while (pis_.haveMoreGoalStates() && !ptc && ends_->takeGoals(pis_, goal, ptc));
    return best_ ? PlanningOutcome::Found : PlanningOutcome::Exhausted;
}

void SlicePlanner::addQueries()
{
    const SliceTerms terms{resolution_, axis_, criterion_, inflate_, optimise_};
    const auto &starts = ends_->starts();
    const auto &goals = ends_->goals();
    for (std::size_t i = 0; i < starts.size(); ++i)
        for (std::size_t k = 0; k < goals.size(); ++k)
            if (i >= pairedStarts_ || k >= pairedGoals_)
                queries_.push_back(
                    std::make_unique<SliceQuery>(SliceEnds{i, k, starts[i], goals[k]}, boundsOf(*si_), terms,
                                                 [this](const SliceProblem &problem) { return makeSearch(problem); }));
    pairedStarts_ = starts.size();
    pairedGoals_ = goals.size();
}

/// @return false if there is no time left, or the best path is good enough
bool SlicePlanner::work(SpaceJudge &judge)
{
    for (const auto &query : queries_)
        while (!query->isDone())
        {
            if (isGoodEnough())
                return false;
            if (isHopeless(*query))
            {
                query->finish();
                break;
            }
            const SliceQuery::Step step = query->work(judge);
            if (step == SliceQuery::Step::Interrupted)
                return false;
            if (step == SliceQuery::Step::Path)
                take(*query);
            else if (query->deadEnd())
                deadEnds_.push_back(*query->deadEnd());
        }
    return true;
}

bool SlicePlanner::isGoodEnough() const
{
    return best_ && objective_->isSatisfied(bestCost_);
}

bool SlicePlanner::isHopeless(const SliceQuery &query) const
{
    return best_ && !query.selection() &&
           !objective_->isCostBetterThan(objective_->motionCostHeuristic(query.ends().start, query.ends().goal),
                                         bestCost_);
}

void SlicePlanner::take(const SliceQuery &query)
{
    if (query.selection() && (!selection_ || query.selection()->figures.total <= selection_->figures.total))
        selection_ = query.selection();
    const std::vector<Eigen::Vector3d> &points = query.path();
    auto path = std::make_shared<og::PathGeometric>(si_, query.ends().start);
    ob::ScopedState<> state(si_);
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
    {
        SpaceJudge::place(state.get(), points[i]);
        path->append(state.get());
    }
    path->append(query.ends().goal);
    paths_.push_back(path);
    const ob::Cost cost = path->cost(objective_);
    if (best_ && !objective_->isCostBetterThan(cost, bestCost_))
        return;
    best_ = path;
    bestCost_ = cost;
    progress_->bestCost = cost.value();
    if (const auto &callback = pdef_->getIntermediateSolutionCallback())
        callback(this, {path->getStates().begin(), path->getStates().end()}, cost);
}

ob::PlannerStatus SlicePlanner::tell()
{
    if (outcome_ == PlanningOutcome::InvalidStart)
        return ob::PlannerStatus::INVALID_START;
    if (outcome_ == PlanningOutcome::InvalidGoal)
        return ob::PlannerStatus::INVALID_GOAL;
    if (!best_)
        return ob::PlannerStatus::TIMEOUT;
    // A copy, because whoever has the solution may simplify it in place.
    ob::PlannerSolution solution(std::make_shared<og::PathGeometric>(*best_));
    solution.setPlannerName(getName());
    solution.setOptimized(objective_, bestCost_, objective_->isSatisfied(bestCost_));
    pdef_->addSolutionPath(solution);
    return ob::PlannerStatus::EXACT_SOLUTION;
}

void SlicePlanner::getPlannerData(ob::PlannerData &data) const
{
    ob::Planner::getPlannerData(data);
    if (!ends_->goals().empty())
        writePaths(paths_, *ends_, *objective_, data);
}

}  // namespace seahex
