// That the benchmark measures what it says: every contender finds the costs of Dijkstra's algorithm, wrong ones are
// refused, and verdicts follow from figures.

#include "contest/Archipelago.h"
#include "contest/Figures.h"
#include "contest/Median.h"
#include "contest/Options.h"
#include "contest/Queries.h"
#include "contest/Targets.h"
#include "contest/TextbookAStar.h"
#include "contest/Trial.h"

#include "support/Random.h"

#include <seahex/world/CellBits.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace seahex::contest
{
namespace
{

using test::forEachSeed;
using test::Random;

HexCoord freeCell(Random &random, const HexOccupancy &occupancy)
{
    for (;;)
        if (const HexCoord cell = random.cellOf(occupancy.lattice()); occupancy.isFree(cell))
            return cell;
}

ContenderKind kindOf(int rings, Side side, const std::string &name)
{
    ContenderKind kind;
    kind.name = name;
    kind.rings = rings;
    kind.side = side;
    return kind;
}

Result resultOf(const std::string &contender, Side side, std::vector<double> queryMs)
{
    Result result;
    result.world = "N";
    result.contender = contender;
    result.side = side;
    result.indices = 64;
    result.answers.resize(queryMs.size());
    result.queryMs = std::move(queryMs);
    return result;
}

/// The verdict's line that begins so.
std::string lineOf(const Measurements &measurements, const std::string &beginning)
{
    std::stringstream text;
    printVerdicts(measurements, text);
    for (std::string line; std::getline(text, line);)
        if (line.rfind(beginning, 0) == 0)
            return line;
    return "";
}

TEST(Contenders, FindTheCostsOfDijkstra)
{
    int joined = 0;
    int apart = 0;
    forEachSeed(40,
                [&](Random &random)
                {
                    const HexLattice lattice(Point(0, 0), 1.0, random.integer(2, 30), random.integer(2, 30));
                    const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.4));
                    if (occupancy->blockedCount() == lattice.cellCount())
                        return;
                    for (const ContenderKind &kind : contenders())
                    {
                        SCOPED_TRACE(kind.name);
                        TextbookAStar dijkstra(*occupancy, kind.rings, false);
                        // one for all queries: what one leaves must not show in the next
                        const auto contender = kind.make(*occupancy);
                        for (int i = 0; i < 5; ++i)
                        {
                            const Query query{freeCell(random, *occupancy), freeCell(random, *occupancy)};
                            const double expected = dijkstra.solve(query).cost;
                            const Answer answer = contender->solve(query);
                            std::isinf(expected) ? ++apart : ++joined;
                            if (std::isinf(expected))
                                EXPECT_EQ(answer.cost, expected);
                            else
                                EXPECT_NEAR(answer.cost, expected, 1e-8 * (1.0 + expected));
                            EXPECT_GE(answer.expanded, 1U);
                            EXPECT_GE(answer.touched, 1U);
                        }
                    }
                });
    EXPECT_GT(joined, 500);
    EXPECT_GT(apart, 50);
}

TEST(Contenders, HaveNamesOfTheirOwn)
{
    for (const ContenderKind &kind : contenders())
        EXPECT_EQ(&contenderNamed(kind.name), &kind);
    EXPECT_THROW(contenderNamed("nobody"), std::runtime_error);
}

TEST(Queries, AreLongAndHaveAnAnswer)
{
    const World world = makeWorld("archipelago:1e4");
    const HexLattice &lattice = world.occupancy->lattice();
    const double diagonal = (lattice.bounds().max - lattice.bounds().min).norm();
    TextbookAStar dijkstra(*world.occupancy, 1, false);
    const std::vector<Query> queries = drawQueries(*world.occupancy, 20, 1);
    ASSERT_EQ(queries.size(), 20U);
    for (const Query &query : queries)
    {
        EXPECT_GE((lattice.centre(query.goal) - lattice.centre(query.start)).norm(), 0.4 * diagonal);
        EXPECT_TRUE(std::isfinite(dijkstra.solve(query).cost));
    }
    const auto again = drawQueries(*world.occupancy, 20, 1);
    const auto others = drawQueries(*world.occupancy, 20, 2);
    EXPECT_TRUE(again.front().start == queries.front().start && again.back().goal == queries.back().goal);
    EXPECT_FALSE(others.front().start == queries.front().start && others.back().goal == queries.back().goal);
}

