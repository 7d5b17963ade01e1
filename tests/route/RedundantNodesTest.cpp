#include "seahex/route/RedundantNodes.h"

#include "support/Random.h"

#include <seahex/world/SegmentValidity.h>

#include <gtest/gtest.h>

#include <set>
#include <utility>
#include <vector>

namespace seahex
{
namespace
{

using test::Random;
using Pairs = std::set<std::pair<int, int>>;

/// Nodes that carry their numbers in x, so that a predicate can be a table.
Route numberedNodes(int count)
{
    std::vector<Point> nodes;
    for (int i = 0; i < count; ++i)
        nodes.emplace_back(i, i * i % 3);
    return Route(nodes);
}

int numberOf(const Point &node)
{
    return static_cast<int>(node.x());
}

std::vector<int> numbersOf(const Route &route)
{
    std::vector<int> numbers;
    for (const Point &node : route.waypoints())
        numbers.push_back(numberOf(node));
    return numbers;
}

/// dropRedundantNodes() where these pairs of nodes see each other.
std::vector<int> keptOf(int count, const Pairs &seen)
{
    return numbersOf(dropRedundantNodes(numberedNodes(count),
                                        [&seen](const Point &a, const Point &b) {
                                            return seen.count({numberOf(a), numberOf(b)}) > 0;
                                        }));
}

/// [Wang2017]'s words, one after the other, on a list that nodes are taken out of.
std::vector<int> byTheText(int count, const Pairs &seen)
{
    std::vector<int> nodes;
    for (int i = 0; i < count; ++i)
        nodes.push_back(i);
    for (std::size_t i = 0; i + 2 < nodes.size(); ++i)
        while (i + 2 < nodes.size() && seen.count({nodes[i], nodes[i + 2]}) > 0)
            nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    return nodes;
}

TEST(RedundantNodes, keepsShortRoutes)
{
    const auto always = [](const Point &, const Point &)
    {
        return true;
    };
    EXPECT_TRUE(dropRedundantNodes(Route(), always).empty());
    EXPECT_EQ(dropRedundantNodes(numberedNodes(1), always).waypoints().size(), 1u);
    EXPECT_EQ(dropRedundantNodes(numberedNodes(2), always).waypoints().size(), 2u);
    EXPECT_EQ(numbersOf(dropRedundantNodes(numberedNodes(9), always)), (std::vector<int>{0, 8}));
}

TEST(RedundantNodes, goesOnFromTheLastNodeThatStays)
{
    // 0 sees up to 3, which sees up to 5
    EXPECT_EQ(keptOf(7, {{0, 2}, {0, 3}, {3, 5}}), (std::vector<int>{0, 3, 5, 6}));
    // what lies behind an obstacle is not looked for, though it could be seen
    EXPECT_EQ(keptOf(5, {{0, 3}, {0, 4}, {1, 4}}), (std::vector<int>{0, 1, 2, 3, 4}));
    EXPECT_EQ(keptOf(6, {}), (std::vector<int>{0, 1, 2, 3, 4, 5}));
}

TEST(RedundantNodes, doesWhatTheTextSaysInEveryWorldOfSixNodes)
{
    for (int count = 3; count <= 6; ++count)
    {
        std::vector<std::pair<int, int>> pairs;
        for (int i = 0; i < count; ++i)
            for (int j = i + 2; j < count; ++j)
                pairs.emplace_back(i, j);
        for (unsigned world = 0; world < 1u << pairs.size(); ++world)
        {
            Pairs seen;
            for (std::size_t i = 0; i < pairs.size(); ++i)
                if ((world >> i & 1u) != 0)
                    seen.insert(pairs[i]);
            ASSERT_EQ(keptOf(count, seen), byTheText(count, seen)) << count << " nodes, world " << world;
        }
    }
}

TEST(RedundantNodes, asksOnceForEachInnerNode)
{
    for (const bool seen : {false, true})
    {
        int asked = 0;
        dropRedundantNodes(numberedNodes(9),
                           [&](const Point &, const Point &)
                           {
                               ++asked;
                               return seen;
                           });
        EXPECT_EQ(asked, 7);
    }
}

TEST(RedundantNodes, keepsNodesOfTheInputAndValidLegsAmongRealCells)
{
    int routes = 0;
    int dropped = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice(random.pointIn({Point(-1e4, -1e4), Point(1e4, 1e4)}), random.real(0.5, 60.0), 20, 20);
        const auto occupancy = randomOccupancy(random, lattice, 0.1);
        const auto isValid = [&occupancy](const Point &a, const Point &b)
        {
            return isFree(*occupancy, a, b);
        };
        // any walk over free cells
        std::vector<Point> walk;
        for (int i = 0; i < 60; ++i)
        {
            const Point next = lattice.centre(random.cellOf(lattice));
            if (occupancy->isFree(lattice.cellAt(next)) && (walk.empty() || isValid(walk.back(), next)))
                walk.push_back(next);
        }
        if (walk.size() < 3)
            continue;
        ++routes;
        const Route smoothed = dropRedundantNodes(Route(walk), isValid);
        const std::vector<Point> &kept = smoothed.waypoints();
        ASSERT_EQ(kept.front(), walk.front());
        ASSERT_EQ(kept.back(), walk.back());
        std::size_t at = 0;
        for (const Point &node : kept)
        {
            while (at < walk.size() && walk[at] != node)
                ++at;
            ASSERT_LT(at, walk.size()) << "not a node of the input, or out of order";
            ++at;
        }
        for (std::size_t i = 0; i < smoothed.legCount(); ++i)
            ASSERT_TRUE(isValid(smoothed.leg(i).from, smoothed.leg(i).to));
        ASSERT_LE(smoothed.length(), Route(walk).length() * (1.0 + 1e-12));
        dropped += static_cast<int>(walk.size() - kept.size());
    }
    EXPECT_GT(routes, 200);
    EXPECT_GT(dropped, routes);
}

}  // namespace
}  // namespace seahex
