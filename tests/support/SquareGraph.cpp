#include "support/SquareGraph.h"

#include <cmath>

namespace seahex::test
{

std::size_t vertexOf(const SquareLattice &lattice, OffsetCoord cell)
{
    return static_cast<std::size_t>(cell.row * lattice.columns() + cell.column);
}

ExplicitGraph squareGraph(const SquareOccupancy &occupancy, int neighbours, bool cornerCutting)
{
    const SquareLattice &lattice = occupancy.lattice();
    ExplicitGraph graph(static_cast<std::size_t>(lattice.cellCount()));
    const auto addStep = [&](OffsetCoord from, OffsetCoord to)
    {
        if (from == to || occupancy.isBlocked(from) || occupancy.isBlocked(to))
            return;
        const bool isDiagonal = from.column != to.column && from.row != to.row;
        const bool passesCorner = occupancy.isBlocked(OffsetCoord{from.column, to.row}) ||
                                  occupancy.isBlocked(OffsetCoord{to.column, from.row});
        if (!isDiagonal || (neighbours == 8 && (cornerCutting || !passesCorner)))
            graph.addEdge(vertexOf(lattice, from), vertexOf(lattice, to), isDiagonal ? std::sqrt(2.0) : 1.0);
    };
    for (std::int64_t row = 0; row < lattice.rows(); ++row)
        for (std::int64_t column = 0; column < lattice.columns(); ++column)
            for (std::int64_t i = -1; i <= 1; ++i)
                for (std::int64_t j = -1; j <= 1; ++j)
                    addStep({column, row}, {column + i, row + j});
    return graph;
}

}  // namespace seahex::test
