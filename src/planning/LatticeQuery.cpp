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
    const auto *lattice = dynamic_cast<const LatticeLengthObjective *>(&objective);
    if (lattice != nullptr && lattice->lattice().pitch() == question.lattice.pitch())
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
        jumps(layout, q.rings, q.allJumps || !metric ? JumpSet::All : JumpSet::Primitive), scratch(q.si)
    {
        if (!q.occupancy)
            cache = std::make_unique<MotionCache>(q.si, embedding, q.lattice, layout, jumps);
        for (const ob::State *state : q.starts)
            join(state, true);
        for (const ob::State *state : q.goals)
            join(state, false);
    }

    std::vector<GoalCell> goalCells() const
    {
        std::vector<GoalCell> cells;
        for (const Joint &joint : goals)
            cells.push_back({joint.cell, joint.cost});
        return cells;
    }

    std::map<CellIndex, double> startHeadings() const
    {
        std::map<CellIndex, double> headings;
        for (const Joint &joint : starts)
            headings.emplace(layout.index(joint.cell), headingFrom(embedding.position(joint.state),
                                                                   question.lattice.centre(joint.cell)));
        return headings;
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

private:
    void join(const ob::State *state, bool isStart)
    {
        const HexCoord own = question.lattice.cellAt(embedding.position(state));
        if (question.occupancy)
        {
            if (question.occupancy->isFree(own))
                add(state, own, isStart);
            return;
        }
        tryJoin(state, own, isStart);
        for (const RingOffset &offset : ringOffsets(1))
            tryJoin(state, own + offset.offset, isStart);
    }

    void tryJoin(const ob::State *state, HexCoord cell, bool isStart)
    {
        if (!question.lattice.contains(cell) || !cache->isCellUsable(layout.index(cell)))
            return;
        placeCentre(state, cell, isStart);
        const bool valid = isStart ? question.si->checkMotion(state, scratch.get())
                                   : question.si->checkMotion(scratch.get(), state);
        if (valid && question.si->isValid(scratch.get()))
            add(state, cell, isStart);
    }

    void placeCentre(const ob::State *state, HexCoord cell, bool isStart)
    {
        const Point p = embedding.position(state);
        const Point centre = question.lattice.centre(cell);
        embedding.place(scratch.get(), centre, isStart ? headingFrom(p, centre) : headingFrom(centre, p));
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
        return isStart ? objective.combineCosts(objective.initialCost(state),
                                                objective.motionCost(state, scratch.get())).value()
                       : objective.combineCosts(objective.motionCost(scratch.get(), state),
                                                objective.terminalCost(state)).value();
    }

    ob::ScopedState<> scratch;
};

template <class Graph>
class GraphQuery : public LatticeQuery
{
public:
    template <class MakeGraph>
    GraphQuery(std::unique_ptr<QueryParts> parts, MakeGraph &&makeGraph)
      : parts_(std::move(parts)), graph_(makeGraph(*parts_)), search_(graph_)
    {
        addStarts();
        search_.setTrace(parts_->question.trace);
    }

    bool hasStart() const override { return !parts_->starts.empty(); }
    bool hasGoal() const override { return !parts_->goals.empty(); }
    SearchCounters counters() const override { return search_.counters(); }

