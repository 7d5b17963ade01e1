#include "planning/LatticeQuery.h"

#include "planning/MotionGraph.h"
#include "planning/ObjectiveWeight.h"
#include "seahex/geometry/HexNorm.h"
#include "seahex/planning/LatticeLengthObjective.h"
#include "seahex/search/HexGraph.h"
#include "seahex/search/LengthWeight.h"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <map>
#include <optional>
#include <typeinfo>
#include <utility>

namespace ob = ompl::base;
namespace og = ompl::geometric;

namespace seahex
{
namespace
{

/// A leg between a start or goal state and a cell's centre.
struct Joint
{
    HexCoord cell;
    double cost;
    const ob::State *state;
};

/// The metric of an objective that is a length, so that it need not be called for every jump.
std::optional<LengthMetric> lengthMetric(const LatticeQuestion &question)
{
    const ob::OptimizationObjective &objective = *question.objective;
    if (typeid(objective) == typeid(ob::PathLengthOptimizationObjective))
        return LengthMetric::Euclidean;
    if (typeid(objective) == typeid(LatticeLengthObjective) &&
        static_cast<const LatticeLengthObjective &>(objective).lattice().pitch() == question.lattice.pitch())
        return LengthMetric::Lattice;
    return std::nullopt;
}

double headingFrom(const Point &a, const Point &b)
{
    return std::atan2(b.y() - a.y(), b.x() - a.x());
}

/// What all queries share: embedding, layout, jumps, and the joints of starts and goals.
class QueryParts
{
public:
    explicit QueryParts(const LatticeQuestion &q)
        : question(q), embedding(q.si->getStateSpace().get()), metric(lengthMetric(q)),
          layout(q.occupancy ? q.occupancy->layout() : CellLayout(q.lattice.columns(), q.lattice.rows())),
          jumps(layout, q.rings, q.allJumps || !metric ? JumpSet::All : JumpSet::Primitive), scratch_(q.si)
    {
        if (!q.occupancy)
        {
            cache = std::make_unique<MotionCache>(q.si, embedding, q.lattice, layout, jumps);
            for (const RingOffset &offset : ringOffsets(1))
                around_.push_back(offset.offset);
        }
    }

    /// Joins starts and goals to their cells. @return false if interrupted; call it again to go on
    bool join()
    {
        for (; tried_ < (question.starts.size() + question.goals.size()) * around_.size(); ++tried_)
        {
            if (cache && cache->interrupted())
                return false;
            const std::size_t i = tried_ / around_.size();
            const bool isStart = i < question.starts.size();
            const ob::State *state = isStart ? question.starts[i] : question.goals[i - question.starts.size()];
            const HexCoord own = question.lattice.cellAt(embedding.position(state));
            tryJoin(state, own + around_[tried_ % around_.size()], isStart);
        }
        for (const Joint &joint : starts)
            startHeadings[layout.index(joint.cell)] = jointHeading(best(starts, joint.cell).state, joint.cell, true);
        return true;
    }

    /// The yaw at a centre that a start or goal joins: the course of the leg between them; the state's own where there
    /// is no way to go.
    double jointHeading(const ob::State *state, HexCoord cell, bool isStart) const
    {
        const Point p = embedding.position(state);
        const Point centre = question.lattice.centre(cell);
        if (p == centre)
            return embedding.heading(state);
        return isStart ? headingFrom(p, centre) : headingFrom(centre, p);
    }

    /// The cheapest of the joints to a cell.
    const Joint &best(const std::vector<Joint> &joints, HexCoord cell) const
    {
        const Joint *best = nullptr;
        for (const Joint &joint : joints)
            if (joint.cell == cell &&
                (best == nullptr || question.objective->isCostBetterThan(ob::Cost(joint.cost), ob::Cost(best->cost))))
                best = &joint;
        return *best;
    }

    /// Forgets the cheapest joint of a goal to a cell.
    void dropGoal(HexCoord cell) { goals.erase(goals.begin() + (&best(goals, cell) - goals.data())); }

    std::vector<GoalCell> goalCells() const
    {
        std::vector<GoalCell> cells;
        for (const Joint &joint : goals)
            cells.push_back({joint.cell, joint.cost});
        return cells;
    }

    Point firstStart() const { return embedding.position(question.starts.front()); }
    Point firstGoal() const { return embedding.position(question.goals.front()); }

