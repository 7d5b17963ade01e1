#include "support/RunProgram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

using namespace seahex::test;

namespace
{

/// The table: cost of each planner's path.
std::map<std::string, double> costsIn(const std::string &text)
{
    std::map<std::string, double> costs;
    std::istringstream lines(text);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line))
    {
        std::istringstream words(line);
        std::string planner;
        double cost = 0.0;
        int legs = 0;
        if (words >> planner >> cost >> legs && legs > 0)
            costs[planner.substr(planner.rfind(':') + 1)] = cost;
    }
    return costs;
}

TEST(LatticePlanners, PrintsWhatEachPathCosts)
{
    const ProgramResult result = runProgram({SEAHEX_LATTICE_PLANNERS});
    ASSERT_EQ(result.exitCode, 0) << result.summary();
    const std::map<std::string, double> costs = costsIn(result.out);
    for (const char *planner : {"HexAStar", "RRTConnect", "RRTstar", "PRMstar"})
        EXPECT_EQ(costs.count(planner), 1U) << result.summary();
    // around the tips of both walls; start and goal snap to centres, at most 2.5 / sqrt(3) away
    const double shortest = std::hypot(22, 70) + std::hypot(34, 60) + std::hypot(24, 70) - 2.0 * 1.4434;
    for (const auto &[planner, cost] : costs)
    {
        EXPECT_GE(cost, shortest) << planner;
        EXPECT_LT(cost, 3.0 * shortest) << planner;
    }
}

TEST(LatticePlanners, IsShort)
{
    std::ifstream source(std::filesystem::path(SEAHEX_DEMOS_DIR) / "lattice_planners.cpp");
    ASSERT_TRUE(source);
    std::size_t lines = 0;
    for (std::string line; std::getline(source, line);)
        ++lines;
    EXPECT_GT(lines, 20u);
    EXPECT_LT(lines, 80u);
}

}  // namespace
