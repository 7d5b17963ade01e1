// Batches over threads against searches one by one.

#include <seahex/search/ShortestPaths.h>

#include "search/BatchQueries.h"

#include <atomic>
#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

std::vector<CellQuery> anyQueries(Random &random, const HexLattice &lattice, std::int64_t count)
{
    std::vector<CellQuery> queries;
    for (std::int64_t i = 0; i < count; ++i)
    {
        const HexCoord start = anyCell(random, lattice);
        queries.push_back({start, anyCell(random, lattice)});
    }
    return queries;
}

}  // namespace

TEST(ShortestPaths, AreThoseOfSearchesOneByOneForAnyNumberOfThreads)
{
    forEachSeed(12,
                [](Random &random)
                {
                    const World world = random.chance(0.5) ? randomWorld(random) : amongIslands(random, 90, 60);
                    const int rings = static_cast<int>(random.integer(1, 3));
                    const std::vector<CellQuery> queries = anyQueries(random, world->lattice(), random.integer(0, 60));
                    for (const unsigned int threads : {0U, 1U, 2U, 5U})
                    {
                        const auto answers = shortestPaths(*world, rings, queries, withThreads(threads));
                        ASSERT_EQ(answers.size(), queries.size());
                        for (std::size_t k = 0; k < queries.size(); ++k)
                        {
                            const ShortestPath expected = alone(*world, rings, queries[k]);
                            EXPECT_EQ(answers[k].status, expected.status);
                            EXPECT_EQ(answers[k].length, expected.length);
                            EXPECT_EQ(answers[k].cells, expected.cells);
                        }
                    }
                });
}

TEST(ShortestPaths, TellHowManyAreDoneOneByOne)
{
    Random random(3);
    const World world = amongIslands(random, 60, 50);
    const std::vector<CellQuery> queries = anyQueries(random, world->lattice(), 100);
    BatchControl control = withThreads(4);
    std::vector<std::size_t> told;
    control.progress = [&told](std::size_t done)
    {
        told.push_back(done);
    };
    shortestPaths(*world, 3, queries, control);
    ASSERT_EQ(told.size(), queries.size());
    for (std::size_t i = 0; i < told.size(); ++i)
        EXPECT_EQ(told[i], i + 1);
}

TEST(ShortestPaths, StopWhenTold)
{
    Random random(3);
    const World world = amongIslands(random, 60, 50);
    const std::vector<CellQuery> queries = anyQueries(random, world->lattice(), 200);
    BatchControl control = withThreads(3);
    std::atomic<std::size_t> done{0};
    control.progress = [&done](std::size_t count)
    {
        done = count;
    };
    control.stop = [&done]
    {
        return done >= 20;
    };
    const std::vector<ShortestPath> answers = shortestPaths(*world, 3, queries, control);
    std::size_t answered = 0;
    for (std::size_t k = 0; k < queries.size(); ++k)
    {
        if (answers[k].status == SearchStatus::Stopped)
        {
            EXPECT_TRUE(answers[k].cells.empty());
            EXPECT_TRUE(std::isinf(answers[k].length));
            continue;
        }
        ++answered;
        EXPECT_EQ(answers[k].length, alone(*world, 3, queries[k]).length);
    }
    EXPECT_GE(answered, 20U);
    EXPECT_LE(answered, 20U + 3U);  // those under way
}

TEST(ShortestPaths, StopWithinASearch)
{
    Random random(3);
    const World world = amongIslands(random, 60, 50);
    const HexCoord start = freeCell(random, *world);
    BatchControl control = withThreads(1);
    int asked = 0;
    control.stop = [&asked]
    {
        return ++asked > 1;
    };  // before the query not yet
    EXPECT_EQ(shortestPaths(*world, 3, {{start, start}}, control)[0].status, SearchStatus::Stopped);
}

TEST(ShortestPaths, HandOnWhatTheirFunctionsThrow)
{
    Random random(3);
    const World world = amongIslands(random, 60, 50);
    const std::vector<CellQuery> queries = anyQueries(random, world->lattice(), 50);
    for (const unsigned int threads : {1U, 4U})
    {
        BatchControl control = withThreads(threads);
        control.progress = [](std::size_t done)
        {
            if (done == 10)
                throw std::runtime_error("enough");
        };
        EXPECT_THROW(shortestPaths(*world, 3, queries, control), std::runtime_error);
    }
}
