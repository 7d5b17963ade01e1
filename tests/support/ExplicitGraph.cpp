#include "support/ExplicitGraph.h"

#include <seahex/geometry/HexTraversal.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace seahex::test
{

std::vector<double> ExplicitGraph::costsFrom(const std::vector<Terminal> &starts) const
{
    using Graph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, boost::no_property,
                                        boost::property<boost::edge_weight_t, double>>;
    // one more vertex from which all starts are entered
    Graph graph(edges_.begin(), edges_.end(), costs_.begin(), vertices_ + 1);
    for (const auto &[vertex, cost] : starts)
        boost::add_edge(vertices_, vertex, cost, graph);
    std::vector<double> costs(vertices_ + 1);
    boost::dijkstra_shortest_paths(
        graph, vertices_, boost::distance_map(costs.data()).distance_inf(std::numeric_limits<double>::infinity()));
    costs.pop_back();
    return costs;
}

double ExplicitGraph::cheapest(const std::vector<Terminal> &starts, const std::vector<Terminal> &goals) const
{
    const std::vector<double> costs = costsFrom(starts);
    double best = std::numeric_limits<double>::infinity();
    for (const auto &[vertex, cost] : goals)
        best = std::min(best, costs[vertex] + cost);
    return best;
}

std::size_t vertexOf(const Lattice &lattice, OffsetCoord cell)
{
    return static_cast<std::size_t>(cell.row * lattice.columns() + cell.column);
}

ExplicitGraph jumpGraph(const HexOccupancy &occupancy, int rings, LengthMetric metric, JumpRule rule)
{
    const HexLattice &lattice = occupancy.lattice();
    const auto cost = [&](HexCoord from, HexCoord to)
    {
        if (metric == LengthMetric::Lattice)
            return static_cast<double>(hexDistance(from, to));
        return (lattice.centre(to) - lattice.centre(from)).norm() / lattice.pitch();
    };
    return jumpGraph(occupancy, rings, cost, rule);
}

ExplicitGraph jumpGraph(const HexOccupancy &occupancy, int rings, const std::function<double(HexCoord, HexCoord)> &cost,
                        JumpRule rule)
{
    const HexLattice &lattice = occupancy.lattice();
    ExplicitGraph graph(static_cast<std::size_t>(lattice.cellCount()));
    const auto addJump = [&](HexCoord from, HexCoord to)
    {
        const std::int64_t steps = hexDistance(from, to);
        if (steps == 0 || steps > rings || !lattice.contains(to))
            return;
        const bool isValid = rule == JumpRule::Hopping
                                 ? occupancy.isFree(from) && occupancy.isFree(to)
                                 : forEachTouchedCell(from, to, [&](HexCoord cell) { return occupancy.isFree(cell); });
        if (!isValid)
            return;
        graph.addEdge(vertexOf(lattice, from), vertexOf(lattice, to), cost(from, to));
    };
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
            for (std::int64_t q = -rings; q <= rings; ++q)
                for (std::int64_t s = -rings; s <= rings; ++s)
                    addJump(toCube({column, row}), toCube({column, row}) + HexCoord{q, s});
    return graph;
}

ExplicitGraph stepGraph(const SquareOccupancy &occupancy, int neighbours, JumpRule rule,
                        const std::function<double(OffsetCoord, OffsetCoord)> &cost)
{
    const SquareLattice &lattice = occupancy.lattice();
    ExplicitGraph graph(static_cast<std::size_t>(lattice.cellCount()));
    const auto isStep = [&](OffsetCoord from, OffsetCoord to)
    {
        if (occupancy.isBlocked(from) || occupancy.isBlocked(to))
            return false;
        if (from.column == to.column || from.row == to.row)
            return from != to;
        if (neighbours == 4)
            return false;
        return rule == JumpRule::Hopping ||
               (occupancy.isFree({from.column, to.row}) && occupancy.isFree({to.column, from.row}));
    };
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
            for (std::int64_t south = -1; south <= 1; ++south)
                for (std::int64_t east = -1; east <= 1; ++east)
                {
                    const OffsetCoord from{column, row};
                    const OffsetCoord to{column + east, row + south};
                    if (isStep(from, to))
                        graph.addEdge(vertexOf(lattice, from), vertexOf(lattice, to), cost(from, to));
                }
    return graph;
}

ExplicitGraph stepGraph(const SquareOccupancy &occupancy, int neighbours, JumpRule rule)
{
    return stepGraph(
        occupancy, neighbours, rule,
        [](OffsetCoord from, OffsetCoord to)
        { return std::hypot(static_cast<double>(to.column - from.column), static_cast<double>(to.row - from.row)); });
}

}  // namespace seahex::test
