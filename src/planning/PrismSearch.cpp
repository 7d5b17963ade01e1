#include "planning/PrismSearch.h"

#include "seahex/route/StringPulling.h"

#include <ompl/base/ScopedState.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

constexpr double cellsAcross = 200.0;   // of a box, by default
constexpr double mostNodesRead = 1e8;   // nothing but two bits of most of them is touched
constexpr double mostNodesAsked = 1e7;  // a byte each
constexpr double mostLayers = 1000.0;

std::vector<Point3> positionsOf(const std::vector<const ob::State *> &states)
{
    std::vector<Point3> positions;
    for (const ob::State *state : states)
        positions.push_back(SpaceJudge::positionOf(state));
    return positions;
}

}  // namespace

PrismSearch::PrismSearch(PrismGround ground, ob::OptimizationObjectivePtr objective, const PrismSettings &settings,
                         ProgressBoard &board, SliceProgress &progress, OnImprovement onImprovement)
    : ground_(std::move(ground)), objective_(std::move(objective)), settings_(settings), board_(board),
      progress_(progress), onImprovement_(std::move(onImprovement)), bestCost_(objective_->infiniteCost())
{
}

void PrismSearch::begin(const std::vector<ob::State *> &starts, const std::vector<ob::State *> &goals)
{
    starts_.assign(starts.begin(), starts.end());
    goals_.assign(goals.begin(), goals.end());
    stage_ = Stage::Straight;
    comparedPairs_ = 0;
    mayBeBettered_ = false;
    margin_ = 0.0;
    isWhole_ = false;
    expandedBefore_ += counters().expanded;
    query_.reset();
}

void PrismSearch::work(const ob::PlannerTerminationCondition &stop)
{
    SpaceJudge judge(ground_.si, stop, progress_);
    bool goesOn = !judge.isOver();
    while (goesOn && stage_ != Stage::Done && !isGoodEnough())
        goesOn = stage_ == Stage::Straight    ? compareStraight(judge)
                 : stage_ == Stage::Searching ? search(judge)
                                              : pull(judge);
    tellBoard();
}

bool PrismSearch::compareStraight(SpaceJudge &judge)
{
    for (; comparedPairs_ < starts_.size() * goals_.size(); ++comparedPairs_)
    {
        const ob::State *start = starts_[comparedPairs_ / goals_.size()];
        const ob::State *goal = goals_[comparedPairs_ % goals_.size()];
        const Point3 from = SpaceJudge::positionOf(start);
        const Point3 to = SpaceJudge::positionOf(goal);
        const LegJudge::Answer answer = ground_.judge(judge, from, to);
        if (answer == LegJudge::Answer::Interrupted)
            return false;
        if (answer == LegJudge::Answer::Valid)
            offer({from, to});
    }
    // Can any pair be better than the best of those that are joined?
    mayBeBettered_ = !best_;
    for (const ob::State *start : starts_)
        for (const ob::State *goal : goals_)
            mayBeBettered_ =
                mayBeBettered_ || objective_->isCostBetterThan(objective_->motionCostHeuristic(start, goal), bestCost_);
    stage_ = mayBeBettered_ ? Stage::Searching : Stage::Done;
    return true;
}

bool PrismSearch::search(SpaceJudge &judge)
{
    if (!query_)
    {
        const std::optional<PrismLattice> lattice = nextLattice();
        if (!lattice)
        {
            stage_ = Stage::Done;
            return true;
        }
        query_ =
            std::make_unique<PrismQuery>(ground_, *lattice, settings_.rings, positionsOf(starts_), positionsOf(goals_));
    }
    const PrismQuery::Step step = query_->work(judge);
    tellBoard();
    switch (step)
    {
        case PrismQuery::Step::Interrupted:
            return false;
        case PrismQuery::Step::Found:
            latticePath_ = query_->path();
            offer(latticePath_);
            answers_.clear();
            stage_ = settings_.smoothing ? Stage::Pulling : Stage::Done;
            return true;
        case PrismQuery::Step::Exhausted:
            break;
    }
    if (best_ || isWhole_)
    {
        stage_ = Stage::Done;
        return true;
    }
    expandedBefore_ += counters().expanded;
    query_.reset();
    return true;
}

