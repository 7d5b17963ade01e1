#include <seahex/route/TurnComparison.h>

#include <seahex/geometry/HexTraversal.h>
#include <seahex/search/HexJumps.h>
#include <seahex/search/SquareJumps.h>
#include <seahex/world/CellBits.h>

#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"
#include "support/Random.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

/// The shortest lengths with up to 0, 1, ... turns, by Dijkstra over cells, steps and turns made.
std::vector<double> shortestByTurns(const HexOccupancy &occupancy, int rings, HexCoord start, HexCoord goal,
                                    std::size_t mostTurns)
{
    const HexLattice &lattice = occupancy.lattice();
    std::vector<HexCoord> steps;
    for (std::int64_t q = -rings; q <= rings; ++q)
        for (std::int64_t s = -rings; s <= rings; ++s)
            if (const std::int64_t d = hexNorm(HexCoord{q, s}); d >= 1 && d <= rings)
                steps.push_back({q, s});
    const std::size_t none = steps.size();
    const auto vertex = [&](HexCoord cell, std::size_t step, std::size_t turns)
    {
        return (vertexOf(lattice, cell) * (none + 1) + step) * (mostTurns + 1) + turns;
    };
    const auto isOneCourse = [&](HexCoord a, HexCoord b)
    {
        return a.q * b.s == a.s * b.q && a.q * b.q >= 0 && a.s * b.s >= 0;
    };
    ExplicitGraph graph(static_cast<std::size_t>(lattice.cellCount()) * (none + 1) * (mostTurns + 1));
    for (std::int64_t i = 0; i < lattice.cellCount(); ++i)
        for (std::size_t k = 0; k < steps.size(); ++k)
        {
            const HexCoord from = toCube({i % lattice.columns(), i / lattice.columns()});
            const HexCoord to = from + steps[k];
            if (!lattice.contains(to) ||
                !forEachTouchedCell(from, to, [&](HexCoord cell) { return occupancy.isFree(cell); }))
                continue;
            const double length = (lattice.centre(to) - lattice.centre(from)).norm() / lattice.pitch();
            for (std::size_t before = 0; before <= none; ++before)
                for (std::size_t turns = 0; turns <= mostTurns; ++turns)
                {
                    const std::size_t after = turns + (before == none || isOneCourse(steps[before], steps[k]) ? 0 : 1);
                    if (after <= mostTurns)
                        graph.addEdge(vertex(from, before, turns), vertex(to, k, after), length);
                }
        }
    const std::vector<double> costs = graph.costsFrom({{vertex(start, none, 0), 0.0}});
    std::vector<double> best;
    for (std::size_t turns = 0; turns <= mostTurns; ++turns)
    {
        best.push_back(best.empty() ? infinity : best.back());
        for (std::size_t k = 0; k <= none; ++k)
            best.back() = std::min(best.back(), costs[vertex(goal, k, turns)]);
    }
    return best;
}

/// Is no chord from a path with more turns to one with fewer below this one?
bool isCorner(const std::vector<double> &lengths, std::size_t turns)
{
    for (std::size_t fewer = 0; fewer < turns; ++fewer)
        for (std::size_t more = turns + 1; more < lengths.size(); ++more)
        {
            const double part = static_cast<double>(turns - fewer) / static_cast<double>(more - fewer);
            if (lengths[fewer] + part * (lengths[more] - lengths[fewer]) < lengths[turns] + 1e-9)
                return false;
        }
    return !std::isinf(lengths[turns]);
}

}  // namespace

TEST(TurnComparison, findsTheCornersOfAllPathsHull)
{
    constexpr std::size_t mostTurns = 12;
    const std::vector<double> allowances = {0.0, 0.05, 0.2, 0.6};
    int compared = 0;
    int saved = 0;
    forEachSeed(
        800,
        [&](Random &random)
        {
            const HexLattice lattice(Point(5.0, 7.0), 2.0, random.integer(2, 10), random.integer(2, 10));
            const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.45));
            const HexCoord start = random.cellOf(lattice);
            const HexCoord goal = random.cellOf(lattice);
            const auto rings = static_cast<int>(random.integer(1, 2));
            if (occupancy->isBlocked(start) || occupancy->isBlocked(goal) || start == goal)
                return;
            const HexJumps jumps(occupancy->layout(), rings, random.chance(0.5) ? JumpSet::All : JumpSet::Primitive);
            const auto comparison = compareTurns(*occupancy, jumps, toOffset(start), toOffset(goal), allowances);
            const std::vector<double> lengths = shortestByTurns(*occupancy, rings, start, goal, mostTurns);
            if (!comparison)
            {
                EXPECT_TRUE(std::isinf(lengths.back()));
                return;
            }
            ++compared;
            ASSERT_NEAR(comparison->plain.lengthCells, lengths.back(), 1e-9) << "no shortest path turns so often";
            for (std::size_t i = 0; i < allowances.size(); ++i)
            {
                const MeasuredPath &path = comparison->fewest[i];
                const double longest = lengths.back() * (1.0 + allowances[i]) + 1e-6;
                const auto turns = static_cast<std::size_t>(path.turns);
                ASSERT_NEAR(path.lengthCells, lengths[turns], 1e-9) << "as short as any with so many turns";
                EXPECT_LE(path.lengthCells, longest + 1e-6);
                EXPECT_LE(path.turns, comparison->plain.turns);
                for (std::size_t fewer = 0; fewer < turns; ++fewer)
                    EXPECT_FALSE(lengths[fewer] < longest - 1e-5 && isCorner(lengths, fewer))
                        << "a corner with " << fewer << " turns of length " << lengths[fewer] << " was missed, instead "
                        << turns << " of " << path.lengthCells << toPicture(*occupancy);
                saved += path.turns < comparison->plain.turns ? 1 : 0;
            }
        });
    EXPECT_GE(compared, 400);
    EXPECT_GE(saved, 100);
}

TEST(TurnComparison, onSquaresToo)
{
    const SquareLattice lattice(Point(0, 0), 1.0, 9, 9);
    const CellLayout layout(9, 9);
    CellBits bits(layout);
    bits.setOutside();
    bits.setSpan(4, 2, 6);  // a wall across the straight way
    const SquareOccupancy occupancy(lattice, layout, bits.words());
    const SquareJumps jumps(layout, 4);
    const auto comparison = compareTurns(occupancy, jumps, {3, 0}, {3, 8}, {0.0, 0.5});
    ASSERT_TRUE(comparison);
    EXPECT_EQ(comparison->plain.lengthCells, 12.0);
    EXPECT_EQ(comparison->fewest[0].lengthCells, 12.0);
    EXPECT_EQ(comparison->fewest[0].turns, 2) << "west, south, east";
    EXPECT_GT(comparison->fewest[0].expanded, 0u);
}
