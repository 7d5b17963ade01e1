#pragma once

#include <seahex/geometry/CellLayout.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace seahex
{

/// Do the states of a HeadingGraph of so many cells have 32-bit numbers?
inline bool headingsFit(std::size_t cells, std::size_t jumps)
{
    return cells <= std::numeric_limits<CellIndex>::max() / (jumps + 1);
}

/// The states of a turn-aware search as AStar wants them: a cell and the heading in which the vessel lies at its
/// centre, where a heading is that of a jump, or none yet where a path begins. State numbers are
/// cell * (jumps + 1) + heading.
///
/// A plain search keeps one way to reach a cell, the cheapest; the next jump's turn depends on which it was, so the
/// cheapest way to go on may be lost. Here nothing is lost, and the path found is the cheapest of all, turns included.
///
/// Three moves: a path begins by taking any heading; a vessel that has just arrived may turn on the spot; any vessel
/// may advance by the jump of its heading. So a jump's validity is asked once a cell, not once for each way to have
/// come there, and a turn that leads nowhere is never expanded. It is the same as paying turn and jump together, as
/// long as no turn is cheaper in two parts: turn costs must obey the triangle inequality.
///
/// `Graph` is a graph of cells (JumpGraph) whose weight says what moves cost (see TurnWeight):
///
///     double departure(CellIndex cell, std::size_t heading) const    a path begins
///     double turn(std::size_t from, std::size_t to) const
///     double advance(std::size_t jump) const
///     double arrival(CellIndex cell, std::size_t heading, const GoalCell &) const    a path ends
///     Approach approach(cell, const GoalCell &) const    what the next function needs to know, whatever the heading
///     double boundFrom(const Approach &, std::size_t heading) const    never more than what remains
///
/// A state's search takes 9 bytes where it was touched, as any cell's.
template <class Graph>
class HeadingGraph
{
public:
    /// @param graph  with all its jumps in use
    /// @throws std::length_error unless headingsFit()
    explicit HeadingGraph(Graph graph)
        : graph_(std::move(graph)), none_(static_cast<CellIndex>(graph_.jumpCount())), ways_(none_ + 1)
    {
        if (!headingsFit(graph_.size(), none_))
            throw std::length_error("too many cells for a search that knows headings: " +
                                    std::to_string(graph_.size()) + " with " + std::to_string(none_) + " jumps each");
    }

    /// As the graph's; a search that has begun must be reset.
    void useRings(int rings)
    {
        graph_.useRings(rings);
        looksAt_.reset();
    }
    template <class Goals>
    void setGoals(Goals goals)
    {
        graph_.setGoals(std::move(goals));
        looksAt_.reset();
    }
    const Graph &cells() const { return graph_; }

    /// The state of a cell where a path begins.
    CellIndex beginning(CellIndex cell) const { return cell * ways_ + none_; }
    CellIndex cellOf(CellIndex state) const { return state / ways_; }
    /// The heading's jump; how many jumps there are where there is none.
    std::size_t headingOf(CellIndex state) const { return state % ways_; }

    std::size_t size() const { return graph_.size() * ways_; }

    template <class Relax>
    bool expand(CellIndex state, std::uint8_t arrivedBy, Relax &&relax)
    {
        const CellIndex cell = cellOf(state);
        const CellIndex heading = state - cell * ways_;
        const auto name = static_cast<std::uint8_t>(heading);  // a move is named by the heading before it
        if (heading == none_)
        {
            for (CellIndex k = 0; k < graph_.jumpCount(); ++k)
                relax(cell * ways_ + k, name, graph_.departure(cell, k));
            return true;
        }
        if (graph_.isValid(cell, heading))
            relax(graph_.successor(cell, heading) * ways_ + heading, name, graph_.advance(heading));
        if (arrivedBy == name)
            for (CellIndex k = 0; k < graph_.jumpCount(); ++k)
                if (k != heading)
                    relax(cell * ways_ + k, name, graph_.turn(heading, k));
        return true;
    }

    CellIndex predecessor(CellIndex state, std::uint8_t move) const
    {
        const CellIndex cell = cellOf(state);
        const bool hasAdvanced = move == state - cell * ways_;
        return (hasAdvanced ? graph_.predecessor(cell, move) : cell) * ways_ + move;
    }

    double bound(CellIndex state) const
    {
        const CellIndex cell = cellOf(state);
        look(cell);
        double best = worst();
        for (const Approach &approach : approaches_)
        {
            const double bound = graph_.boundFrom(approach, state - cell * ways_);
            if (better(bound, best))
                best = bound;
        }
        return best;
    }

    static bool sharpen(std::uint64_t) { return false; }
    double tie(CellIndex state, double bound) const { return graph_.tie(cellOf(state), bound); }

    double finish(CellIndex state) const
    {
        const CellIndex cell = cellOf(state);
        double best = worst();
        for (std::size_t i = 0; i < graph_.goals().size(); ++i)
            if (graph_.goalIndex(i) == cell)
            {
                const double finish = graph_.arrival(cell, state - cell * ways_, graph_.goals()[i]);
                if (better(finish, best))
                    best = finish;
            }
        return best;
    }

    double combine(double a, double b) const { return graph_.combine(a, b); }
    bool better(double a, double b) const { return graph_.better(a, b); }
    double worst() const { return graph_.worst(); }
    bool improves(double cost, double known) const { return graph_.improves(cost, known); }
    double key(double estimate) const { return graph_.key(estimate); }

private:
    using Approach = typename Graph::Approach;

    /// The bounds of one cell's states are asked for in a row.
    void look(CellIndex cell) const
    {
        if (looksAt_ == cell)
            return;
        looksAt_ = cell;
        approaches_.clear();
        for (const auto &goal : graph_.goals())
            approaches_.push_back(graph_.approach(graph_.layout().offset(cell), goal));
    }

    Graph graph_;
    CellIndex none_;
    CellIndex ways_;  // states of a cell
    mutable std::optional<CellIndex> looksAt_;
    mutable std::vector<Approach> approaches_;  // to the goals from there
};

}  // namespace seahex
