#include "demos/PlanRoute.h"
#include "reproduce_papers/Quartiles.h"
#include "reproduce_papers/Table.h"

#include <set>

using namespace seahex::test;

namespace fs = std::filesystem;

namespace
{

using Arguments = std::vector<std::string>;

ProgramResult reproduce(const Arguments &arguments, const fs::path &folder)
{
    Arguments command = {SEAHEX_REPRODUCE_PAPERS};
    command.insert(command.end(), arguments.begin(), arguments.end());
    return runProgram(command, folder, std::chrono::seconds(600));
}

/// The report of one run that all tests share: both papers, and pairs on all charts that are there.
const nlohmann::json &report()
{
    static const nlohmann::json parsed = []
    {
        const TemporaryFolder folder;
        Arguments arguments = {"--json", "--pairs", "48"};
        if (const char *data = std::getenv("SEAHEX_TEST_DATA"))
            if (fs::is_directory(fs::path(data) / "charts" / "noaa"))
                arguments.insert(arguments.end(), {"--charts", (fs::path(data) / "charts" / "noaa").string()});
        const ProgramResult result = reproduce(arguments, folder.path());
        EXPECT_EQ(result.exitCode, 0) << result.summary();
        nlohmann::json fromFile = nlohmann::json::parse(readBytes(folder / "reproduction/report.json"));
        EXPECT_EQ(nlohmann::json::parse(result.out), fromFile) << "what is printed is what is written";
        for (const auto &figure : fromFile.at("figures"))
            EXPECT_GT(fs::file_size(folder / figure.get<std::string>()), 20000u) << figure;
        return fromFile;
    }();
    return parsed;
}

const nlohmann::json &tableOf(const std::string &id)
{
    for (const auto &table : report().at("tables"))
        if (table.at("id") == id)
            return table;
    throw std::runtime_error("no table " + id);
}

double valueIn(const std::string &table, const std::string &row, const std::string &column)
{
    for (const auto &line : tableOf(table).at("rows"))
        if (line.at("name") == row)
            return line.at("values").at(column).get<double>();
    throw std::runtime_error("no row " + row + " in " + table);
}

const nlohmann::json &chartsOf(const std::string &claim)
{
    for (const auto &entry : report().at("claims"))
        if (entry.at("id") == claim)
            return entry.at("charts");
    throw std::runtime_error("no claim " + claim);
}

TEST(ReproducePapers, drawsTheFiguresOfBothPapers)
{
    std::set<std::string> names;
    for (const auto &figure : report().at("figures"))
        names.insert(fs::path(figure.get<std::string>()).stem().string());
    for (const char *name :
         {"cheng2020_figure3", "cheng2020_figure4", "cheng2020_figure5", "cheng2020_figure6", "wang2017_sanya_figure3a",
          "wang2017_sanya_figure3b", "wang2017_sanya_figure3c", "xu_figure"})
        EXPECT_EQ(names.count(name), 1u) << name;
}

TEST(ReproducePapers, hexagonsAndSquaresOfChengsScenario)
{
    const char *table = "cheng2020_table2";
    EXPECT_EQ(valueIn(table, "length, steps of the lattice", "hex 6 published"), 146.0);
    EXPECT_EQ(valueIn(table, "length, steps of the lattice", "square 8 published"), 142.74);
    for (const char *square : {"square 8 equal spacing", "square 8 equal area"})
    {
        for (const char *row : {"length, steps of the lattice", "length, straight", "turn angles, degrees"})
            EXPECT_GT(valueIn(table, row, "hex 6"), valueIn(table, row, square)) << row << ", " << square;
        EXPECT_GT(valueIn(table, "turns", "hex 6"), valueIn(table, "turns", square)) << square;
    }
    EXPECT_LE(valueIn(table, "length, straight", "equal spacing corners cut"),
              valueIn(table, "length, straight", "square 8 equal spacing"));
}

TEST(ReproducePapers, moreNeighboursInChengsScenario)
{
    const char *table = "cheng2020_table3";
    for (const char *jumps : {"safe jumps", "straight lengths"})
        for (const char *row : {"length, straight", "turns", "turn angles, degrees"})
        {
            const double six = valueIn(table, row, std::string("6 ") + jumps);
            const double eighteen = valueIn(table, row, std::string("18 ") + jumps);
            const double thirtySix = valueIn(table, row, std::string("36 ") + jumps);
            EXPECT_GT(six, eighteen) << row << ", " << jumps;
            EXPECT_GT(eighteen, thirtySix) << row << ", " << jumps;
        }
    EXPECT_LT(valueIn(table, "length, steps of the lattice", "36 hopping jumps"),
              valueIn(table, "length, steps of the lattice", "36 safe jumps"));
}

TEST(ReproducePapers, allGuidesFindTheShortestPathWhereTheyAreSureOfIt)
{
    const auto &rows = tableOf("cheng2020_guides").at("rows");
    for (const auto &row : rows)
        for (const char *column : {"length", "length   "})
            EXPECT_NEAR(row.at("values").at(column).get<double>(), rows.at(0).at("values").at(column).get<double>(),
                        1e-9)
                << row.at("name");
    EXPECT_GT(valueIn("cheng2020_guides", "cheng", "hex 6 expanded"),
              valueIn("cheng2020_guides", "distance", "hex 6 expanded"));
    EXPECT_LT(valueIn("cheng2020_guides", "cheng", "hex 6 expanded"),
              valueIn("cheng2020_guides", "none", "hex 6 expanded"));
}

TEST(ReproducePapers, tableOneOfWang)
{
    for (const char *window : {"sanya", "shangchuan"})
        for (const char *cells : {"squares", "hexagons"})
        {
            const std::string table = std::string("wang2017_table1_") + window + "_" + cells;
            const auto value = [&table](const char *row, const char *column)
            {
                return valueIn(table, row, column);
            };
            EXPECT_LT(value("nodes traversed", "A*"), value("nodes traversed", "Dijkstra")) << table;
            EXPECT_GT(value("nodes traversed", "improved, not smoothed"), value("nodes traversed", "A*")) << table;
            EXPECT_LT(value("nodes traversed", "improved, not smoothed"), value("nodes traversed", "Dijkstra"))
                << table;
            EXPECT_LT(value("potential hazards", "improved, with margin"), value("potential hazards", "A*")) << table;
            EXPECT_LT(value("route nodes", "improved, with margin"), 0.2 * value("route nodes", "A*")) << table;
            EXPECT_LT(value("turns", "improved, with margin"), value("turns", "A*")) << table;
            EXPECT_NEAR(value("sailing distance, NM", "A*"), value("sailing distance, NM", "Dijkstra"),
                        0.01 * value("sailing distance, NM", "Dijkstra"))
                << table << ": equal in degrees, and nearly so in miles";
            EXPECT_LT(value("sailing distance, NM", "improved, string pulled"),
                      value("sailing distance, NM", "improved, with margin"))
                << table;
        }
    EXPECT_LT(valueIn("wang2017_table1_sanya_squares", "sailing distance, NM", "improved, with margin"),
              valueIn("wang2017_table1_sanya_squares", "sailing distance, NM", "A*"));
}

TEST(ReproducePapers, whatXuSaysOfTheAntsHoldsInTheMedian)
{
    for (const char *claim :
         {"[Xu] length, greedy optimised - ants < 0", "[Xu] course changes, greedy optimised - ants < 0",
          "[Xu] course angles, greedy optimised - ants < 0"})
    {
        EXPECT_GE(valueIn("xu_claims", claim, "terrains"), 40.0) << claim;
        EXPECT_LT(valueIn("xu_claims", claim, "median"), 0.0) << claim;
    }
}

TEST(ReproducePapers, exactSelectionIsNeverWorseAndFindsMoreDives)
{
    for (const char *other : {"F, exact - greedy < 0", "F, exact - ants < 0"})
        EXPECT_EQ(valueIn("xu_claims", other, "holds %") + valueIn("xu_claims", other, "equal %"), 100.0) << other;
    const auto found = [](const char *method)
    {
        return valueIn("xu_methods", "dives found", method);
    };
    EXPECT_GT(found("exact"), found("greedy")) << "the published selection walks into dead ends";
    EXPECT_GE(found("exact"), found("ants"));
    for (const char *search : {"greedy", "exact", "ants"})
    {
        const std::string optimised = std::string(search) + " optimised";
        EXPECT_EQ(found(search), found(optimised.c_str()));
        for (const char *row : {"length F1, median", "danger F2, median", "F, median", "course changes, median"})
            EXPECT_LT(valueIn("xu_methods", row, optimised), valueIn("xu_methods", row, search)) << row;
    }
}

TEST(ReproducePapers, whatDoesNotReproduceOfXuIsToldAsSuch)
{
    EXPECT_GT(valueIn("xu_claims", "F, greedy - ants < 0", "median"), 0.0);
    EXPECT_GT(valueIn("xu_claims", "danger, greedy optimised - ants < 0", "median"), 0.0);
}

/// What reproduces does so in the median on every chart.
TEST(ReproducePapers, claimsThatReproduceHoldOnEveryChart)
{
    for (const char *claim : {"hex_is_longer",
                              "hex_turns_wider",
                              "rings_2_shorten",
                              "rings_3_shorten",
                              "rings_2_straighten",
                              "rings_3_straighten",
                              "published_rings_2_turn_less",
                              "published_rings_3_turn_less",
                              "published_rings_2_straighten",
                              "published_rings_3_straighten",

                              "a_star_saves",
                              "improved_costs",
                              "improved_saves",
                              "weights_avoid_hazards",
                              "margin_keeps_off",
                              "smoothing_drops_nodes",
                              "smoothing_turns_less",
                              "hex_smoothing_shortens",
                              "hex_elongation",
                              "square_elongation",
                              "pulling_beats_rings",
                              "pulling_shortens_more"})
        for (const auto &chart : chartsOf(claim))
        {
            EXPECT_TRUE(chart.at("holds").get<bool>()) << claim << " on " << chart.dump();
            EXPECT_GE(chart.at("pairs").get<int>(), 40) << chart.dump();
        }
    EXPECT_GE(chartsOf("hex_is_longer").size(), 2u);
}

TEST(ReproducePapers, theRelaxedGuideFindsPathsAsShortWithFewerCells)
{
    for (const char *columns : {"hex 6 expanded", "hex 36 expanded"})
        EXPECT_LT(valueIn("cheng2020_guides", "relaxed", columns), valueIn("cheng2020_guides", "distance", columns));
    for (const char *claim : {"relaxed_saves", "relaxed_saves_36"})
        for (const auto &chart : chartsOf(claim))
            EXPECT_LE(chart.at("upper_quartile").get<double>(), 1.0 + 1e-9) << claim << " on " << chart.dump();
}

TEST(ReproducePapers, claimsThatDoNotReproduceAreToldAsSuch)
{
    for (const char *claim : {"guide_saves", "hex_visits_fewer_guided"})
        for (const auto &chart : chartsOf(claim))
            EXPECT_FALSE(chart.at("holds").get<bool>()) << claim << " on " << chart.dump();
}

TEST(ReproducePapers, theSameWhateverTheThreads)
{
    const TemporaryFolder folder;
    const auto claims = [&folder](const char *threads)
    {
        const ProgramResult result = reproduce({"--json", "--pairs", "8", "--threads", threads}, folder.path());
        EXPECT_EQ(result.exitCode, 0) << result.summary();
        nlohmann::json all = nlohmann::json::parse(result.out).at("claims");
        // what is timed is not the same twice
        for (const char *timed : {"rings_take_time", "relaxed_saves_time"})
            all.erase(std::find_if(all.begin(), all.end(),
                                   [timed](const nlohmann::json &claim) { return claim.at("id") == timed; }));
        return all;
    };
    EXPECT_EQ(claims("1"), claims("3"));
}

TEST(ReproducePapers, refusesWithOneSentence)
{
    const TemporaryFolder folder;
    writeBytes(folder / "file", "no folder");
    fs::create_directory(folder / "empty");
    const auto expectRefusal = [&folder](const Arguments &arguments, int code, const std::string &word)
    {
        const ProgramResult result = reproduce(arguments, folder.path());
        EXPECT_EQ(result.exitCode, code) << result.summary();
        EXPECT_NE(result.err.find(word), std::string::npos) << result.summary();
        EXPECT_TRUE(result.out.empty()) << result.summary();
        EXPECT_FALSE(fs::exists(folder / "reproduction")) << "nothing half-written";
    };
    expectRefusal({"--pairs", "0"}, 2, "--pairs");
    expectRefusal({"--cells", "nan"}, 2, "--cells");
    expectRefusal({"--threads", "0"}, 2, "--threads");
    expectRefusal({"--format", "gif"}, 2, "gif");
    expectRefusal({"--out", "file"}, 2, "--out");
    expectRefusal({"--charts", "empty"}, 3, "empty");
    expectRefusal({"--charts", "nowhere.000", "--pairs", "1"}, 3, "nowhere.000");
    expectRefusal({"--charts", "file", "--pairs", "1"}, 3, "file");
}

TEST(ReproducePapers, quartiles)
{
    const auto of = [](std::vector<double> values)
    {
        const reproduce_papers::Quartiles q = reproduce_papers::quartilesOf(std::move(values));
        return std::vector<double>{q.lower, q.median, q.upper};
    };
    EXPECT_EQ(of({7.0}), (std::vector<double>{7.0, 7.0, 7.0}));
    EXPECT_EQ(of({5.0, 1.0, 3.0, 2.0, 4.0}), (std::vector<double>{2.0, 3.0, 4.0}));
    EXPECT_EQ(of({4.0, 1.0}), (std::vector<double>{1.75, 2.5, 3.25}));
}

TEST(ReproducePapers, tablesLineUp)
{
    reproduce_papers::Table table;
    table.title = "title";
    table.columns = {"one", "two_and more"};
    table.rows = {{"long name", {1.0, std::nullopt}, 2}, {"x", {-20.0, 3.5}, 0}};
    table.note = "first\nsecond";
    EXPECT_EQ(toText(table), "title\n"
                             "                   two and\n"
                             "              one     more\n"
                             "  long name  1.00        -\n"
                             "  x           -20        4\n"
                             "  first\n  second\n");
}

}  // namespace
