#include "planning/AnytimeSearch.h"

#include "planning/ChartSearches.h"
#include "seahex/planning/AdmissibleHeuristic.h"
#include "seahex/planning/PlanarEmbedding.h"

#include <ompl/base/ScopedState.h>

#include <algorithm>
#include <utility>

namespace ob = ompl::base;

namespace seahex
{

AnytimeSearch::AnytimeSearch(SearchGround ground, const SearchSettings &settings, ProgressBoard &board,
                             OnImprovement onImprovement)
    : ground_(std::move(ground)), settings_(settings), board_(board), onImprovement_(std::move(onImprovement)),
      shortener_(ground_.si, ground_.objective, settings.direct ? ground_.chart : nullptr, ground_.lattice.pitch()),
      bestCost_(ground_.objective->infiniteCost())
{
}

void AnytimeSearch::planSteps()
{
    const auto add = [this](Step searching)
    {
        steps_.push_back(searching);
        if (settings_.smoothing)
            steps_.push_back(Step::Shorten);
    };
    steps_.clear();
    const bool isExact = settings_.exact && isPlainLength();
    levelsLeft_ = settings_.anytime && isPlainLength() ? ground_.searches->levels() : 0;
    for (std::size_t level = 0; level < levelsLeft_; ++level)
        add(Step::SearchLarge);
    if (isExact)
        steps_.push_back(Step::ProveEarly);
    if (settings_.anytime && settings_.jumps.rings > 1)
        add(Step::SearchFirst);
    add(Step::SearchAll);
    if (isExact)
        steps_.push_back(Step::Prove);
}

/// Is it about the straight lengths of the plane, for which there are better ways than the lattice's?
bool AnytimeSearch::isPlainLength()
{
    return settings_.smoothing && ground_.searches && suitsLengthSearch(question()) &&
           PlanarEmbedding(ground_.si->getStateSpace().get()).lattice() == nullptr;
}

void AnytimeSearch::begin(std::vector<const ob::State *> starts, std::vector<const ob::State *> goals)
{
    starts_ = std::move(starts);
    goals_ = std::move(goals);
    comparedPairs_ = 0;
    isProven_ = false;
    planSteps();
    step_ = 0;
    isInStep_ = false;
    query_.reset();
    latticePath_.reset();
    board_.lowerBound = ground_.objective->betterCost(leastCost(), bestCost_).value();
}

void AnytimeSearch::work(const ob::PlannerTerminationCondition &stop)
{
    if (!compareDirectly(stop))
        return;
    while (step_ < steps_.size() && !isProven_ && !(best_ && ground_.objective->isSatisfied(bestCost_)))
    {
        if (!take(steps_[step_], stop))
            return;
        isInStep_ = false;
        ++step_;
    }
}

PlanningOutcome AnytimeSearch::outcome() const
{
    const bool isDone = step_ >= steps_.size() || isProven_;
    if (best_)
        return isDone ? PlanningOutcome::Found : PlanningOutcome::Improvable;
    if (!isDone)
        return PlanningOutcome::OutOfTime;
    if (!query_->hasStart())
        return PlanningOutcome::InvalidStart;
    return query_->hasGoal() ? PlanningOutcome::Exhausted : PlanningOutcome::InvalidGoal;
}

std::vector<OffsetCoord> AnytimeSearch::trace() const
{
    const CellLayout layout(ground_.lattice.columns(), ground_.lattice.rows());
    std::vector<OffsetCoord> cells;
    for (const CellIndex index : trace_)
        cells.push_back(layout.offset(index));
    return cells;
}

bool AnytimeSearch::compareDirectly(const ob::PlannerTerminationCondition &stop)
{
    // A start and a goal in one cell: a detour over its centre would serve nothing.
    const PlanarEmbedding embedding(ground_.si->getStateSpace().get());
    const auto cellOf = [&](const ob::State *state)
    {
        return ground_.lattice.cellAt(embedding.position(state));
    };
    for (; comparedPairs_ < starts_.size() * goals_.size(); ++comparedPairs_)
    {
        const ob::State *start = starts_[comparedPairs_ / goals_.size()];
        const ob::State *goal = goals_[comparedPairs_ % goals_.size()];
        if (cellOf(start) != cellOf(goal))
            continue;
        if (stop)
            return false;
        if (!ground_.si->checkMotion(start, goal))
            continue;
        offer(std::make_shared<Path>(ground_.si, start, goal));
        if (starts_.size() * goals_.size() == 1)
            step_ = steps_.size();
    }
    return true;
}

bool AnytimeSearch::take(Step step, const ob::PlannerTerminationCondition &stop)
{
    switch (step)
    {
        case Step::SearchLarge:
            return searchLarge(stop);
        case Step::SearchFirst:
            return search(1, stop);
        case Step::SearchAll:
            return search(settings_.jumps.rings, stop);
        case Step::Shorten:
            return shorten(stop);
        case Step::ProveEarly:
            return !best_ || prove(stop);
        case Step::Prove:
            return prove(stop);
    }
    return true;
}

/// In the largest cells that are left and have a path; thereafter in some at most a quarter as wide, for it is not
/// worth the time to shorten many a path that is about as good.
bool AnytimeSearch::searchLarge(const ob::PlannerTerminationCondition &stop)
{
    const PlanarEmbedding embedding(ground_.si->getStateSpace().get());
    const HexLattice &lattice = *ground_.lattice.hexagons();
    const HexCoord start = lattice.cellAt(embedding.position(starts_.front()));
    const HexCoord goal = lattice.cellAt(embedding.position(goals_.front()));
    latticePath_.reset();
    if (!ground_.occupancy->isFree(toOffset(start)) || !ground_.occupancy->isFree(toOffset(goal)))
        return true;
    while (levelsLeft_ > 0 && !latticePath_)
    {
        if (stop)
            return false;
        const std::vector<HexCoord> corners = ground_.searches->largeCells(--levelsLeft_).path(start, goal);
        if (corners.empty())
            continue;
        levelsLeft_ -= std::min<std::size_t>(levelsLeft_, 1);
        std::vector<Point> points;
        for (const HexCoord corner : corners)
            points.push_back(lattice.centre(corner));
        points.insert(points.begin(), embedding.position(starts_.front()));
        points.push_back(embedding.position(goals_.front()));
        latticePath_ = pathThrough(points);
        offer(latticePath_);
    }
    return true;
}

bool AnytimeSearch::prove(const ob::PlannerTerminationCondition &stop)
{
    constexpr std::uint64_t pollInterval = 256;
    TautSearch &taut = ground_.searches->taut();
    const PlanarEmbedding embedding(ground_.si->getStateSpace().get());
    const double unit = embedding.lengthWeight();
    if (!isInStep_)
    {
        const double bound = best_ ? bestCost_.value() / unit : TautSearch::unbounded;
        taut.begin(embedding.position(starts_.front()), embedding.position(goals_.front()), bound);
    }
    isInStep_ = true;
    const auto isOver = [&]
    {
        board_.raiseLowerBound(taut.lowerBound() * unit);
        return stop();
    };
    if (taut.run(isOver, pollInterval) == SearchStatus::Stopped)
        return false;
    if (const Route route = taut.route(); !route.waypoints().empty())
        offer(pathThrough(route.waypoints()));
    board_.raiseLowerBound(taut.lowerBound() * unit);
    isProven_ = best_ && taut.isOptimal(bestCost_.value() / unit);
    return true;
}

/// States at these points, the first and last those of the start and the goal.
std::shared_ptr<AnytimeSearch::Path> AnytimeSearch::pathThrough(const std::vector<Point> &points) const
{
    const PlanarEmbedding embedding(ground_.si->getStateSpace().get());
    auto path = std::make_shared<Path>(ground_.si, starts_.front());
    ob::ScopedState<> state(ground_.si);
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
    {
        embedding.place(state.get(), points[i]);
        path->append(state.get());
    }
    path->append(goals_.front());
    return path;
}

bool AnytimeSearch::search(int rings, const ob::PlannerTerminationCondition &stop)
{
    if (!query_)
        makeQuery();
    if (!isInStep_)
        query_->useRings(rings);
    isInStep_ = true;
    latticePath_.reset();
    const SearchStatus status = query_->run(stop);
    if (status == SearchStatus::Stopped)
        return false;
    if (status == SearchStatus::Found)
    {
        latticePath_ = query_->path();
        offer(latticePath_);
        // the end of a search may have told its bound before the path's cost was known
        if (rings == settings_.jumps.rings && !settings_.smoothing)
            if (const auto bound = query_->lowerBound())
                board_.raiseLowerBound(*bound);
    }
    // A safe jump on an occupancy needs all cells under it to be free, so more rings reach no more cells.
    else if ((ground_.occupancy && settings_.jumps.rule == JumpRule::Safe) || !query_->hasStart() || !query_->hasGoal())
        step_ = steps_.size();
    return true;
}

bool AnytimeSearch::shorten(const ob::PlannerTerminationCondition &stop)
{
    if (!latticePath_)
        return true;
    if (!isInStep_)
        shortener_.begin(latticePath_);
    isInStep_ = true;
    const PathShortener::Result result = shortener_.work(stop);
    if (result.path)
        offer(result.path);
    return result.isFinished;
}

LatticeQuestion AnytimeSearch::question()
{
    LatticeQuestion question{ground_.si,       ground_.objective, ground_.lattice, ground_.occupancy,
                             settings_.direct, starts_,           goals_,          settings_.jumps};
    question.guidance = settings_.guidance;
    question.trace = settings_.tracing ? &trace_ : nullptr;
    question.board = &board_;
    question.tellsBound = !settings_.smoothing;
    question.searches = ground_.searches.get();
    return question;
}

void AnytimeSearch::makeQuery()
{
    trace_.clear();
    query_ = makeLatticeQuery(question());
}

void AnytimeSearch::offer(const std::shared_ptr<Path> &path)
{
    const ob::Cost cost = path->cost(ground_.objective);
    if (best_ && !ground_.objective->isCostBetterThan(cost, bestCost_))
        return;
    best_ = path;
    bestCost_ = cost;
    board_.bestCost = cost.value();
    if (ground_.objective->isCostBetterThan(cost, ob::Cost(board_.lowerBound)))
        board_.lowerBound = cost.value();  // both are the same but for rounding
    onImprovement_(*path, cost);
}

ob::Cost AnytimeSearch::leastCost() const
{
    ob::Cost least = ground_.objective->infiniteCost();
    for (const ob::State *start : starts_)
        for (const ob::State *goal : goals_)
            least = ground_.objective->betterCost(least, admissibleHeuristic(*ground_.objective, start, goal));
    return least;
}

}  // namespace seahex