bool PrismSearch::pull(SpaceJudge &judge)
{
    PrismQuestions questions(ground_, judge, answers_);
    const auto isValid = [&questions](const Point3 &from, const Point3 &to)
    {
        return questions.isValid(from, to);
    };
    std::vector<Point3> pulled = pulledTaut(latticePath_, isValid, 0.5 * query_->lattice().pitch());
    // Parts of valid motions need not be valid where a checker samples.
    for (std::size_t i = 1; i < pulled.size(); ++i)
        if (!isValid(pulled[i - 1], pulled[i]))
        {
            pulled = pullBothWays(latticePath_, isValid);
            break;
        }
    if (questions.isOver())
        return false;
    offer(pulled);
    stage_ = Stage::Done;
    return true;
}

double PrismSearch::thicknessFor(double pitch, double range) const
{
    if (settings_.thickness > 0.0)
        return settings_.thickness;
    if (!(range > 0.0))
        return pitch;
    const double thickness = ground_.climb == 0.0 ? range / 16.0 : std::min(range / 4.0, ground_.climb * pitch);
    return std::max(thickness, range / mostLayers);
}

/// The box of starts and goals with a margin that grows each time, but not beyond the space's bounds.
std::optional<PrismLattice> PrismSearch::nextLattice()
{
    if (isWhole_)
        return std::nullopt;
    Eigen::AlignedBox3d ends;
    for (const auto *states : {&starts_, &goals_})
        for (const ob::State *state : *states)
            ends.extend(SpaceJudge::positionOf(state));
    const Point whole = horizontal(ground_.bounds.sizes());
    margin_ =
        margin_ > 0.0
            ? 3.0 * margin_
            : std::max({0.25 * horizontal(ends.sizes()).norm(), 0.01 * whole.maxCoeff(), 8.0 * settings_.cellSize});
    const Box box{(horizontal(ends.min()).array() - margin_).matrix().cwiseMax(horizontal(ground_.bounds.min())),
                  (horizontal(ends.max()).array() + margin_).matrix().cwiseMin(horizontal(ground_.bounds.max()))};
    const Point sizes = box.max - box.min;
    isWhole_ = sizes == whole;
    const double pitch = settings_.cellSize > 0.0 ? settings_.cellSize : sizes.maxCoeff() / cellsAcross;

    // In open water there is no reason to go deeper than start and goal: what is free there is free above.
    const double top =
        ground_.arena ? std::max(ground_.bounds.min().z(), ground_.arena->limits().ceilingM) : ground_.bounds.min().z();
    const double bottom = ground_.arena ? ends.max().z() : ground_.bounds.max().z();
    const double thickness = thicknessFor(pitch, bottom - top);
    const double columns = sizes.x() / pitch + 72.0;  // with CellLayout's padding
    const double rows = sizes.y() / (0.5 * std::sqrt(3.0) * pitch) + 10.0;
    const double layers = 2.0 + std::max(0.0, (bottom - top) / thickness);
    if (columns * rows * layers > (ground_.arena ? mostNodesRead : mostNodesAsked) || layers >= 1e4)
    {
        OMPL_WARN("PrismAStar: %.0f x %.0f cells in %.0f layers are too many to be searched: make cell_size or "
                  "layer_thickness larger",
                  columns, rows, layers);
        isWhole_ = true;
        return std::nullopt;
    }
    return PrismLattice::between(HexLattice::covering(box, pitch), top, bottom, thickness);
}

bool PrismSearch::isGoodEnough() const
{
    return best_ && objective_->isSatisfied(bestCost_);
}

void PrismSearch::tellBoard()
{
    board_.expanded = expandedBefore_ + counters().expanded;
    board_.open = query_ ? query_->openSize() : 0;
}

void PrismSearch::offer(const std::vector<Point3> &points)
{
    auto path = std::make_shared<Path>(ground_.si);
    ob::ScopedState<> state(ground_.si);
    for (const Point3 &point : points)
    {
        SpaceJudge::place(state.get(), point);
        path->append(state.get());
    }
    const ob::Cost cost = path->cost(objective_);
    if (best_ && !objective_->isCostBetterThan(cost, bestCost_))
        return;
    best_ = path;
    bestCost_ = cost;
    board_.bestCost = cost.value();
    onImprovement_(path, cost);
}

PlanningOutcome PrismSearch::outcome() const
{
    if (stage_ == Stage::Done)
        return best_ ? PlanningOutcome::Found : PlanningOutcome::Exhausted;
    return best_ ? PlanningOutcome::Improvable : PlanningOutcome::OutOfTime;
}

std::optional<PrismLattice> PrismSearch::lattice() const
{
    return query_ ? std::optional<PrismLattice>(query_->lattice()) : std::nullopt;
}

}  // namespace seahex
