#include "seahex/planning/PrismAStar.h"

#include "planning/EndStates.h"
#include "planning/PathsAsData.h"
#include "planning/PrismSearch.h"
#include "seahex/planning/SeabedMotionValidator.h"
#include "seahex/planning/SeabedValidityChecker.h"

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <typeinfo>

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

const ob::RealVectorStateSpace *solidSpace(const ob::SpaceInformation &si)
{
    const auto *space = dynamic_cast<const ob::RealVectorStateSpace *>(si.getStateSpace().get());
    return space != nullptr && space->getDimension() == 3 ? space : nullptr;
}

/// The arena of a problem that is that arena's and nothing else; nullptr for others.
std::shared_ptr<const DiveArena> sharedArena(const ob::SpaceInformation &si)
{
    const ob::StateValidityChecker &checker = *si.getStateValidityChecker();
    const ob::MotionValidator &validator = *si.getMotionValidator();
    if (typeid(checker) != typeid(SeabedValidityChecker) || typeid(validator) != typeid(SeabedMotionValidator))
        return nullptr;
    const auto &arena = static_cast<const SeabedValidityChecker &>(checker).arena();
    return arena == static_cast<const SeabedMotionValidator &>(validator).arena() ? arena : nullptr;
}

PrismGround groundOf(const ob::SpaceInformationPtr &si, double climb)
{
    const ob::RealVectorBounds &bounds = solidSpace(*si)->getBounds();
    const Eigen::AlignedBox3d box{Eigen::Vector3d(bounds.low.data()), Eigen::Vector3d(bounds.high.data())};
    return {si, sharedArena(*si), box, climb};
}

}  // namespace

PrismAStar::PrismAStar(const ob::SpaceInformationPtr &si)
    : ob::Planner(si, "PrismAStar"), ends_(std::make_unique<EndStates>(si)), board_(std::make_unique<ProgressBoard>()),
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
    forgetSearch();
}

PrismAStar::~PrismAStar() = default;

void PrismAStar::declareParameters()
{
    declareParam<unsigned int>("rings", this, &PrismAStar::setRings, &PrismAStar::getRings, "1:1:3");
    declareParam<double>("cell_size", this, &PrismAStar::setCellSize, &PrismAStar::getCellSize, "0.:.01:1000000.");
    declareParam<double>("layer_thickness", this, &PrismAStar::setLayerThickness, &PrismAStar::getLayerThickness,
                         "0.:.01:10000.");
    declareParam<double>("climb", this, &PrismAStar::setClimb, &PrismAStar::getClimb, "0.:.05:10.");
    declareParam<bool>("smoothing", this, &PrismAStar::setSmoothing, &PrismAStar::getSmoothing, "0,1");
}

void PrismAStar::declareProgress()
{
    addPlannerProgressProperty("best cost REAL", [this] { return inFull(board_->bestCost); });
    addPlannerProgressProperty("expanded INTEGER", [this] { return std::to_string(board_->expanded); });
    addPlannerProgressProperty("open INTEGER", [this] { return std::to_string(board_->open); });
}

void PrismAStar::setRings(unsigned int rings)
{
    if (rings < 1 || rings > 3)
        throw ompl::Exception(getName(), "rings must be 1, 2 or 3, not " + std::to_string(rings));
    rings_ = rings;
    forgetSearch();
}

void PrismAStar::requireNotNegative(const std::string &parameter, double value) const
{
    if (!std::isfinite(value) || value < 0.0)
        throw ompl::Exception(getName(), parameter + " must be 0 or more, not " + std::to_string(value));
}

void PrismAStar::setCellSize(double pitch)
{
    requireNotNegative("cell_size", pitch);
    cellSize_ = pitch;
    forgetSearch();
}

void PrismAStar::setLayerThickness(double thickness)
{
    requireNotNegative("layer_thickness", thickness);
    layerThickness_ = thickness;
    forgetSearch();
}

void PrismAStar::setClimb(double climb)
{
    requireNotNegative("climb", climb);
    climb_ = climb;
    forgetSearch();
}

void PrismAStar::setSmoothing(bool smoothing)
{
    smoothing_ = smoothing;
    forgetSearch();
}

void PrismAStar::setup()
{
    ob::Planner::setup();
    if (!pdef_)
    {
        setup_ = false;
        return;
    }
    problemObjective_ = pdef_->getOptimizationObjective();
    objective_ = problemObjective_ ? problemObjective_ : std::make_shared<ob::PathLengthOptimizationObjective>(si_);
    forgetSearch();
}

void PrismAStar::clear()
{
    ob::Planner::clear();
    forgetSearch();
    ends_->clear();
    outcome_ = PlanningOutcome::None;
    setup_ = false;
}

void PrismAStar::forgetSearch()
{
    search_.reset();
    paths_.clear();
    board_->clear(objective_ ? objective_->infiniteCost().value() : std::numeric_limits<double>::infinity(), 0.0);
}

void PrismAStar::setProblemDefinition(const ob::ProblemDefinitionPtr &pdef)
{
    if (pdef != pdef_)
        clear();
    ob::Planner::setProblemDefinition(pdef);
}

ob::PlannerStatus PrismAStar::solve(const ob::PlannerTerminationCondition &ptc)
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

PlanningOutcome PrismAStar::plan(const ob::PlannerTerminationCondition &ptc)
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

void PrismAStar::beginSearch()
{
    if (!search_)
        search_ = std::make_unique<PrismSearch>(
            groundOf(si_, climb_), objective_,
            PrismSettings{static_cast<int>(rings_), cellSize_, layerThickness_, smoothing_}, *board_, *progress_,
            [this](const std::shared_ptr<og::PathGeometric> &path, ob::Cost cost)
            {
                paths_.push_back(path);
                if (const auto &callback = pdef_->getIntermediateSolutionCallback())
                    callback(this, {path->getStates().begin(), path->getStates().end()}, cost);
            });
    search_->begin(ends_->starts(), ends_->goals());
}

ob::PlannerStatus PrismAStar::tell()
{
    if (outcome_ == PlanningOutcome::InvalidStart)
        return ob::PlannerStatus::INVALID_START;
    if (outcome_ == PlanningOutcome::InvalidGoal)
        return ob::PlannerStatus::INVALID_GOAL;
    if (!search_ || !search_->best())
        return ob::PlannerStatus::TIMEOUT;
    // A copy, because whoever has the solution may simplify it in place.
    ob::PlannerSolution solution(std::make_shared<og::PathGeometric>(*search_->best()));
    solution.setPlannerName(getName());
    solution.setOptimized(objective_, search_->bestCost(), objective_->isSatisfied(search_->bestCost()));
    pdef_->addSolutionPath(solution);
    return ob::PlannerStatus::EXACT_SOLUTION;
}

std::optional<PrismLattice> PrismAStar::lattice() const
{
    return search_ ? search_->lattice() : std::nullopt;
}

SearchCounters PrismAStar::counters() const
{
    return search_ ? search_->counters() : SearchCounters();
}

void PrismAStar::getPlannerData(ob::PlannerData &data) const
{
    ob::Planner::getPlannerData(data);
    if (!ends_->goals().empty())
        writePaths(paths_, *ends_, *objective_, data);
}

}  // namespace seahex
