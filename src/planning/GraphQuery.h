#pragma once

#include "planning/QueryParts.h"

#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace seahex
{

/// A query on a graph of one kind (JumpGraph, MotionGraph) and weight.
/// @tparam Search  with the functions of AStar that are used here
template <class Graph, class Search = AStar<Graph>>
class GraphQuery : public LatticeQuery
{
public:
    template <class MakeGraph>
    GraphQuery(std::unique_ptr<QueryParts> parts, MakeGraph &&makeGraph)
        : parts_(std::move(parts)), graph_(makeGraph(*parts_)), search_(graph_), rings_(parts_->question.jumps.rings)
    {
        search_.setTrace(parts_->question.trace);
        if (const ProgressBoard *board = parts_->question.board)
            expandedBefore_ = board->expanded;
    }

    bool hasStart() const override { return !parts_->starts.empty(); }
    bool hasGoal() const override { return !parts_->joinedGoals.empty(); }
    SearchCounters counters() const override { return search_.counters(); }

    void useRings(int rings) override
    {
        rings_ = rings;
        graph_.useRings(rings);
        if (!joined_)
            return;
        parts_->restore();
        graph_.setGoals(parts_->goalCells());
        beginAnew();
    }

    SearchStatus run(const ompl::base::PlannerTerminationCondition &stop) override
    {
        if (parts_->cache)
            parts_->cache->watch(stop);
        if (!joined_ && !join())
            return SearchStatus::Stopped;
        if (!hasStart() || !hasGoal())
            return SearchStatus::Exhausted;
        if (parts_->goals.empty())
            return SearchStatus::Exhausted;
        const SearchStatus status = parts_->cache ? runAsking() : runReading(stop);
        publish();
        return status;
    }

    std::shared_ptr<ompl::geometric::PathGeometric> path() const override
    {
        const std::vector<CellIndex> cells = search_.path();
        if (cells.empty())
            return nullptr;
        auto path = pathThrough(cells);
        const Joint &last = parts_->best(parts_->goals, parts_->layout.offset(cells.back()));
        // a path of one state would have no motion, and for costs that are minima no cost either
        if (!parts_->coincide(last.state, last.cell) || path->getStateCount() == 1)
            path->append(last.state);
        return path;
    }

    std::shared_ptr<ompl::geometric::PathGeometric> pathTowardsGoal() const override
    {
        std::optional<CellIndex> nearest;
        double least = std::numeric_limits<double>::infinity();
        search_.forEachReached(
            [&](CellIndex cell, std::uint8_t, bool)
            {
                for (const ompl::base::State *goal : parts_->question.goals)
                {
                    const double distance = (parts_->embedding.position(goal) - centre(cell)).norm();
                    if (distance < least)
                    {
                        least = distance;
                        nearest = cell;
                    }
                }
            });
        return nearest ? pathThrough(search_.pathTo(*nearest)) : nullptr;
    }

    std::optional<double> lowerBound() const override
    {
        const QueryParts &parts = *parts_;
        const bool admissible =
            parts.question.guidance != Guidance::Cheng || rings_ == 1 || parts.metric == LengthMetric::Lattice;
        // elsewhere the larger cost may be the better one, or more is charged than the search knows of
        const bool isLength = parts.question.objective->isCostBetterThan(ompl::base::Cost(0.0), ompl::base::Cost(1.0));
        if (!admissible || !isLength || parts.embedding.hasHeading() || !joined_)
            return std::nullopt;
        constexpr double rounding = 1e-8;  // of sums, and of the distances of a HexStateSpace
        return search_.leastKey() * parts.unit() * (1.0 - rounding);
    }

    void forEachVertex(const std::function<void(const TreeVertex &)> &visit) const override
    {
        search_.forEachReached(
            [&](CellIndex cell, std::uint8_t arrivedBy, bool isExpanded)
            {
                TreeVertex vertex{
                    parts_->layout.offset(cell), centre(cell), 0.0, std::nullopt, nullptr, false, isExpanded};
                if (arrivedBy == Search::noJump)
                {
                    const Joint &joint = parts_->best(parts_->starts, vertex.name.cell);
                    vertex.start = joint.state;
                    vertex.isStart = parts_->coincide(joint.state, joint.cell);
                    vertex.heading = parts_->jointHeading(joint.state, joint.cell, true);
                }
                else
                {
                    const CellIndex parent = graph_.predecessor(cell, arrivedBy);
                    vertex.parent = parts_->layout.offset(parent);
                    vertex.heading = courseBetween(centre(parent), vertex.position);
                }
                visit(vertex);
            });
    }

    void forEachReachedGoal(const std::function<void(const GoalVertex &)> &visit) const override
    {
        for (const Joint &joint : parts_->goals)
            if (search_.isReached(parts_->layout.index(joint.cell)))
                visit({joint.cell, joint.state, parts_->coincide(joint.state, joint.cell)});
    }

private:
    enum class Verdict
    {
        Sound,
        Mended,  // what did not hold was taken out of the lattice, and the search has to start again
        Interrupted
    };

    Point centre(CellIndex cell) const { return parts_->question.lattice.centre(parts_->layout.offset(cell)); }

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

    void beginAnew()
    {
        expandedBefore_ += search_.counters().expanded;
        search_.reset();
        if (parts_->question.trace != nullptr)
            parts_->question.trace->clear();
        examined_ = 1;
        addStarts();
    }

    SearchStatus runReading(const ompl::base::PlannerTerminationCondition &stop)
    {
        const auto isOver = [&]
        {
            publish();
            return stop();
        };
        return search_.run(isOver, parts_->isTabled() ? 500 : 16);
    }

    /// Where the problem is asked, the cache looks at the condition.
    SearchStatus runAsking()
    {
        const auto isOver = [this]
        {
            publish();
            return parts_->cache->interrupted();
        };
        for (;;)
        {
            const SearchStatus status = search_.run(isOver, 1);
            if (status != SearchStatus::Found || !parts_->embedding.hasHeading() ||
                parts_->question.jumps.rule == JumpRule::Hopping)
                return status;
            const Verdict verdict = examinePath();
            if (verdict != Verdict::Mended)
                return verdict == Verdict::Sound ? SearchStatus::Found : SearchStatus::Stopped;
            beginAnew();
            if (parts_->goals.empty())
                return SearchStatus::Exhausted;
        }
    }

    /// Tells how far the search has come.
    void publish()
    {
        if (ProgressBoard *board = parts_->question.board)
        {
            board->expanded.store(expandedBefore_ + search_.counters().expanded, std::memory_order_relaxed);
            board->open.store(search_.openSize(), std::memory_order_relaxed);
            if (parts_->question.tellsBound && rings_ == parts_->question.jumps.rings)
                if (const auto bound = lowerBound())
                    board->raiseLowerBound(*bound);
        }
    }

    /// A start state and the centres of cells.
    std::shared_ptr<ompl::geometric::PathGeometric> pathThrough(const std::vector<CellIndex> &cells) const
    {
        const LatticeQuestion &q = parts_->question;
        auto path = std::make_shared<ompl::geometric::PathGeometric>(q.si);
        const Joint &first = parts_->best(parts_->starts, parts_->layout.offset(cells.front()));
        path->append(first.state);
        ompl::base::ScopedState<> state(q.si);
        double heading = parts_->jointHeading(first.state, first.cell, true);
        for (std::size_t i = 0; i < cells.size(); ++i)
        {
            if (i > 0)
                heading = courseBetween(centre(cells[i - 1]), centre(cells[i]));
            parts_->embedding.place(state.get(), centre(cells[i]), heading);
            if (i > 0 || !parts_->coincide(first.state, first.cell))
                path->append(state.get());
        }
        return path;
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
            if (!parts_->cache->askMotion(states->getState(leg), states->getState(leg + 1)))
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
            parts_->dropGoal(parts_->layout.offset(cells.back()));
            return graph_.setGoals(parts_->goalCells());
        }
        for (std::size_t k = 0; k < parts_->jumps.size(); ++k)
            if (parts_->jumps.successor(cells[leg - 1], k) == cells[leg])
                parts_->cache->forbid(cells[leg - 1], k);
    }

    std::unique_ptr<QueryParts> parts_;
    Graph graph_;
    Search search_;
    int rings_;
    bool joined_ = false;
    std::uint64_t expandedBefore_ = 0;  // by searches that began anew
    // legs of the path found that hold: a start is joined by the very motion that was asked for
    std::size_t examined_ = 1;
};

}  // namespace seahex