TEST(Queries, StayInOneWater)
{
    const HexLattice lattice(Point(0, 0), 1.0, 40, 40);
    CellBits bits(CellLayout(40, 40));
    bits.setSpan(20, 0, 39);  // a wall from west to east
    bits.setOutside();
    const CellLayout layout = bits.layout();
    const HexOccupancy occupancy(lattice, layout, std::move(bits.words()));
    for (std::uint64_t seed = 1; seed <= 5; ++seed)
        for (const Query &query : drawQueries(occupancy, 20, seed))
            EXPECT_EQ(query.start.s < 20, query.goal.s < 20) << "seed " << seed;
}

TEST(Queries, AreNotDrawnOnLand)
{
    Random random(1);
    const HexLattice lattice(Point(0, 0), 1.0, 20, 20);
    EXPECT_THROW(drawQueries(*randomOccupancy(random, lattice, 1.0), 1, 1), std::runtime_error);
}

TEST(Archipelago, IsTheSameAtEachCallAndHasLandAndWater)
{
    const Box box{Point(0, 0), Point(300, 260)};
    const std::vector<Polygon> islands = archipelago(box, 2.0, 7);
    const std::vector<Polygon> again = archipelago(box, 2.0, 7);
    ASSERT_EQ(islands.size(), again.size());
    EXPECT_NE(islands.front().outer()[1], archipelago(box, 2.0, 8).front().outer()[1]);
    for (std::size_t i = 0; i < islands.size(); ++i)
    {
        const Ring &coast = islands[i].outer();
        ASSERT_GE(coast.size(), 4U);
        EXPECT_EQ(coast.front(), coast.back());
        EXPECT_EQ(coast.back(), again[i].outer().back());
        for (std::size_t k = 1; k < coast.size(); ++k)
            EXPECT_LE((coast[k] - coast[k - 1]).norm(), 2.0);
    }
    for (const char *name : {"archipelago:1e3", "archipelago:1e4", "archipelago:1e6"})
    {
        const World world = makeWorld(name);
        const HexOccupancy &cells = *world.occupancy;
        const double share =
            static_cast<double>(cells.blockedCount()) / static_cast<double>(cells.lattice().cellCount());
        EXPECT_GT(share, 0.1) << name;
        EXPECT_LT(share, 0.5) << name;
    }
    EXPECT_THROW(makeWorld("archipelago:many"), std::runtime_error);
    EXPECT_THROW(makeWorld("Atlantis"), std::runtime_error);
}

TEST(Course, RefusesAWrongCost)
{
    Course course(makeWorld("archipelago:1e4"), 3, 1);
    for (const int rings : {1, 2, 3})
    {
        const ContenderKind kind = kindOf(rings, Side::Ours, "ours");
        const double right = TextbookAStar(*course.world().occupancy, rings, false).solve(course.queries()[2]).cost;
        EXPECT_THROW(course.check(kind, 2, right * (1.0 - 1e-6)), std::runtime_error);
        EXPECT_NO_THROW(course.check(kind, 2, right));
        EXPECT_THROW(course.check(kind, 2, right * (1.0 + 1e-6)), std::runtime_error);
        EXPECT_THROW(course.check(kind, 2, std::numeric_limits<double>::infinity()), std::runtime_error);
        EXPECT_THROW(course.check(kind, 2, std::nan("")), std::runtime_error);
    }
}

TEST(Trial, SolvesEachQueryInEachPass)
{
    Course course(makeWorld("archipelago:1e4"), 3, 1);
    Trial trial(course, contenderNamed("astar_3"));
    EXPECT_GT(trial.pass(), 0.0);
    EXPECT_GT(trial.pass(), 0.0);
    ASSERT_EQ(trial.result().queryMs.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i)
    {
        EXPECT_TRUE(std::isfinite(trial.result().queryMs[i]));
        EXPECT_GT(trial.result().answers[i].cost, 0.0);
    }
    EXPECT_DOUBLE_EQ(trial.result().bitsPerIndex(), 2.0);
    EXPECT_GT(trial.result().bytesPerTouched(), 9.0);
}

TEST(Result, SumsUpItsQueries)
{
    Result result = resultOf("ours", Side::Ours, {1.0, 3.0, 8.0});
    for (Answer &answer : result.answers)
        answer = {1.0, 1000, 100, {16, 400}};
    EXPECT_DOUBLE_EQ(result.medianMs(), 3.0);
    EXPECT_DOUBLE_EQ(result.meanMs(), 4.0);
    EXPECT_DOUBLE_EQ(result.expanded(), 3000.0);
    EXPECT_DOUBLE_EQ(result.nsPerExpansion(), 4000.0);
    EXPECT_DOUBLE_EQ(result.bytesPerTouched(), 4.0);
    EXPECT_DOUBLE_EQ(result.bitsPerIndex(), 2.0);
    EXPECT_DOUBLE_EQ(medianOf({4.0, 1.0, 2.0, 3.0}), 2.5);
}

