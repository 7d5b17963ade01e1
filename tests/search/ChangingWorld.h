#pragma once

// Worlds whose cells change, and what a search made after each change says.

#include <seahex/search/LengthSearch.h>
#include <seahex/world/CellBits.h>

#include "search/LengthWorlds.h"

#include <limits>

namespace seahex::test
{

const double infinity = std::numeric_limits<double>::infinity();

/// The least length, in pitches, by a search of its own; infinite if there is no path.
inline double leastLength(const HexOccupancy &occupancy, int rings, HexCoord from, HexCoord to)
{
    if (occupancy.isBlocked(from) || occupancy.isBlocked(to))
        return infinity;
    LengthSearch search(occupancy, rings);
    search.begin(from, to);
    search.run();
    return search.cost();
}

inline void expectLength(double length, double expected)
{
    if (expected == infinity)
        EXPECT_EQ(length, infinity);
    else
        EXPECT_NEAR(length, expected, 1e-8 * (1.0 + expected));
}

/// What is blocked, and changes.
class ChangingWorld
{
public:
    explicit ChangingWorld(const HexOccupancy &occupancy) : lattice_(occupancy.lattice()), bits_(occupancy.layout())
    {
        bits_.words().assign(occupancy.words().begin(), occupancy.words().end());
        occupancy_ = std::make_shared<const HexOccupancy>(occupancy);
    }

    const World &occupancy() const { return occupancy_; }

    /// Blocks or frees all cells within a radius of one, or a random share of them; or some here and some there.
    void change(Random &random)
    {
        const int places = random.chance(0.2) ? 3 : 1;
        for (int i = 0; i < places; ++i)
        {
            const auto radius = random.integer(0, random.chance(0.3) ? 9 : 2);
            const bool isBlocked = random.chance(0.6);
            const double share = random.chance(0.7) ? 1.0 : 0.4;
            const HexCoord middle = random.cellOf(lattice_);
            forEachCell(lattice_, 0,
                        [&](HexCoord cell)
                        {
                            if (hexDistance(cell, middle) <= radius && random.chance(share))
                                set(cell, isBlocked);
                        });
        }
        occupancy_ = std::make_shared<const HexOccupancy>(lattice_, bits_.layout(), bits_.words());
    }

private:
    void set(HexCoord cell, bool isBlocked)
    {
        const CellIndex index = bits_.layout().index(cell);
        const std::uint64_t bit = std::uint64_t{1} << (index & 63);
        isBlocked ? bits_.words()[index >> 6] |= bit : bits_.words()[index >> 6] &= ~bit;
    }

    HexLattice lattice_;
    CellBits bits_;
    World occupancy_;
};

inline World anyWorld(Random &random)
{
    if (random.chance(0.5))
        return randomWorld(random);
    return amongIslands(random, random.integer(20, 130), random.integer(10, 50));
}

}  // namespace seahex::test
