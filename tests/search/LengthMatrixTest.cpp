// LengthMatrix against searches one by one.

#include <seahex/search/LengthMatrix.h>

#include "search/BatchQueries.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

TEST(LengthMatrix, HoldsTheLengthsOfSingleQueries)
{
    forEachSeed(25,
                [](Random &random)
                {
                    const World world = random.chance(0.5) ? randomWorld(random) : amongIslands(random, 90, 60);
                    const int rings = static_cast<int>(random.integer(1, 3));
                    std::vector<HexCoord> starts;
                    std::vector<HexCoord> goals;
                    for (std::int64_t i = random.integer(0, 8); i > 0; --i)
                        starts.push_back(anyCell(random, world->lattice()));
                    for (std::int64_t i = random.integer(0, 8); i > 0; --i)
                        goals.push_back(anyCell(random, world->lattice()));
                    BatchControl control = withThreads(static_cast<unsigned int>(random.integer(1, 4)));
                    std::size_t trees = 0;
                    control.progress = [&trees](std::size_t done)
                    {
                        trees = done;
                    };
                    const LengthMatrix matrix = lengthMatrix(*world, rings, starts, goals, control);
                    EXPECT_EQ(trees, std::min(starts.size(), goals.size()));
                    ASSERT_EQ(matrix.goals(), goals.size());
                    ASSERT_EQ(matrix.starts(), starts.size());
                    for (std::size_t i = 0; i < starts.size(); ++i)
                        for (std::size_t j = 0; j < goals.size(); ++j)
                        {
                            const double expected = alone(*world, rings, {starts[i], goals[j]}).length;
                            if (std::isinf(expected))
                                EXPECT_EQ(matrix(i, j), expected);
                            else
                                EXPECT_NEAR(matrix(i, j), expected, 1e-8 * (1.0 + expected));
                        }
                });
}

TEST(LengthMatrix, TellsWhatItDoesNotKnowWhenStopped)
{
    Random random(6);
    const World world = amongIslands(random, 90, 60);
    std::vector<HexCoord> cells;
    for (int i = 0; i < 10; ++i)
        cells.push_back(freeCell(random, *world));
    BatchControl control = withThreads(2);
    std::atomic<std::size_t> done{0};
    control.progress = [&done](std::size_t count)
    {
        done = count;
    };
    control.stop = [&done]
    {
        return done >= 4;
    };
    const LengthMatrix matrix = lengthMatrix(*world, 3, cells, cells, control);
    int unknown = 0;
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t j = 0; j < cells.size(); ++j)
            if (std::isnan(matrix(i, j)))
                ++unknown;
            else
                EXPECT_NEAR(matrix(i, j), alone(*world, 3, {cells[i], cells[j]}).length, 1e-6);
    EXPECT_GE(unknown, 40);
    EXPECT_LE(unknown, 60);
}
