#pragma once

#include <seahex/search/LengthWeight.h>
#include <seahex/world/Occupancy.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace seahex::test
{

/// A directed graph written out edge by edge, with Boost.Graph's Dijkstra: what searches are compared with.
class ExplicitGraph
{
public:
    /// A vertex and the cost of entering the graph, or leaving it, there.
    using Terminal = std::pair<std::size_t, double>;

    explicit ExplicitGraph(std::size_t vertices) : vertices_(vertices) {}

    void addEdge(std::size_t from, std::size_t to, double cost)
    {
        edges_.emplace_back(from, to);
        costs_.push_back(cost);
    }

    /// Least cost from any of the starts, the cost of entering included, to each vertex; infinity where there is no
    /// way.
    std::vector<double> costsFrom(const std::vector<Terminal> &starts) const;

    /// Least cost from any start to any goal, entering and leaving included; infinity if there is no way.
    double cheapest(const std::vector<Terminal> &starts, const std::vector<Terminal> &goals) const;

private:
    std::size_t vertices_;
    std::vector<std::pair<std::size_t, std::size_t>> edges_;
    std::vector<double> costs_;
};

/// Vertex number of a cell of the rectangle in the graphs below.
std::size_t vertexOf(const Lattice &lattice, OffsetCoord cell);
inline std::size_t vertexOf(const HexLattice &lattice, HexCoord cell)
{
    return vertexOf(lattice, toOffset(cell));
}

/// All jumps of up to `rings` steps between free hexagons whose straight segment touches free cells only, collinear
/// repetitions included; where hopping is the rule, whatever lies between. Costs in cells: Euclidean length from centre
/// to centre, or steps between neighbours. It knows nothing of HexRing and HexJumps.
ExplicitGraph jumpGraph(const HexOccupancy &occupancy, int rings, LengthMetric metric, JumpRule rule = JumpRule::Safe);

/// The same jumps at a cost of one's own.
ExplicitGraph jumpGraph(const HexOccupancy &occupancy, int rings,
                        const std::function<double(HexCoord from, HexCoord to)> &cost, JumpRule rule = JumpRule::Safe);

/// All steps between free squares that share an edge and, of 8 neighbours, between those that share a corner only, if
/// the two others at that corner are free as well; where hopping is the rule, whatever these are.
ExplicitGraph stepGraph(const SquareOccupancy &occupancy, int neighbours, JumpRule rule,
                        const std::function<double(OffsetCoord from, OffsetCoord to)> &cost);

/// The same at their Euclidean length in cells.
ExplicitGraph stepGraph(const SquareOccupancy &occupancy, int neighbours, JumpRule rule = JumpRule::Safe);

}  // namespace seahex::test