TEST(Verdicts, NameEveryLineThatNothingMeasured)
{
    std::stringstream text;
    printVerdicts({}, text);
    std::size_t lines = 0;
    for (std::string line; std::getline(text, line);)
        lines += line.find("not measured") != std::string::npos ? 1 : 0;
    EXPECT_EQ(lines, targets().size());
}

TEST(Verdicts, TakeTheMedianRatioOfTheFastestOfOurs)
{
    Measurements measured;
    measured.results = {
        resultOf("textbook_1", Side::Peer, {100.0, 200.0, 300.0}), resultOf("boost_1", Side::Peer, {0.1, 0.1, 0.1}),
        resultOf("slow", Side::Ours, {100.0, 100.0, 100.0}), resultOf("quick", Side::Ours, {1.0, 2.0, 30.0})};
    EXPECT_NE(lineOf(measured, "N, ring 1, times as fast as the textbook").find("met (quick)"), std::string::npos);
    EXPECT_NE(lineOf(measured, "N, ring 1, the stretch").find("missed (quick)"), std::string::npos);
    EXPECT_NE(lineOf(measured, "N, ring 1, times as fast as Boost").find("missed (quick)"), std::string::npos);
    EXPECT_NE(lineOf(measured, "N, ring 3, times as fast as the textbook of ring 3").find("not measured"),
              std::string::npos);
}

TEST(Verdicts, HoldOursAgainstGdal)
{
    Measurements measured;
    measured.noteLeast("fill/N/hexagons", 40.0);
    measured.noteLeast("fill/N/gdal", 100.0);
    EXPECT_NE(lineOf(measured, "N, filling").find("missed"), std::string::npos);
    measured.noteLeast("fill/N/hexagons", 20.0);
    measured.noteLeast("fill/N/gdal", 500.0);
    EXPECT_NE(lineOf(measured, "N, filling").find(" 0.2 "), std::string::npos);
    EXPECT_NE(lineOf(measured, "N, filling").find("  met"), std::string::npos);
}

TEST(Figures, AreReadAsTheyWereWritten)
{
    const std::string file = testing::TempDir() + "seahex_figures_test.json";
    const std::map<std::string, double> figures = {{"instructions/N/astar_1", 249.5}, {"behind/P", 0.0}};
    writeFigures(figures, file);
    EXPECT_EQ(readFigures(file), figures);
    std::ofstream(file) << "{\"instructions\": [1, 2]}";
    EXPECT_THROW(readFigures(file), std::runtime_error);
    std::ofstream(file) << "no JSON";
    EXPECT_THROW(readFigures(file), std::runtime_error);
    std::remove(file.c_str());
    EXPECT_TRUE(readFigures(file).empty());
    EXPECT_THROW(writeFigures(figures, testing::TempDir() + "no/such/folder.json"), std::runtime_error);

    Measurements measured;
    measured.figures = {{"instructions/N/astar_1", 249.0},
                        {"instructions/N/relaxed_1", 251.0},
                        {"instructions/N/boost_1", 1.0},
                        {"instructions/N/astar_3", 351.0}};
    EXPECT_NE(lineOf(measured, "N, ring 1, instructions").find("met (astar_1)"), std::string::npos);
    EXPECT_NE(lineOf(measured, "N, ring 3, instructions").find("missed (astar_3)"), std::string::npos);
}

TEST(Options, AreReadOrRefused)
{
    const Options options =
        readOptions({"--worlds=S,archipelago:1e5", "--queries=7", "--passes=2", "--seed=9", "--runs=4", "--limit=0.5"});
    EXPECT_EQ(options.worlds, (std::vector<std::string>{"S", "archipelago:1e5"}));
    EXPECT_EQ(options.queries, 7U);
    EXPECT_EQ(options.passes, 2);
    EXPECT_EQ(options.seed, 9U);
    EXPECT_EQ(options.runs, 4U);
    EXPECT_EQ(options.limitS, 0.5);
    for (const char *wrong : {"--worlds=", "--queries=0", "--queries=-3", "--passes=2x", "--seed", "--limit=0",
                              "--limit=nan", "--wolds=S", "S"})
        EXPECT_THROW(readOptions({wrong}), std::runtime_error) << wrong;
}

}  // namespace
}  // namespace seahex::contest
