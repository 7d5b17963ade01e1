#include "demos/PlanRoute.h"

#include <fstream>

using namespace seahex::test;

namespace fs = std::filesystem;

namespace
{

TEST(FirstRoute, writesARouteThatTouchesNothing)
{
    const TemporaryFolder folder;
    fs::create_directory_symlink(SEAHEX_MAPS_DIR, folder / "maps");
    const ProgramResult result = runProgram({SEAHEX_FIRST_ROUTE}, folder.path());
    ASSERT_EQ(result.exitCode, 0) << result.summary();
    const nlohmann::json written = nlohmann::json::parse(readBytes(folder / "route.geojson"));
    std::vector<LatLon> route;
    for (const nlohmann::json &position : written.at("features").at(0).at("geometry").at("coordinates"))
        route.emplace_back(position.at(1), position.at(0));
    ASSERT_GE(route.size(), 3u) << "the straight line crosses the island";
    EXPECT_EQ(route.front(), LatLon(21.635, 112.521));
    EXPECT_EQ(route.back(), LatLon(21.669, 112.901));
    for (const Violation &violation : ChartOracle(shangchuan(), {1.2, 0.5}).violationsWithin(route, 9.9))
        ADD_FAILURE() << "leg " << violation.leg << ": " << violation.what;
}

TEST(FirstRoute, withoutItsChartItSaysSo)
{
    const TemporaryFolder folder;
    const ProgramResult result = runProgram({SEAHEX_FIRST_ROUTE}, folder.path());
    EXPECT_NE(result.exitCode, 0);
    EXPECT_NE(result.err.find("maps/shangchuan.000"), std::string::npos) << result.summary();
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(FirstRoute, isShort)
{
    std::ifstream source(fs::path(SEAHEX_DEMOS_DIR) / "first_route.cpp");
    ASSERT_TRUE(source);
    std::size_t lines = 0;
    for (std::string line; std::getline(source, line);)
        ++lines;
    EXPECT_GT(lines, 10u);
    EXPECT_LT(lines, 60u);
}

}  // namespace
