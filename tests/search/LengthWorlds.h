#pragma once

// Worlds that searches by length are tried on, and what their paths must be.

#include <seahex/geometry/HexTraversal.h>
#include <seahex/world/Occupancy.h>

#include "support/AsciiWorld.h"
#include "support/CellOracle.h"
#include "support/Random.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

namespace seahex::test
{

using World = std::shared_ptr<const HexOccupancy>;

/// Is this a chain of valid jumps between the two, of this length in pitches?
inline void expectChain(const std::vector<CellIndex> &path, double cost, const HexOccupancy &occupancy, int rings,
                        HexCoord start, HexCoord goal)
{
    ASSERT_FALSE(path.empty());
    EXPECT_EQ(occupancy.layout().cell(path.front()), start);
    EXPECT_EQ(occupancy.layout().cell(path.back()), goal);
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
        const HexCoord from = occupancy.layout().cell(path[i - 1]);
        const HexCoord to = occupancy.layout().cell(path[i]);
        EXPECT_LE(hexDistance(from, to), rings);
        forEachTouchedCell(from, to,
                           [&](HexCoord cell)
                           {
                               EXPECT_TRUE(occupancy.isFree(cell));
                               return true;
                           });
        length += (occupancy.lattice().centre(to) - occupancy.lattice().centre(from)).norm();
    }
    EXPECT_NEAR(length, cost * occupancy.lattice().pitch(), 1e-9 * (1.0 + length));
}

/// Worlds of any density: mazes, dense noise, open water.
inline World randomWorld(Random &random)
{
    const HexLattice lattice(Point(5.0, 7.0), 2.0, random.integer(1, 60), random.integer(1, 24));
    return randomOccupancy(random, lattice, random.chance(0.3) ? 0.05 : random.real(0.0, 0.5));
}

/// Round islands in open water.
inline World amongIslands(Random &random, std::int64_t columns, std::int64_t rows)
{
    const HexLattice lattice(Point::Zero(), 1.0, columns, rows);
    std::vector<HexCoord> islands;
    for (int i = 0; i < 12; ++i)
    {
        const Point middle = lattice.centre(random.cellOf(lattice));
        const double radius = random.real(1.0, 0.12 * static_cast<double>(columns));
        forEachCell(lattice, 0,
                    [&](HexCoord cell)
                    {
                        if ((lattice.centre(cell) - middle).norm() < radius)
                            islands.push_back(cell);
                    });
    }
    return occupancyWith(lattice, islands);
}

inline HexCoord freeCell(Random &random, const HexOccupancy &occupancy)
{
    for (int tries = 0; tries < 1000; ++tries)
        if (const HexCoord cell = random.cellOf(occupancy.lattice()); occupancy.isFree(cell))
            return cell;
    return {0, 0};
}

}  // namespace seahex::test
