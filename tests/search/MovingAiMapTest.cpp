#include "support/MovingAiMap.h"
#include "support/TestData.h"

#include <sstream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

const std::string header = "type octile\nheight 2\nwidth 7\nmap\n";
const std::string map = header + ".GS@OTW\n@@@@@@.\n";

MovingAiMap mapOf(const std::string &text)
{
    std::istringstream in(text);
    return MovingAiMap::read(in, "some.map");
}

std::vector<MovingAiScenario> readScenarios(const std::string &text)
{
    std::istringstream in(text);
    return readMovingAiScenarios(in, "some.scen", mapOf(map));
}

/// What the error says; empty if there is none.
template <class Read>
std::string complaintOf(Read &&read)
{
    try
    {
        read();
        return "";
    }
    catch (const std::runtime_error &error)
    {
        return error.what();
    }
}

std::string mapComplaint(const std::string &text)
{
    return complaintOf([&text] { mapOf(text); });
}

std::string scenarioComplaint(const std::string &line)
{
    return complaintOf([&line] { readScenarios("version 1\n" + line + "\n"); });
}

}  // namespace

TEST(MovingAiMap, groundAndSwampArePassable)
{
    for (const std::string &text : {map, map + "\n\n", header + ".GS@OTW\r\n@@@@@@."})
    {
        const MovingAiMap read = mapOf(text);
        ASSERT_EQ(read.columns(), 7);
        ASSERT_EQ(read.rows(), 2);
        for (std::int64_t column = -1; column <= 7; ++column)
        {
            EXPECT_EQ(read.isPassable({column, 0}), column >= 0 && column <= 2);
            EXPECT_EQ(read.isPassable({column, 1}), column == 6);
            EXPECT_FALSE(read.isPassable({column, -1}));
            EXPECT_FALSE(read.isPassable({column, 2}));
        }
    }
}

TEST(MovingAiMap, scenariosAreReadWithTabsAndBlanks)
{
    for (const std::string version : {"version 1", "version 1.0\r"})
    {
        const auto scenarios =
            readScenarios(version + "\n3\tmaps/some.map\t7\t2\t0\t0\t6\t1\t6.41421\n0 x 7 2 1 0 2 0 1\n\n");
        ASSERT_EQ(scenarios.size(), 2u);
        EXPECT_EQ(scenarios[0].start, (OffsetCoord{0, 0}));
        EXPECT_EQ(scenarios[0].goal, (OffsetCoord{6, 1}));
        EXPECT_EQ(scenarios[0].optimalLength, 6.41421);
        EXPECT_EQ(scenarios[1].start, (OffsetCoord{1, 0}));
        EXPECT_EQ(scenarios[1].goal, (OffsetCoord{2, 0}));
        EXPECT_EQ(scenarios[1].optimalLength, 1.0);
    }
}

TEST(MovingAiMap, badMapsSayWhere)
{
    EXPECT_EQ(mapComplaint(map), "");
    EXPECT_EQ(mapComplaint(""), "some.map:1: the file ends where 'type octile' should be");
    EXPECT_EQ(mapComplaint("type tile\n"), "some.map:1: 'type octile' expected, not 'type tile'");
    EXPECT_EQ(mapComplaint("type octile\nwidth 7\n"),
              "some.map:2: 'height' and a positive number expected, not 'width 7'");
    for (const std::string bad : {"width", "width 0", "width -3", "width x", "width 7 7", "width 99999999999999999999"})
        EXPECT_EQ(mapComplaint("type octile\nheight 2\n" + bad + "\nmap\n"),
                  "some.map:3: 'width' and a positive number expected, not '" + bad + "'");
    EXPECT_EQ(mapComplaint("type octile\nheight 2\nwidth 7\n......."), "some.map:4: 'map' expected, not '.......'");
    EXPECT_EQ(mapComplaint(header + "......\n.......\n"), "some.map:5: 7 cells expected, not 6");
    EXPECT_EQ(mapComplaint(header + ".......\n...x...\n"), "some.map:6: 'x' is no terrain");
    EXPECT_EQ(mapComplaint(header + ".......\n"), "some.map:6: the file ends where row 1 of the map should be");
    EXPECT_EQ(mapComplaint(map + "\n.......\n"), "some.map:8: the map has more than 2 rows");
    EXPECT_EQ(complaintOf([] { MovingAiMap::read("/nowhere/no.map"); }), "/nowhere/no.map: can't be read");
}

TEST(MovingAiMap, badScenariosSayWhere)
{
    EXPECT_EQ(scenarioComplaint("0 some.map 7 2 0 0 6 1 6.41"), "");
    const std::string fields =
        "some.scen:2: bucket, map, width, height, start x and y, goal x and y, optimal length expected";
    EXPECT_EQ(scenarioComplaint("0 some.map 7 2 0 0 6 1"), fields);
    EXPECT_EQ(scenarioComplaint("0 some.map 7 2 0 0 6 1 6.41 9"), fields);
    EXPECT_EQ(scenarioComplaint("0 some.map 7 2 0 zero 6 1 6.41"), fields);
    EXPECT_EQ(scenarioComplaint("0 some.map 7 3 0 0 6 1 6.41"),
              "some.scen:2: the scenario is for a map of 7 x 3 cells, this one has 7 x 2");
    EXPECT_EQ(scenarioComplaint("0 some.map 7 2 3 0 6 1 6.41"), "some.scen:2: the start is no passable cell");
    EXPECT_EQ(scenarioComplaint("0 some.map 7 2 0 0 6 2 6.41"), "some.scen:2: the goal is no passable cell");
    EXPECT_EQ(scenarioComplaint("0 some.map 7 2 0 0 6 1 -1"), "some.scen:2: the optimal length is no length");
    EXPECT_EQ(complaintOf([] { readScenarios(""); }), "some.scen:1: the file ends where 'version 1' should be");
    EXPECT_EQ(complaintOf([] { readScenarios("version 2\n"); }), "some.scen:1: 'version 1' expected, not 'version 2'");
    EXPECT_EQ(complaintOf([] { readMovingAiScenarios("/nowhere/no.scen", mapOf(map)); }),
              "/nowhere/no.scen: can't be read");
}

TEST(MovingAiMap, publishedMapsAreRead)
{
    SEAHEX_TEST_DATA_OR_SKIP(folder, "movingai");
    const MovingAiMap arena = MovingAiMap::read(folder / "arena.map");
    EXPECT_EQ(arena.columns(), 49);
    EXPECT_EQ(arena.rows(), 49);
    std::int64_t passable = 0;
    for (std::int64_t row = 0; row < arena.rows(); ++row)
        for (std::int64_t column = 0; column < arena.columns(); ++column)
            passable += arena.isPassable({column, row}) ? 1 : 0;
    EXPECT_EQ(passable, 2054);
    EXPECT_EQ(readMovingAiScenarios(folder / "arena.map.scen", arena).size(), 160u);
    const MovingAiMap wide = MovingAiMap::read(folder / "arena2.map");
    EXPECT_EQ(wide.columns(), 281);
    EXPECT_EQ(wide.rows(), 209);
}
