#include "support/ExplicitGraph.h"

#include <seahex/geometry/HexTraversal.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
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

std::size_t vertexOf(const HexLattice &lattice, HexCoord cell)
{
    const OffsetCoord offset = toOffset(cell);
    return static_cast<std::size_t>(offset.row * lattice.columns() + offset.column);
}

ExplicitGraph jumpGraph(const HexOccupancy &occupancy, int rings, LengthMetric metric)
{
    const HexLattice &lattice = occupancy.lattice();
    return jumpGraph(occupancy, rings,
                     [&](HexCoord from, HexCoord to)
                     {
                         if (metric == LengthMetric::Lattice)
                             return static_cast<double>(hexDistance(from, to));
                         return (lattice.centre(to) - lattice.centre(from)).norm() / lattice.pitch();
                     });
}

ExplicitGraph jumpGraph(const HexOccupancy &occupancy, int rings, const std::function<double(HexCoord, HexCoord)> &cost)
{
    const HexLattice &lattice = occupancy.lattice();
    ExplicitGraph graph(static_cast<std::size_t>(lattice.cellCount()));
    const auto addJump = [&](HexCoord from, HexCoord to)
    {
        const std::int64_t steps = hexDistance(from, to);
        if (steps == 0 || steps > rings || !lattice.contains(to))
            return;
        if (!forEachTouchedCell(from, to, [&](HexCoord cell) { return occupancy.isFree(cell); }))
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

}  // namespace seahex::test
