#include "ChengStudy.h"

#include "Figures.h"
#include "Measured.h"
#include "common/Arena.h"
#include "common/ChengScenario.h"
#include "common/Failure.h"
#include "common/OwnFiles.h"

#include <seahex/io/PositionParser.h>
#include <seahex/route/TurnComparison.h>
#include <seahex/search/HexJumps.h>

#include <algorithm>
#include <cmath>

namespace reproduce_papers
{
namespace
{

using seahex::Guidance;
using seahex::JumpRule;
using seahex::Point;
namespace published = demos::cheng2020;

/// The figures of the paper's tables 2 and 3, for one column.
struct Column
{
    double length;
    double turns;
    double angleDeg;
    double seconds;
};
constexpr Column hex6{146, 26, 1620, 1.40};
constexpr Column square8{142.74, 24, 1080, 2.79};
constexpr Column hex18{145, 14, 480, 2.57};
constexpr Column hex36{144, 12, 435, 4.62};
constexpr double fewerNodesPercent = 27.93;

class ChengExperiment
{
public:
    ChengExperiment()
        : arena_(makeArena()), sea_(*arena_, published::lattice(0.0), squareLattice()),
          start_(arena_->projection().forward(seahex::parsePosition(published::from))),
          goal_(arena_->projection().forward(seahex::parsePosition(published::to)))
    {
    }

    Study run()
    {
        Study study;
        study.tables = {tableTwo(), tableThree(), fewestTurns(), guides()};
        addFigure(study, "cheng2020_figure3", "Squares, 8 neighbours", asPublished(squares()));
        addFigure(study, "cheng2020_figure4", "Hexagons, 6 neighbours", asPublished(hexagons(1)));
        addFigure(study, "cheng2020_figure5", "Hexagons, 18 neighbours", asPublished(hexagons(2)));
        addFigure(study, "cheng2020_figure6", "Hexagons, 36 neighbours", asPublished(hexagons(3)));
        return study;
    }

private:
    static std::shared_ptr<const seahex::ChartArena> makeArena()
    {
        const auto chart = demos::readChart({demos::ownChart(published::chart)});
        seahex::ArenaOptions options;
        options.projection = seahex::Projection::plateCarree();
        options.scope = seahex::HazardScope::LandOnly;
        options.lattice = published::lattice(0.0);
        return demos::makeArena(*chart, options);
    }

    /// Squares as wide as the hexagons over the same window: the paper's, in whose rows and columns its ends lie.
    static seahex::SquareLattice squareLattice()
    {
        const seahex::HexLattice hexagons = published::lattice(0.0);
        const double rows = std::ceil(published::rows * 1.5 * hexagons.side() / hexagons.pitch());
        return {hexagons.northWest(), hexagons.pitch(), published::columns, static_cast<std::int64_t>(rows)};
    }

    /// g is a sum of steps (eq. 9), and the heuristic is that of eq. 10.
    static Method asPublished(const Method &method) { return with(with(method, Cost::Steps), Guidance::Cheng); }

    struct Result
    {
        Answer answer;
        Measured measured;
    };

    /// Times are medians of a few runs.
    Result solve(const Method &method) const
    {
        constexpr int runs = 5;
        Result result;
        std::vector<double> times;
        for (int i = 0; i < runs; ++i)
        {
            const auto answer = sea_.plan(method, start_, goal_, true);
            if (!answer)
                throw demos::Failure(demos::Exit::NoRoute, "the published scenario has no route on this chart");
            result.answer = *answer;
            times.push_back(answer->searchMs);
        }
        std::sort(times.begin(), times.end());
        result.answer.searchMs = times[runs / 2];
        result.measured = measurePath(sea_, method.cells, result.answer.path);
        return result;
    }

    void addFigure(Study &study, const std::string &name, const std::string &title, const Method &method) const
    {
        const Result result = solve(method);
        char numbers[160];
        std::snprintf(numbers, sizeof numbers, "length %.2f, %d turns of %.0f degrees, %llu cells expanded",
                      result.measured.stepsW, result.measured.metrics.turns, result.measured.metrics.turnAngleDeg(),
                      static_cast<unsigned long long>(result.answer.counters.expanded));
        study.figures.push_back(makeFigure(name, title + "\n[Cheng2020] scenario, as published: " + numbers, sea_,
                                           method.cells, arena_, result.answer));
    }

    /// A table that is filled column by column.
    class Columns
    {
    public:
        explicit Columns(Table &table) : table_(table)
        {
            table_.rows = {
                {"length, steps of the lattice", {}, 2}, {"length, straight", {}, 2}, {"turns", {}, 0},
                {"turn angles, degrees", {}, 0},         {"search, ms", {}, 2},       {"cells expanded", {}, 0}};
        }

        void add(const std::string &name, const Column &column)
        {
            push(name, {column.length, {}, column.turns, column.angleDeg, 1000.0 * column.seconds, {}});
        }
        void add(const std::string &name, const Result &result)
        {
            const Measured &m = result.measured;
            push(name, {m.stepsW, m.lengthW, m.metrics.turns, m.metrics.turnAngleDeg(), result.answer.searchMs,
                        static_cast<double>(result.answer.counters.expanded)});
        }

    private:
        void push(const std::string &name, const std::vector<std::optional<double>> &values)
        {
            table_.columns.push_back(name);
            for (std::size_t i = 0; i < values.size(); ++i)
                table_.rows[i].values.push_back(values[i]);
        }

        Table &table_;
    };