    SearchStatus run(const ob::PlannerTerminationCondition &stop) override
    {
        if (!parts_->cache)
            return search_.run([&stop] { return stop(); }, parts_->metric ? 500 : 16);
        parts_->cache->watch(stop);
        parts_->cache->resume();
        for (;;)
        {
            const SearchStatus status = search_.run([&stop] { return stop(); }, 16);
            if (status != SearchStatus::Found || !forbidInvalidMotion())
                return status;
            search_.reset();
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
        const Joint &first = bestJoint(parts_->starts, cells.front());
        const Joint &last = bestJoint(parts_->goals, cells.back());
        path->append(first.state);
        ob::ScopedState<> state(q.si);
        Point before = parts_->embedding.position(first.state);
        for (const CellIndex cell : cells)
        {
            const Point centre = q.lattice.centre(parts_->layout.cell(cell));
            parts_->embedding.place(state.get(), centre, headingFrom(before, centre));
            path->append(state.get());
            before = centre;
        }
        path->append(last.state);
        return path;
    }

private:
    void addStarts()
    {
        for (const Joint &joint : parts_->starts)
            search_.addStart(parts_->layout.index(joint.cell), joint.cost);
    }

    const Joint &bestJoint(const std::vector<Joint> &joints, CellIndex cell) const
    {
        const Joint *best = nullptr;
        for (const Joint &joint : joints)
            if (parts_->layout.index(joint.cell) == cell && (best == nullptr || graph_.better(joint.cost, best->cost)))
                best = &joint;
        return *best;
    }

    /// In SE(2) a motion depends on the yaw with which its first cell was reached, and that may have changed after it was
    /// asked for. Finds such a motion in the path and takes it out of the lattice.
    /// @return true if there was one, and the search has to start again
    bool forbidInvalidMotion()
    {
        if (!parts_->embedding.hasHeading())
            return false;
        const std::vector<CellIndex> cells = search_.path();
        const auto states = path();
        for (std::size_t i = 0; i + 1 < states->getStateCount(); ++i)
        {
            if (parts_->question.si->checkMotion(states->getState(i), states->getState(i + 1)))
                continue;
            if (i == 0)
            {
                dropJoint(parts_->starts, cells.front());
                return true;
            }
            if (i == cells.size())
            {
                dropJoint(parts_->goals, cells.back());
                graph_.setGoals(parts_->goalCells());
                return true;
            }
            const HexCoord step = parts_->layout.cell(cells[i]) - parts_->layout.cell(cells[i - 1]);
            for (std::size_t k = 0; k < parts_->jumps.size(); ++k)
                if (parts_->jumps.offset(k).offset == step)
                    parts_->cache->forbid(cells[i - 1], k);
            return true;
        }
        return false;
    }

    void dropJoint(std::vector<Joint> &joints, CellIndex cell)
    {
        joints.erase(joints.begin() + (&bestJoint(joints, cell) - joints.data()));
    }

    std::unique_ptr<QueryParts> parts_;
    Graph graph_;
    AStar<Graph> search_;
};

/// The graph of a query for one kind of weight: on the occupancy, or on the user's own checker.
template <class Weight, class MakeWeight>
std::unique_ptr<LatticeQuery> makeQuery(std::unique_ptr<QueryParts> parts, MakeWeight &&makeWeight)
{
    if (parts->question.occupancy)
        return std::make_unique<GraphQuery<HexGraph<Weight>>>(
            std::move(parts), [&](QueryParts &p)
            { return HexGraph<Weight>(*p.question.occupancy, p.jumps, p.goalCells(), makeWeight(p)); });
    return std::make_unique<GraphQuery<MotionGraph<Weight>>>(
        std::move(parts),
        [&](QueryParts &p)
        {
            return MotionGraph<Weight>(*p.cache, p.question.lattice, p.layout, p.jumps, p.startHeadings(),
                                       p.goalCells(), makeWeight(p));
        });
}

}  // namespace

std::unique_ptr<LatticeQuery> makeLatticeQuery(const LatticeQuestion &question)
{
    auto parts = std::make_unique<QueryParts>(question);
    if (parts->metric)
        return makeQuery<LengthWeight>(std::move(parts),
                                       [](const QueryParts &p)
                                       {
                                           return LengthWeight(p.question.lattice, p.jumps, *p.metric,
                                                               p.question.guidance, p.firstStart(), p.firstGoal());
                                       });
    return makeQuery<ObjectiveWeight>(
        std::move(parts),
        [](const QueryParts &p)
        {
            return ObjectiveWeight(p.question.si, *p.question.objective, p.embedding, p.question.lattice, p.layout,
                                   p.question.guidance, p.firstStart(), p.firstGoal());
        });
}

}  // namespace seahex
