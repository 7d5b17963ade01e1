#pragma once

#include "planning/CourseWeight.h"
#include "planning/QueryParts.h"
#include "seahex/search/HeadingGraph.h"
#include "seahex/search/JumpGraph.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace seahex
{

/// A query in SE(2) on a chart that is read, for an objective that charges length and turns (CourseCosts): a search
/// over cells and headings, so that its path is the lattice's best, the yaws of start and goal included.
template <class Norm>
class HeadingQuery : public LatticeQuery
{
public:
    HeadingQuery(std::unique_ptr<QueryParts> parts, const typename Norm::KnownLattice &lattice)
        : parts_(std::move(parts)), weight_(lattice, *parts_),
          graph_(Cells(*parts_->question.occupancy, parts_->jumps, {}, weight_)), search_(graph_),
          rings_(parts_->question.jumps.rings)
    {
        if (parts_->question.trace != nullptr)
            search_.setTrace(&expandedStates_);
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
        expandedBefore_ += search_.counters().expanded;
        search_.reset();
        expandedStates_.clear();
        if (parts_->question.trace != nullptr)
            parts_->question.trace->clear();
        addStarts();
    }

    SearchStatus run(const ompl::base::PlannerTerminationCondition &stop) override
    {
        if (!joined_)
        {
            parts_->join();  // can't be interrupted where the occupancy is read
            joined_ = true;
            graph_.setGoals(goalCells());
            addStarts();
        }
        if (!hasStart() || !hasGoal())
            return SearchStatus::Exhausted;
        const auto isOver = [&]
        {
            publish();
            return stop();
        };
        const SearchStatus status = search_.run(isOver, 500);
        publish();
        if (std::vector<CellIndex> *trace = parts_->question.trace)
            for (std::size_t i = trace->size(); i < expandedStates_.size(); ++i)
                trace->push_back(graph_.cellOf(expandedStates_[i]));
        return status;
    }

    std::shared_ptr<ompl::geometric::PathGeometric> path() const override
    {
        const std::vector<CellIndex> states = search_.path();
        if (states.empty())
            return nullptr;
        const Legs legs = legsOf(states);
        const OffsetCoord last = legs.cells.back();
        const std::size_t heading = legs.headings.empty() ? noHeading() : legs.headings.back();
        const Joint &goal = *weight_.goalFor(last, heading);
        const Joint &start = legs.headings.empty() ? *weight_.startTo(last, goal) : startOf(legs);
        auto path = pathThrough(start, legs);
        path->append(goal.state);
        return path;
    }

    std::shared_ptr<ompl::geometric::PathGeometric> pathTowardsGoal() const override
    {
        std::optional<CellIndex> nearest;
        double least = std::numeric_limits<double>::infinity();
        forEachVertexState(
            [&](CellIndex state, std::uint8_t, bool)
            {
                for (const ompl::base::State *goal : parts_->question.goals)
                {
                    const double distance = (parts_->embedding.position(goal) - centre(graph_.cellOf(state))).norm();
                    const bool isCheaper = nearest && graph_.cellOf(*nearest) == graph_.cellOf(state) &&
                                           search_.costOf(state) < search_.costOf(*nearest);
                    if (distance < least || (distance == least && isCheaper))
                    {
                        least = distance;
                        nearest = state;
                    }
                }
            });
        if (!nearest)
            return nullptr;
        const Legs legs = legsOf(search_.pathTo(*nearest));
        return pathThrough(legs.headings.empty() ? parts_->best(parts_->starts, legs.cells.front()) : startOf(legs),
                           legs);
    }

    std::optional<double> lowerBound() const override
    {
        if ((parts_->question.guidance == Guidance::Cheng && rings_ > 1) || !joined_)
            return std::nullopt;
        constexpr double rounding = 1e-8;  // of sums
        return search_.leastKey() * (1.0 - rounding);
    }

    void forEachVertex(const std::function<void(const TreeVertex &)> &visit) const override
    {
        forEachVertexState(
            [&](CellIndex state, std::uint8_t arrivedBy, bool isExpanded)
            {
                const CellIndex cell = graph_.cellOf(state);
                TreeVertex vertex{nameOf(state), centre(cell), 0.0, std::nullopt, nullptr, false, isExpanded};
                if (arrivedBy == AStar<Graph>::noJump)
                {
                    const Joint &joint = parts_->best(parts_->starts, vertex.name.cell);
                    vertex.start = joint.state;
                    vertex.heading = parts_->jointHeading(joint.state, joint.cell, true);
                }
                else
                {
                    CellIndex parent = graph_.predecessor(state, arrivedBy);
                    vertex.heading = courseBetween(centre(graph_.cellOf(parent)), vertex.position);
                    // whoever turned on the spot had come there before
                    if (!isVertex(parent, search_.arrivedBy(parent)))
                        parent = graph_.predecessor(parent, search_.arrivedBy(parent));
                    vertex.parent = nameOf(parent);
                }
                visit(vertex);
            });
    }

    void forEachReachedGoal(const std::function<void(const GoalVertex &)> &visit) const override
    {
        for (const Joint &joint : parts_->goals)
            if (const auto from = cheapestTo(joint))
                visit({nameOf(*from), joint.state, false});
    }

private:
    using Cells = JumpGraph<CourseWeight<Norm>>;
    using Graph = HeadingGraph<Cells>;

    /// The cells of a path, and the jumps between them.
    struct Legs
    {
        std::vector<OffsetCoord> cells;
        std::vector<std::size_t> headings;
    };

    std::size_t noHeading() const { return parts_->jumps.size(); }
    Point centre(CellIndex cell) const { return parts_->question.lattice.centre(parts_->layout.offset(cell)); }
    VertexName nameOf(CellIndex state) const
    {
        return {parts_->layout.offset(graph_.cellOf(state)), graph_.headingOf(state)};
    }

    /// What it costs to finish is known only with a heading: the bound counts on the best.
    std::vector<GoalCell> goalCells() const
    {
        std::vector<GoalCell> cells;
        for (const Joint &goal : parts_->goals)
        {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t heading = 0; heading < noHeading(); ++heading)
                least = std::min(least, weight_.arrivalOf(goal.cell, heading, goal));
            if (weight_.startTo(goal.cell, goal) != nullptr)
                least = std::min(least, weight_.arrivalOf(goal.cell, noHeading(), goal));
            cells.emplace_back(goal.cell, least);
        }
        return cells;
    }

    void addStarts()
    {
        for (const Joint &joint : parts_->starts)
            search_.addStart(graph_.beginning(parts_->layout.index(joint.cell)), 0.0);  // the rest is departure()
    }

    void publish()
    {
        ProgressBoard *board = parts_->question.board;
        if (board == nullptr)
            return;
        board->expanded.store(expandedBefore_ + search_.counters().expanded, std::memory_order_relaxed);
        board->open.store(search_.openSize(), std::memory_order_relaxed);
        if (parts_->question.tellsBound && rings_ == parts_->question.jumps.rings)
            if (const auto bound = lowerBound())
                board->raiseLowerBound(*bound);
    }

    /// States in which a jump ends, or a path begins; not those that only turned there.
    bool isVertex(CellIndex state, std::uint8_t arrivedBy) const
    {
        return arrivedBy == AStar<Graph>::noJump || arrivedBy == graph_.headingOf(state);
    }

    template <class Visit>
    void forEachVertexState(Visit &&visit) const
    {
        search_.forEachReached(
            [&](CellIndex state, std::uint8_t arrivedBy, bool isExpanded)
            {
                if (isVertex(state, arrivedBy))
                    visit(state, arrivedBy, isExpanded);
            });
    }

    /// From which of its cell's states a goal is reached at the least cost; empty if none was reached.
    std::optional<CellIndex> cheapestTo(const Joint &goal) const
    {
        const CellIndex cell = parts_->layout.index(goal.cell);
        const CellIndex beginning = graph_.beginning(cell);
        std::optional<CellIndex> best;
        double least = std::numeric_limits<double>::infinity();
        for (CellIndex state = beginning - static_cast<CellIndex>(noHeading()); state <= beginning; ++state)
            if (search_.isReached(state) && isVertex(state, search_.arrivedBy(state)))
                if (const double cost =
                        search_.costOf(state) + weight_.arrivalOf(goal.cell, graph_.headingOf(state), goal);
                    cost < least)
                {
                    best = state;
                    least = cost;
                }
        return best;
    }

    Legs legsOf(const std::vector<CellIndex> &states) const
    {
        Legs legs{{parts_->layout.offset(graph_.cellOf(states.front()))}, {}};
        for (std::size_t i = 1; i < states.size(); ++i)
            if (graph_.cellOf(states[i]) != graph_.cellOf(states[i - 1]))
            {
                legs.cells.push_back(parts_->layout.offset(graph_.cellOf(states[i])));
                legs.headings.push_back(graph_.headingOf(states[i]));
            }
        return legs;
    }

    const Joint &startOf(const Legs &legs) const
    {
        return *weight_.startFor(legs.cells.front(), legs.headings.front());
    }

    std::shared_ptr<ompl::geometric::PathGeometric> pathThrough(const Joint &start, const Legs &legs) const
    {
        const LatticeQuestion &q = parts_->question;
        auto path = std::make_shared<ompl::geometric::PathGeometric>(q.si, start.state);
        ompl::base::ScopedState<> state(q.si);
        double heading = parts_->jointHeading(start.state, start.cell, true);
        for (std::size_t i = 0; i < legs.cells.size(); ++i)
        {
            const Point at = q.lattice.centre(legs.cells[i]);
            if (i > 0)
                heading = courseBetween(q.lattice.centre(legs.cells[i - 1]), at);
            parts_->embedding.place(state.get(), at, heading);
            path->append(state.get());
        }
        return path;
    }

    std::unique_ptr<QueryParts> parts_;
    CourseWeight<Norm> weight_;
    Graph graph_;
    AStar<Graph> search_;
    int rings_;
    bool joined_ = false;
    std::uint64_t expandedBefore_ = 0;  // by searches before
    std::vector<CellIndex> expandedStates_;
};

}  // namespace seahex
