#include "support/PrismOracle.h"

#include <cmath>

namespace seahex::test
{

std::size_t PrismOracle::vertexOf(HexCoord cell, int layer) const
{
    return static_cast<std::size_t>(layer * lattice.plane().cellCount()) + test::vertexOf(lattice.plane(), cell);
}

bool PrismOracle::isMotion(const Point3 &from, const Point3 &to) const
{
    const double run = std::hypot(to.x() - from.x(), to.y() - from.y());
    return (climb == 0.0 || std::abs(to.z() - from.z()) <= climb * run * (1.0 + 1e-9)) && isFree(from, to);
}

ExplicitGraph PrismOracle::graph() const
{
    const HexLattice &plane = lattice.plane();
    ExplicitGraph graph(static_cast<std::size_t>(plane.cellCount() * lattice.layers()));
    const auto addMotion = [&](HexCoord from, int fromLayer, HexCoord to, int toLayer)
    {
        if (!plane.contains(to) || toLayer < 0 || toLayer >= lattice.layers() || hexDistance(from, to) > rings)
            return;
        if (from == to && (climb != 0.0 || fromLayer == toLayer))
            return;
        const Point3 a = lattice.node(from, fromLayer);
        const Point3 b = lattice.node(to, toLayer);
        if (isMotion(a, b))
            graph.addEdge(vertexOf(from, fromLayer), vertexOf(to, toLayer), (b - a).norm());
    };
    for (std::int64_t row = 0; row < plane.rows(); ++row)
        for (std::int64_t column = 0; column < plane.columns(); ++column)
            for (int layer = 0; layer < lattice.layers(); ++layer)
                for (std::int64_t q = -rings; q <= rings; ++q)
                    for (std::int64_t s = -rings; s <= rings; ++s)
                        for (int by = -1; by <= 1; ++by)
                        {
                            const HexCoord from = toCube({column, row});
                            addMotion(from, layer, from + HexCoord{q, s}, layer + by);
                        }
    return graph;
}

std::vector<ExplicitGraph::Terminal> PrismOracle::joints(const Point3 &end, int steps, bool isStart) const
{
    std::vector<ExplicitGraph::Terminal> joints;
    const HexCoord own = lattice.plane().cellAt(horizontal(end));
    for (int layer = 0; layer < lattice.layers(); ++layer)
    {
        const double height = lattice.depth(layer) - end.z();
        if (std::abs(height) > lattice.thickness() * (1.0 + 1e-9))
            continue;
        for (std::int64_t row = 0; row < lattice.plane().rows(); ++row)
            for (std::int64_t column = 0; column < lattice.plane().columns(); ++column)
            {
                const HexCoord cell = toCube({column, row});
                const Point3 node = lattice.node(cell, layer);
                if (hexDistance(cell, own) <= steps && (isStart ? isMotion(end, node) : isMotion(node, end)))
                    joints.emplace_back(vertexOf(cell, layer), (node - end).norm());
            }
    }
    return joints;
}

}  // namespace seahex::test
