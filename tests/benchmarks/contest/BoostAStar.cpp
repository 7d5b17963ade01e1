#include "contest/BoostAStar.h"

#include <seahex/geometry/HexRing.h>

#include <boost/graph/astar_search.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/iterator_facade.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>

namespace seahex::contest
{
namespace
{

struct GridEdge
{
    CellIndex source = 0;
    CellIndex target = 0;
};

/// The free neighbours of a cell, as edges.
class EdgeIterator : public boost::iterator_facade<EdgeIterator, GridEdge, boost::forward_traversal_tag, GridEdge>
{
public:
    EdgeIterator() = default;
    EdgeIterator(const HexOccupancy *occupancy, const std::array<std::int32_t, 6> *deltas, CellIndex cell,
                 std::size_t next)
        : occupancy_(occupancy), deltas_(deltas), cell_(cell), next_(next)
    {
        skipBlocked();
    }

private:
    friend class boost::iterator_core_access;

    CellIndex neighbour() const { return static_cast<CellIndex>(static_cast<std::int64_t>(cell_) + (*deltas_)[next_]); }
    void skipBlocked()
    {
        while (next_ < 6 && occupancy_->isBlockedAt(neighbour()))
            ++next_;
    }
    GridEdge dereference() const { return {cell_, neighbour()}; }
    bool equal(const EdgeIterator &other) const { return next_ == other.next_; }
    void increment()
    {
        ++next_;
        skipBlocked();
    }

    const HexOccupancy *occupancy_ = nullptr;
    const std::array<std::int32_t, 6> *deltas_ = nullptr;
    CellIndex cell_ = 0;
    std::size_t next_ = 6;
};

/// An occupancy as Boost's IncidenceGraph.
struct Grid
{
    using vertex_descriptor = CellIndex;
    using edge_descriptor = GridEdge;
    using out_edge_iterator = EdgeIterator;
    using directed_category = boost::directed_tag;
    using edge_parallel_category = boost::disallow_parallel_edge_tag;
    using traversal_category = boost::incidence_graph_tag;
    using degree_size_type = std::size_t;
    using vertices_size_type = std::size_t;
    static vertex_descriptor null_vertex() { return std::numeric_limits<CellIndex>::max(); }

    const HexOccupancy *occupancy;
    const std::array<std::array<std::int32_t, 6>, 2> *deltas;
    CellIndex stride;

    const std::array<std::int32_t, 6> *deltasFrom(CellIndex cell) const
    {
        return &(*deltas)[(cell / stride + CellLayout::frame) & 1];
    }
};

bool operator==(const GridEdge &a, const GridEdge &b)
{
    return a.source == b.source && a.target == b.target;
}
bool operator!=(const GridEdge &a, const GridEdge &b)
{
    return !(a == b);
}

// Boost finds these by their arguments.
CellIndex source(const GridEdge &edge, const Grid &)
{
    return edge.source;
}
CellIndex target(const GridEdge &edge, const Grid &)
{
    return edge.target;
}
std::pair<EdgeIterator, EdgeIterator> out_edges(CellIndex cell, const Grid &grid)
{
    const auto *deltas = grid.deltasFrom(cell);
    return {EdgeIterator(grid.occupancy, deltas, cell, 0), EdgeIterator(grid.occupancy, deltas, cell, 6)};
}

std::size_t out_degree(CellIndex cell, const Grid &grid)
{
    const auto edges = out_edges(cell, grid);
    return static_cast<std::size_t>(std::distance(edges.first, edges.second));
}

struct Remaining
{
    const CellLayout &layout;
    HexCoord goal;

    std::int32_t operator()(CellIndex cell) const
    {
        return static_cast<std::int32_t>(hexDistance(layout.cell(cell), goal));
    }
};

struct GoalReached
{
};

struct Visitor : boost::default_astar_visitor
{
    Visitor(CellIndex goalCell, std::uint64_t &expandedCells, std::vector<CellIndex> &touchedCells)
        : goal(goalCell), expanded(&expandedCells), touched(&touchedCells)
    {
    }
    void discover_vertex(CellIndex cell, const Grid &) { touched->push_back(cell); }
    void examine_vertex(CellIndex cell, const Grid &)
    {
        ++*expanded;
        if (cell == goal)
            throw GoalReached();
    }

    CellIndex goal;
    std::uint64_t *expanded;
    std::vector<CellIndex> *touched;
};

constexpr std::int32_t unknown = std::numeric_limits<std::int32_t>::max();

}  // namespace

BoostAStar::BoostAStar(const HexOccupancy &occupancy)
    : occupancy_(occupancy), predecessor_(occupancy.layout().size()), distance_(occupancy.layout().size(), unknown),
      estimate_(occupancy.layout().size(), unknown), colour_(occupancy.layout().size(), boost::white_color)
{
    const CellLayout &layout = occupancy.layout();
    const std::vector<RingOffset> ring = ringOffsets(1);
    for (std::int64_t parity = 0; parity < 2; ++parity)
        for (std::size_t k = 0; k < ring.size(); ++k)
        {
            const OffsetCoord cell{0, parity};
            deltas_[static_cast<std::size_t>(parity)][k] =
                static_cast<std::int32_t>(static_cast<std::int64_t>(layout.index(toCube(cell) + ring[k].offset)) -
                                          static_cast<std::int64_t>(layout.index(cell)));
        }
}

Answer BoostAStar::solve(const Query &query)
{
    const CellLayout &layout = occupancy_.layout();
    const Grid grid{&occupancy_, &deltas_, static_cast<CellIndex>(layout.stride())};
    const CellIndex start = layout.index(query.start);
    const CellIndex goal = layout.index(query.goal);
    const Remaining remaining{layout, query.goal};
    Answer answer;
    const auto map = [](auto &values)
    {
        return boost::make_iterator_property_map(values.begin(), boost::typed_identity_property_map<CellIndex>());
    };
    predecessor_[start] = start;
    distance_[start] = 0;
    estimate_[start] = remaining(start);
    try
    {
        boost::astar_search_no_init(
            grid, start, remaining, Visitor(goal, answer.expanded, touched_), map(predecessor_), map(estimate_),
            map(distance_), boost::static_property_map<std::int32_t, GridEdge>(1), map(colour_),
            boost::typed_identity_property_map<CellIndex>(), std::less<>(), std::plus<>(), unknown, 0);
    }
    catch (const GoalReached &)
    {
        answer.cost = distance_[goal];
    }
    std::vector<CellIndex> path;
    if (distance_[goal] != unknown)
        for (CellIndex cell = goal; cell != start; cell = predecessor_[cell])
            path.push_back(cell);

    answer.touched = touched_.size();
    constexpr std::size_t bytes = sizeof(CellIndex) + 2 * sizeof(std::int32_t) + sizeof(char) + sizeof(std::size_t);
    answer.memory.everywhere = layout.size() * bytes;  // the heap's index counts too
    answer.memory.touched = touched_.capacity() * sizeof(CellIndex);
    for (const CellIndex cell : touched_)
    {
        distance_[cell] = estimate_[cell] = unknown;
        colour_[cell] = boost::white_color;
    }
    touched_.clear();
    return answer;
}

}  // namespace seahex::contest
