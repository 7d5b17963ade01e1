#pragma once

#include <seahex/search/AStar.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/LengthWeight.h>
#include <seahex/search/SquareJumps.h>

#include <cstdint>
#include <vector>

namespace seahex::test
{

/// A* on squares for path length, in cells, from one cell to another; any number of times on one graph.
class SquareSearch
{
public:
    using Graph = JumpGraph<SquareLengthWeight>;

    /// @param start, goal  of the guidance's line
    SquareSearch(const SquareOccupancy &occupancy, int neighbours, JumpRule rule, Guidance guidance,
                 OffsetCoord start = {}, OffsetCoord goal = {})
        : layout_(occupancy.layout()), jumps_(layout_, neighbours, rule),
          graph_(occupancy, jumps_, {},
                 SquareLengthWeight(occupancy.lattice(), jumps_, LengthMetric::Euclidean, guidance,
                                    occupancy.lattice().centre(start), occupancy.lattice().centre(goal))),
          search_(graph_)
    {
    }

    SquareSearch(const SquareSearch &) = delete;
    SquareSearch &operator=(const SquareSearch &) = delete;

    /// Least cost; infinity where there is no way.
    double cost(OffsetCoord from, OffsetCoord to)
    {
        search_.reset();
        graph_.setGoals({{to, 0.0}});
        search_.addStart(layout_.index(from), 0.0);
        search_.run([] { return false; }, 1 << 20);
        return search_.cost();
    }

    /// The path of the last cost().
    std::vector<OffsetCoord> path() const
    {
        std::vector<OffsetCoord> cells;
        for (const CellIndex index : search_.path())
            cells.push_back(layout_.offset(index));
        return cells;
    }

private:
    CellLayout layout_;
    SquareJumps jumps_;
    Graph graph_;
    AStar<Graph> search_;
};

}  // namespace seahex::test
