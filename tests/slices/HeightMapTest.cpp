#include "support/Random.h"

#include <seahex/slices/HeightMap.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace seahex::test
{
namespace
{

TEST(HeightMap, IsBilinearBetweenGridPoints)
{
    const HeightMap map(3, {0, 1, 2,  //
                            4, 6, 8,  //
                            9, 9, 1});
    EXPECT_EQ(map.at(3, 1), 2.0);
    EXPECT_EQ(map.at(1, 3), 9.0);
    for (int x = 1; x <= 3; ++x)
        for (int y = 1; y <= 3; ++y)
            EXPECT_EQ(map.height(x, y), map.at(x, y));
    EXPECT_DOUBLE_EQ(map.height(1.5, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(map.height(1.0, 1.25), 1.0);
    EXPECT_DOUBLE_EQ(map.height(1.5, 1.5), 2.75);
    EXPECT_DOUBLE_EQ(map.height(2.5, 2.5), 6.0);
    EXPECT_EQ(map.height(-5.0, 9.0), 9.0) << "beyond the grid as on its edge";
}

TEST(HeightMap, HillsAreTheSeeds)
{
    const auto heightsOf = [](std::uint64_t seed)
    {
        const HeightMap map = randomHills(25, seed);
        std::vector<double> heights;
        for (int x = 1; x <= 25; ++x)
            for (int y = 1; y <= 25; ++y)
                heights.push_back(map.at(x, y));
        return heights;
    };
    EXPECT_EQ(heightsOf(1), heightsOf(1));
    EXPECT_NE(heightsOf(1), heightsOf(2));
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
    {
        const std::vector<double> heights = heightsOf(seed);
        EXPECT_GE(*std::min_element(heights.begin(), heights.end()), 1.0);
        EXPECT_LE(*std::max_element(heights.begin(), heights.end()), 22.5);
        EXPECT_GT(*std::max_element(heights.begin(), heights.end()), 8.0) << "hardly a hill, seed " << seed;
    }
}

TEST(HeightMap, PlacesAreKeptClear)
{
    const Eigen::Vector3d start(1, 8, 6);
    const Eigen::Vector3d goal(25, 23, 10);
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        const HeightMap map = randomHills(25, seed, {start, goal});
        EXPECT_LE(map.at(1, 8), 4.0 + 1e-9) << "seed " << seed;
        EXPECT_LE(map.at(25, 23), 8.0 + 1e-9) << "seed " << seed;
    }
}

}  // namespace
}  // namespace seahex::test