    Table tableTwo() const
    {
        Table table;
        table.id = "cheng2020_table2";
        table.title = "[Cheng2020] table 2: hexagons against squares (lengths in widths of a hexagon)";
        Columns columns(table);
        const Result hexagon = solve(asPublished(hexagons(1)));
        const Result square = solve(asPublished(squares()));
        columns.add("hex 6 published", hex6);
        columns.add("hex 6", hexagon);
        columns.add("square 8 published", square8);
        columns.add("square 8 equal spacing", square);
        columns.add("square 8 equal area", solve(asPublished(squares(Cells::SquaresOfArea))));
        columns.add("equal spacing corners cut", solve(with(asPublished(squares()), JumpRule::Hopping)));
        const double fewer = 100.0 * (1.0 - static_cast<double>(hexagon.answer.counters.expanded) /
                                                static_cast<double>(square.answer.counters.expanded));
        table.rows.push_back({"fewer cells than squares, %", {fewerNodesPercent, fewer, {}, {}, {}, {}}, 1});
        char note[400];
        std::snprintf(note, sizeof note,
                      "Equal spacing: squares of edge %.7f degrees, the hexagons' width, %.1f %% larger than these.\n"
                      "Equal area: squares of edge %.7f degrees. Times of the paper are of its authors' machine.",
                      published::publishedPitchDeg(), 100.0 * (2.0 / std::sqrt(3.0) - 1.0),
                      edgeOfEqualArea(published::publishedPitchDeg()));
        table.note = note;
        return table;
    }

    Table tableThree() const
    {
        Table table;
        table.id = "cheng2020_table3";
        table.title = "[Cheng2020] table 3: more neighbours (lengths in widths of a hexagon)";
        Columns columns(table);
        const std::pair<const char *, Column> rings[] = {{"6", hex6}, {"18", hex18}, {"36", hex36}};
        for (int ring = 1; ring <= 3; ++ring)
        {
            const auto &[name, column] = rings[ring - 1];
            columns.add(std::string(name) + " published", column);
            columns.add(std::string(name) + " safe jumps", solve(asPublished(hexagons(ring))));
            if (ring > 1)
                columns.add(std::string(name) + " hopping jumps",
                            solve(with(asPublished(hexagons(ring)), JumpRule::Hopping)));
            columns.add(std::string(name) + " straight lengths", solve(hexagons(ring)));
        }
        table.note =
            "Safe and hopping: g is a sum of steps and the guide is the paper's. Hopping jumps pass over blocked "
            "cells.\nStraight lengths: safe jumps that cost their length, and the exact bound as the guide.";
        return table;
    }

    /// What table 3 hopes for, found: the fewest turns for a given length, from centre to centre.
    Table fewestTurns() const
    {
        Table table;
        table.id = "cheng2020_turns";
        table.title = "Turns found, not hoped for: hexagons, straight lengths, from centre to centre";
        table.rows = {{"length", {}, 2},
                      {"turns", {}, 0},
                      {"turn angles, degrees", {}, 0},
                      {"cells and headings expanded", {}, 0}};
        const seahex::Occupancy &occupancy = sea_.occupancy(Cells::Hexagons);
        const auto cellOf = [&occupancy](const Point &p)
        {
            return occupancy.lattice().cellAt(p);
        };
        for (int rings = 1; rings <= 3; ++rings)
        {
            const seahex::HexJumps jumps(occupancy.layout(), rings, seahex::JumpSet::All);
            const auto comparison =
                seahex::compareTurns(occupancy, jumps, cellOf(start_), cellOf(goal_), {0.0, 0.01, 0.02});
            const auto add = [&](const std::string &name, const seahex::MeasuredPath &path)
            {
                table.columns.push_back(std::to_string(3 * rings * (rings + 1)) + " " + name);
                const double values[] = {path.lengthCells, static_cast<double>(path.turns),
                                         path.turnAngleRad * 180.0 / M_PI, static_cast<double>(path.expanded)};
                for (std::size_t i = 0; i < table.rows.size(); ++i)
                    table.rows[i].values.emplace_back(values[i]);
            };
            if (!comparison)
                throw demos::Failure(demos::Exit::NoRoute, "the published scenario has no route on this chart");
            add("rings alone", comparison->plain);
            add("as short", comparison->fewest[0]);
            add("+1 %", comparison->fewest[1]);
            add("+2 %", comparison->fewest[2]);
        }
        table.note =
            "The fewest turns of paths that are no longer than the shortest by more than so much, at some price per "
            "turn.";
        return table;
    }

    Table guides() const
    {
        Table table;
        table.id = "cheng2020_guides";
        table.title = "[Cheng2020] guides: cells expanded for straight lengths, and how long the path is";
        table.columns = {"hex 6 expanded",  "length",   "hex 18 expanded",   "length ",
                         "hex 36 expanded", "length  ", "square 8 expanded", "length   "};
        for (const Guidance guidance : {Guidance::None, Guidance::Cheng, Guidance::Wang, Guidance::Euclidean,
                                        Guidance::Distance, Guidance::TieBreak, Guidance::Relaxed})
        {
            Table::Row row{seahex::toString(guidance), {}, 2};
            for (const Method &method : {hexagons(1), hexagons(2), hexagons(3), squares()})
            {
                const Result result = solve(with(method, guidance));
                row.values.emplace_back(static_cast<double>(result.answer.counters.expanded));
                row.values.emplace_back(result.measured.lengthW);
            }
            table.rows.push_back(row);
        }
        table.decimals = {0, {}, 0, {}, 0, {}, 0, {}};
        table.note =
            "none is Dijkstra's algorithm; all but cheng on 18 and 36 neighbours are sure of the shortest path.";
        return table;
    }

    std::shared_ptr<const seahex::ChartArena> arena_;
    Sea sea_;
    Point start_;
    Point goal_;
};

}  // namespace

Study chengStudy()
{
    return ChengExperiment().run();
}

}  // namespace reproduce_papers
