// TurnSearchTest on squares: the steps written out with the rule that a diagonal one needs both cells beside it.

#include <seahex/search/AStar.h>
#include <seahex/search/HeadingGraph.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/SquareJumps.h>
#include <seahex/search/TurnWeight.h>
#include <seahex/world/CellBits.h>

#include "search/RandomTurnCosts.h"
#include "support/ExplicitGraph.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

using SquareWorld = std::vector<bool>;  // of a rectangle, row by row: is the cell free?

double cheapestOnSquares(const SquareWorld &free, std::int64_t columns, int neighbours, const TurnCosts &turns,
                         std::size_t start, std::size_t goal)
{
    const std::int64_t rows = static_cast<std::int64_t>(free.size()) / columns;
    const std::array<std::array<std::int64_t, 2>, 8> steps = {
        {{1, 0}, {0, -1}, {-1, 0}, {0, 1}, {1, -1}, {-1, -1}, {-1, 1}, {1, 1}}};
    const auto count = static_cast<std::size_t>(neighbours);
    const auto isFree = [&](std::int64_t column, std::int64_t row)
    {
        return column >= 0 && column < columns && row >= 0 && row < rows &&
               free[static_cast<std::size_t>(row * columns + column)];
    };
    ExplicitGraph graph(free.size() * (count + 1));
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t column = 0; column < columns; ++column)
            for (std::size_t k = 0; k < count; ++k)
            {
                const auto [right, down] = steps[k];
                if (!isFree(column, row) || !isFree(column + right, row + down) || !isFree(column + right, row) ||
                    !isFree(column, row + down))
                    continue;
                for (std::size_t before = 0; before <= count; ++before)
                {
                    double cost = std::hypot(static_cast<double>(right), static_cast<double>(down));
                    if (before < count && before != k)
                    {
                        const auto [r, d] = steps[before];
                        const auto dot = static_cast<double>(right * r + down * d);
                        cost += turns.perTurn + turns.perRadian * std::acos(dot / (cost * std::hypot(r, d)));
                    }
                    graph.addEdge(static_cast<std::size_t>(row * columns + column) * (count + 1) + before,
                                  static_cast<std::size_t>((row + down) * columns + column + right) * (count + 1) + k,
                                  cost);
                }
            }
    std::vector<ExplicitGraph::Terminal> goals;
    for (std::size_t k = 0; k <= count; ++k)
        goals.emplace_back(goal * (count + 1) + k, 0.0);
    return graph.cheapest({{start * (count + 1) + count, 0.0}}, goals);
}

}  // namespace

TEST(TurnSearchOnSquares, costsEqualDijkstrasOverCellsAndSteps)
{
    int reached = 0;
    int unreachable = 0;
    forEachSeed(400,
                [&](Random &random)
                {
                    const SquareLattice lattice(Point(5.0, 7.0), 2.0, random.integer(1, 9), random.integer(1, 9));
                    const double density = random.real(0.0, 0.4);
                    const CellLayout layout(lattice.columns(), lattice.rows());
                    CellBits bits(layout);
                    bits.setOutside();
                    SquareWorld free;
                    for (std::int64_t i = 0; i < lattice.cellCount(); ++i)
                    {
                        free.push_back(!random.chance(density));
                        if (!free.back())
                            bits.setSpan(i / lattice.columns(), i % lattice.columns(), i % lattice.columns());
                    }
                    const SquareOccupancy occupancy(lattice, layout, bits.words());
                    const std::int64_t start = random.integer(0, lattice.cellCount() - 1);
                    const std::int64_t goal = random.integer(0, lattice.cellCount() - 1);
                    if (!free[static_cast<std::size_t>(start)] || !free[static_cast<std::size_t>(goal)])
                        return;
                    const auto cellOf = [&](std::int64_t i)
                    {
                        return OffsetCoord{i % lattice.columns(), i / lattice.columns()};
                    };
                    const int neighbours = random.chance(0.5) ? 4 : 8;
                    const TurnCosts turns = randomTurnCosts(random);
                    const SquareJumps jumps(layout, neighbours);
                    using Cells = JumpGraph<SquareTurnWeight>;
                    using Graph = HeadingGraph<Cells>;
                    Graph graph(Cells(occupancy, jumps, {{cellOf(goal), 0.0}},
                                      SquareTurnWeight(lattice, jumps, LengthMetric::Euclidean, turns,
                                                       random.chance(0.3) ? Guidance::None : Guidance::Distance,
                                                       lattice.centre(cellOf(start)), lattice.centre(cellOf(goal)))));
                    AStar<Graph> search(graph);
                    search.addStart(graph.beginning(layout.index(cellOf(start))), 0.0);
                    search.run([] { return false; }, 1000);
                    const double expected =
                        cheapestOnSquares(free, lattice.columns(), neighbours, turns, static_cast<std::size_t>(start),
                                          static_cast<std::size_t>(goal));
                    (std::isinf(expected) ? unreachable : reached) += 1;
                    if (std::isinf(expected))
                        EXPECT_FALSE(search.hasPath());
                    else
                        EXPECT_NEAR(search.cost(), expected, 1e-9) << neighbours << " neighbours";
                });
    EXPECT_GE(reached, 150);
    EXPECT_GE(unreachable, 10);
}
