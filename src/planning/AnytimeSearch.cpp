#include "planning/AnytimeSearch.h"

#include "planning/ChartSearches.h"
#include "seahex/planning/AdmissibleHeuristic.h"
#include "seahex/planning/PlanarEmbedding.h"
#include "seahex/world/SegmentValidity.h"

#include <ompl/base/ScopedState.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace ob = ompl::base;

namespace seahex
{
namespace
{

/// The step between neighbours in which b lies from a; some other difference where it lies in none.
HexCoord direction(HexCoord a, HexCoord b)
{
    const std::int64_t steps = std::max<std::int64_t>(hexDistance(a, b), 1);
    return {(b.q - a.q) / steps, (b.s - a.s) / steps};
}

}  // namespace

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
    const bool isExact = settings_.exact && isPlainLength() && endsAreClear();
    levelsLeft_ = 0;
    areStepsBegun_ = false;
    if (settings_.anytime && isPlainLength())
    {
        levelsLeft_ = ground_.searches->levels();
        add(Step::TrySteps);
        add(Step::SearchLarge);
        add(Step::SearchSteps);
    }
    else if (settings_.anytime && settings_.jumps.rings > 1)
        add(Step::SearchFirst);
    if (isExact)
        steps_.push_back(Step::ProveEarly);
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
    isShortest_ = false;
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
    while (step_ < steps_.size() && !isShortest_ && !(best_ && ground_.objective->isSatisfied(bestCost_)))
    {
        if (!take(steps_[step_], stop))
            return;
        isInStep_ = false;
        ++step_;
    }
}

PlanningOutcome AnytimeSearch::outcome() const
{
    const bool isDone = step_ >= steps_.size() || isShortest_;
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
    constexpr std::uint64_t fewExpansions = 1500;  // of jump points: some tenths of a millisecond
    if (step != Step::Shorten)
        latticePath_.reset();
    switch (step)
    {
        case Step::SearchLarge:
            return searchLarge(stop);
        case Step::TrySteps:
            return searchSteps(stop, fewExpansions);
        case Step::SearchSteps:
            return searchSteps(stop, std::numeric_limits<std::uint64_t>::max());
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

/// In the largest cells that have a path.
bool AnytimeSearch::searchLarge(const ob::PlannerTerminationCondition &stop)
{
    if (best_ || !endCellsAreFree())
        return true;
    const auto [start, goal] = endCells();
    while (levelsLeft_ > 0)
    {
        if (stop)
            return false;
        const std::vector<HexCoord> corners = ground_.searches->largeCells(--levelsLeft_).path(start, goal);
        if (!corners.empty())
        {
            offerRough(corners);
            return true;
        }
    }
    return true;
}

/// By steps between neighbours.
/// @param mostExpansions  pause after about so many
bool AnytimeSearch::searchSteps(const ob::PlannerTerminationCondition &stop, std::uint64_t mostExpansions)
{
    constexpr std::uint64_t pollInterval = 64;  // an expansion may look at thousands of cells
    if (best_ || !endCellsAreFree())
        return true;
    JumpPointSearch &steps = ground_.searches->steps();
    if (!areStepsBegun_)
    {
        const auto [start, goal] = endCells();
        steps.begin(start, goal);
    }
    areStepsBegun_ = true;
    bool isOver = false;
    const auto pauses = [&]
    {
        isOver = stop();
        return isOver || steps.counters().expanded >= mostExpansions;
    };
    if (steps.run(pauses, pollInterval) != SearchStatus::Found)
        return !isOver;  // where there is no path, the search with all rings will tell, and what can be reached
    std::vector<HexCoord> corners;
    for (const CellIndex index : steps.path())
    {
        const HexCoord cell = steps.layout().cell(index);
        const std::size_t count = corners.size();
        if (count > 1 && cell - corners[count - 1] == direction(corners[count - 2], corners[count - 1]))
            corners.back() = cell;
        else
            corners.push_back(cell);
    }
    offerRough(corners);
    return true;
}

/// Offers a path over the centres of these cells, to be shortened.
void AnytimeSearch::offerRough(const std::vector<HexCoord> &cells)
{
    const PlanarEmbedding embedding(ground_.si->getStateSpace().get());
    std::vector<Point> points = {embedding.position(starts_.front())};
    for (const HexCoord cell : cells)
        points.push_back(ground_.lattice.hexagons()->centre(cell));
    points.push_back(embedding.position(goals_.front()));
    latticePath_ = pathThrough(points);
    offer(latticePath_);
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
    isShortest_ = best_ && taut.isOptimal(bestCost_.value() / unit);
    return true;
}

std::pair<HexCoord, HexCoord> AnytimeSearch::endCells() const
{
    const PlanarEmbedding embedding(ground_.si->getStateSpace().get());
    const HexLattice &lattice = *ground_.lattice.hexagons();
    return {lattice.cellAt(embedding.position(starts_.front())), lattice.cellAt(embedding.position(goals_.front()))};
}

/// Do start and goal lie in cells that a search can begin and end with?
bool AnytimeSearch::endCellsAreFree() const
{
    const auto [start, goal] = endCells();
    return ground_.occupancy->isFree(toOffset(start)) && ground_.occupancy->isFree(toOffset(goal));
}

/// Do start and goal touch no cell that is left out? TautSearch knows no path from one that does.
bool AnytimeSearch::endsAreClear() const
{
    const PlanarEmbedding embedding(ground_.si->getStateSpace().get());
    const Point start = embedding.position(starts_.front());
    const Point goal = embedding.position(goals_.front());
    return isFree(*ground_.occupancy, start, start) && isFree(*ground_.occupancy, goal, goal);
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