    const LatticeQuestion question;
    const PlanarEmbedding embedding;
    const std::optional<LengthMetric> metric;
    const CellLayout layout;
    const HexJumps jumps;
    std::unique_ptr<MotionCache> cache;
    std::vector<Joint> starts;
    std::vector<Joint> goals;
    std::map<CellIndex, double> startHeadings;

private:
    void tryJoin(const ob::State *state, HexCoord cell, bool isStart)
    {
        if (question.occupancy)
        {
            if (question.occupancy->isFree(cell))
                add(state, cell, isStart);
            return;
        }
        if (!question.lattice.contains(cell) || !cache->isCellUsable(layout.index(cell)))
            return;
        placeCentre(state, cell, isStart);
        if (embedding.hasHeading() && !cache->ask(question.si->isValid(scratch_.get())))
            return;
        if (cache->ask(isStart ? question.si->checkMotion(state, scratch_.get())
                               : question.si->checkMotion(scratch_.get(), state)))
            add(state, cell, isStart);
    }

    void placeCentre(const ob::State *state, HexCoord cell, bool isStart)
    {
        embedding.place(scratch_.get(), question.lattice.centre(cell), jointHeading(state, cell, isStart));
    }

    void add(const ob::State *state, HexCoord cell, bool isStart)
    {
        (isStart ? starts : goals).push_back({cell, jointCost(state, cell, isStart), state});
    }

    double jointCost(const ob::State *state, HexCoord cell, bool isStart)
    {
        const Point leg = question.lattice.centre(cell) - embedding.position(state);
        if (metric == LengthMetric::Euclidean)
            return leg.norm() / question.lattice.pitch();
        if (metric == LengthMetric::Lattice)
            return hexNorm(leg, question.lattice);
        const ob::OptimizationObjective &objective = *question.objective;
        placeCentre(state, cell, isStart);
        return isStart
                   ? objective.combineCosts(objective.initialCost(state), objective.motionCost(state, scratch_.get()))
                         .value()
                   : objective.combineCosts(objective.motionCost(scratch_.get(), state), objective.terminalCost(state))
                         .value();
    }

    ob::ScopedState<> scratch_;
    std::vector<HexCoord> around_ = {{0, 0}};  // cells to join, relative to a state's own
    std::size_t tried_ = 0;
};

template <class Graph>
class GraphQuery : public LatticeQuery
{
public:
    template <class MakeGraph>
    GraphQuery(std::unique_ptr<QueryParts> parts, MakeGraph &&makeGraph)
        : parts_(std::move(parts)), graph_(makeGraph(*parts_)), search_(graph_)
    {
        search_.setTrace(parts_->question.trace);
    }

    bool hasStart() const override { return !parts_->starts.empty(); }
    bool hasGoal() const override { return !parts_->goals.empty(); }
    SearchCounters counters() const override { return search_.counters(); }

    SearchStatus run(const ob::PlannerTerminationCondition &stop) override
    {
        if (parts_->cache)
            parts_->cache->watch(stop);
        if (!joined_ && !join())
            return SearchStatus::Stopped;
        if (!hasStart() || !hasGoal())
            return SearchStatus::Exhausted;
        if (!parts_->cache)
            return search_.run([&stop] { return stop(); }, parts_->metric ? 500 : 16);
        for (;;)
        {
            const SearchStatus status = search_.run([this] { return parts_->cache->interrupted(); }, 1);
            if (status != SearchStatus::Found || !parts_->embedding.hasHeading())
                return status;
            const Verdict verdict = examinePath();
            if (verdict != Verdict::Mended)
                return verdict == Verdict::Sound ? SearchStatus::Found : SearchStatus::Stopped;
            search_.reset();
            if (parts_->question.trace != nullptr)
                parts_->question.trace->clear();
            examined_ = 1;
            addStarts();
        }
    }

