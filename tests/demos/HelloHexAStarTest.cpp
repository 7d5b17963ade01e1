#include "support/RunProgram.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

using namespace seahex::test;

namespace
{

struct Position
{
    double x;
    double y;
};

/// The lines of two numbers: the path, as PathGeometric::printAsMatrix writes it.
std::vector<Position> pathIn(const std::string &text)
{
    std::vector<Position> path;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
        std::istringstream words(line);
        Position position{};
        std::string rest;
        if (words >> position.x >> position.y && !(words >> rest))
            path.push_back(position);
    }
    return path;
}

/// The demo has OMPL look at a motion at points 0.14 apart, so a corner may be cut by half of that.
bool isInAWall(const Position &p)
{
    constexpr double cut = 0.071;
    return (p.x > 30 + cut && p.x < 34 - cut && p.y < 80 - cut) || (p.x > 64 + cut && p.x < 68 - cut && p.y > 20 + cut);
}

TEST(HelloHexAStar, printsAPathAroundBothWalls)
{
    const ProgramResult result = runProgram({SEAHEX_HELLO_HEXASTAR});
    ASSERT_EQ(result.exitCode, 0) << result.summary();
    const std::vector<Position> path = pathIn(result.out);
    ASSERT_GE(path.size(), 4u) << result.summary();
    EXPECT_EQ(path.front().x, 10);
    EXPECT_EQ(path.front().y, 10);
    EXPECT_EQ(path.back().x, 90);
    EXPECT_EQ(path.back().y, 90);
    constexpr int pieces = 100;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        for (int k = 0; k <= pieces; ++k)
        {
            const double t = static_cast<double>(k) / pieces;
            const Position p{path[i].x + t * (path[i + 1].x - path[i].x), path[i].y + t * (path[i + 1].y - path[i].y)};
            EXPECT_FALSE(isInAWall(p)) << "leg " << i << " is in a wall at " << p.x << ", " << p.y;
        }
}

TEST(HelloHexAStar, isShort)
{
    std::ifstream source(std::filesystem::path(SEAHEX_DEMOS_DIR) / "hello_hexastar.cpp");
    ASSERT_TRUE(source);
    std::size_t lines = 0;
    for (std::string line; std::getline(source, line);)
        ++lines;
    EXPECT_GT(lines, 20u);
    EXPECT_LT(lines, 60u);
}

}  // namespace
