// The search on squares against the published optima of the MovingAI benchmark.

#include "support/ExplicitGraph.h"
#include "support/MovingAiMap.h"
#include "support/SquareSearch.h"
#include "support/TestData.h"

#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

/// Lengths in the files are rounded to two digits and more.
constexpr double rounding = 0.01;

}  // namespace

TEST(MovingAiSearch, costsAreThePublishedOptimaOfEveryScenario)
{
    SEAHEX_TEST_DATA_OR_SKIP(folder, "movingai");
    const std::vector<std::filesystem::path> maps = movingAiMapsIn(folder);
    ASSERT_FALSE(maps.empty());
    for (const std::filesystem::path &path : maps)
    {
        SCOPED_TRACE(path.filename().string());
        const MovingAiMap map = MovingAiMap::read(path);
        const auto occupancy = map.occupancy();
        SquareSearch search(*occupancy, 8, JumpRule::Safe, Guidance::Distance);
        const std::vector<MovingAiScenario> scenarios = readMovingAiScenarios(scenariosOf(path), map);
        ASSERT_FALSE(scenarios.empty());
        for (const MovingAiScenario &scenario : scenarios)
            ASSERT_NEAR(search.cost(scenario.start, scenario.goal), scenario.optimalLength, rounding)
                << "from " << scenario.start.column << ", " << scenario.start.row << " to " << scenario.goal.column
                << ", " << scenario.goal.row;
    }
}

TEST(MovingAiSearch, withCornersCutCostsEqualDijkstras)
{
    SEAHEX_TEST_DATA_OR_SKIP(folder, "movingai");
    int shorter = 0;
    for (const std::filesystem::path &path : movingAiMapsIn(folder))
    {
        SCOPED_TRACE(path.filename().string());
        const MovingAiMap map = MovingAiMap::read(path);
        const auto occupancy = map.occupancy();
        const SquareLattice &lattice = occupancy->lattice();
        const ExplicitGraph graph = stepGraph(*occupancy, 8, JumpRule::Hopping);
        SquareSearch search(*occupancy, 8, JumpRule::Hopping, Guidance::Distance);
        // from one start to the goals of some scenarios
        const std::vector<MovingAiScenario> scenarios = readMovingAiScenarios(scenariosOf(path), map);
        const OffsetCoord start = scenarios.back().start;
        const std::vector<double> costs = graph.costsFrom({{vertexOf(lattice, start), 0.0}});
        for (std::size_t back = 1; back <= scenarios.size(); back += 40)
        {
            const MovingAiScenario &scenario = scenarios[scenarios.size() - back];
            ASSERT_NEAR(search.cost(start, scenario.goal), costs[vertexOf(lattice, scenario.goal)], 1e-9)
                << "to " << scenario.goal.column << ", " << scenario.goal.row;
            if (scenario.start == start)
                shorter += search.cost(start, scenario.goal) < scenario.optimalLength - rounding ? 1 : 0;
        }
    }
    EXPECT_GT(shorter, 0) << "somewhere a cut corner saves something";
}