    std::shared_ptr<og::PathGeometric> path() const override
    {
        const std::vector<CellIndex> cells = search_.path();
        if (cells.empty())
            return nullptr;
        const LatticeQuestion &q = parts_->question;
        auto path = std::make_shared<og::PathGeometric>(q.si);
        const Joint &first = parts_->best(parts_->starts, parts_->layout.cell(cells.front()));
        const Joint &last = parts_->best(parts_->goals, parts_->layout.cell(cells.back()));
        path->append(first.state);
        ob::ScopedState<> state(q.si);
        double heading = parts_->jointHeading(first.state, first.cell, true);
        for (std::size_t i = 0; i < cells.size(); ++i)
        {
            const Point centre = q.lattice.centre(parts_->layout.cell(cells[i]));
            if (i > 0)
                heading = headingFrom(q.lattice.centre(parts_->layout.cell(cells[i - 1])), centre);
            parts_->embedding.place(state.get(), centre, heading);
            path->append(state.get());
        }
        path->append(last.state);
        return path;
    }

private:
    enum class Verdict
    {
        Sound,
        Mended,  // what did not hold was taken out of the lattice, and the search has to start again
        Interrupted
    };

    bool join()
    {
        if (!parts_->join())
            return false;
        joined_ = true;
        graph_.setGoals(parts_->goalCells());
        addStarts();
        return true;
    }

    void addStarts()
    {
        for (const Joint &joint : parts_->starts)
            search_.addStart(parts_->layout.index(joint.cell), joint.cost);
    }

    /// In SE(2) a motion depends on the yaw with which its first cell was reached, and that may have changed after it
    /// was asked for. Asks again for each motion of the path found.
    Verdict examinePath()
    {
        const auto states = path();
        for (; examined_ + 1 < states->getStateCount(); ++examined_)
        {
            if (parts_->cache->interrupted())
                return Verdict::Interrupted;
            const auto leg = static_cast<unsigned int>(examined_);
            if (!parts_->cache->ask(parts_->question.si->checkMotion(states->getState(leg), states->getState(leg + 1))))
            {
                takeOut(examined_);
                return Verdict::Mended;
            }
        }
        return Verdict::Sound;
    }

    /// Takes a leg of the path found out of the lattice.
    void takeOut(std::size_t leg)
    {
        const std::vector<CellIndex> cells = search_.path();
        if (leg == cells.size())
        {
            parts_->dropGoal(parts_->layout.cell(cells.back()));
            return graph_.setGoals(parts_->goalCells());
        }
        const HexCoord step = parts_->layout.cell(cells[leg]) - parts_->layout.cell(cells[leg - 1]);
        for (std::size_t k = 0; k < parts_->jumps.size(); ++k)
            if (parts_->jumps.offset(k).offset == step)
                parts_->cache->forbid(cells[leg - 1], k);
    }

    std::unique_ptr<QueryParts> parts_;
    Graph graph_;
    AStar<Graph> search_;
    bool joined_ = false;
    std::size_t examined_ =
        1;  // legs of the path found that hold: a start is joined by the very motion that was asked for
};

/// The graph of a query for one kind of weight: on the occupancy, or on the user's own checker.
template <class Weight, class MakeWeight>
std::unique_ptr<LatticeQuery> makeQuery(std::unique_ptr<QueryParts> parts, MakeWeight &&makeWeight)
{
    if (parts->question.occupancy)
        return std::make_unique<GraphQuery<HexGraph<Weight>>>(
            std::move(parts), [&](QueryParts &p)
            { return HexGraph<Weight>(*p.question.occupancy, p.jumps, p.goalCells(), makeWeight(p)); });
    return std::make_unique<GraphQuery<MotionGraph<Weight>>>(std::move(parts),
                                                             [&](QueryParts &p)
                                                             {
                                                                 return MotionGraph<Weight>(
                                                                     *p.cache, p.question.lattice, p.layout, p.jumps,
                                                                     p.startHeadings, p.goalCells(), makeWeight(p));
                                                             });
}

}  // namespace

std::unique_ptr<LatticeQuery> makeLatticeQuery(const LatticeQuestion &question)
{
    auto parts = std::make_unique<QueryParts>(question);
    if (parts->metric)
        return makeQuery<LengthWeight>(std::move(parts),
                                       [](const QueryParts &p) {
                                           return LengthWeight(p.question.lattice, p.jumps, *p.metric,
                                                               p.question.guidance, p.firstStart(), p.firstGoal());
                                       });
    return makeQuery<ObjectiveWeight>(std::move(parts),
                                      [](const QueryParts &p)
                                      {
                                          return ObjectiveWeight(p.question.si, *p.question.objective, p.embedding,
                                                                 p.question.lattice, p.layout, p.question.guidance,
                                                                 p.firstStart(), p.firstGoal());
                                      });
}

}  // namespace seahex
