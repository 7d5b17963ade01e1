#include "WangStudy.h"

#include "Figures.h"
#include "Measured.h"
#include "common/Arena.h"
#include "common/Failure.h"
#include "common/OwnFiles.h"

#include <seahex/io/GeoRoute.h>
#include <seahex/io/PositionParser.h>
#include <seahex/route/RouteSmoother.h>

#include <cmath>

namespace reproduce_papers
{
namespace
{

using seahex::Guidance;
using seahex::Point;
using seahex::Route;

constexpr double edgeDeg = 0.005;  // of a square

/// A window on a chart, and the ends of the route. The paper doesn't tell its own.
struct Window
{
    const char *id;
    const char *chart;
    double westDeg;
    double southDeg;
    double eastDeg;
    double northDeg;
    const char *from;  // centres of squares
    const char *to;
    bool isPublished;  // table 1 is of this window
};

constexpr Window sanya{"sanya", "sanya.000", 109.35, 18.10, 109.85, 18.40, "18.2775,109.3825", "18.3775,109.8325",
                       true};
constexpr Window shangchuan{"shangchuan",       "shangchuan.000",   112.50, 21.50, 113.00, 21.98,
                            "21.6325,112.5225", "21.6675,112.9025", false};

/// Table 1: Dijkstra, A*, improved A*.
constexpr double publishedTable[5][3] = {
    {35.48, 35.52, 34.25}, {97, 97, 11}, {3186, 1806, 2127}, {32, 26, 0}, {13, 31, 6}};

class WangExperiment
{
public:
    explicit WangExperiment(const Window &window)
        : window_(window), arena_(makeArena(window)), sea_(*arena_, hexagonsOver(window), squaresOver(window)),
          start_(arena_->projection().forward(seahex::parsePosition(window.from))),
          goal_(arena_->projection().forward(seahex::parsePosition(window.to)))
    {
    }

    Study run()
    {
        Study study;
        study.tables = {table(Cells::Squares), table(Cells::Hexagons)};
        const std::string figure = std::string("wang2017_") + window_.id + "_figure3";
        addFigure(study, figure + "a", "Improved A*, squares", improved(Cells::Squares), true);
        addFigure(study, figure + "b", "A*, squares", plain(Cells::Squares, Guidance::Euclidean), false);
        addFigure(study, figure + "c", "Dijkstra, squares", plain(Cells::Squares, Guidance::None), false);
        addFigure(study, figure + "_hexagons", "Improved A*, hexagons", improved(Cells::Hexagons), true);
        return study;
    }

private:
    static std::shared_ptr<const seahex::ChartArena> makeArena(const Window &window)
    {
        const auto chart = demos::readChart({demos::ownChart(window.chart)});
        seahex::ArenaOptions options;
        options.projection = seahex::Projection::plateCarree();
        options.scope = seahex::HazardScope::LandOnly;
        options.lattice = hexagonsOver(window);
        return demos::makeArena(*chart, options);
    }

    static seahex::SquareLattice squaresOver(const Window &window)
    {
        return {Point(window.westDeg, window.northDeg), edgeDeg,
                std::llround((window.eastDeg - window.westDeg) / edgeDeg),
                std::llround((window.northDeg - window.southDeg) / edgeDeg)};
    }

    /// Hexagons of the same width that lie within the window.
    static seahex::HexLattice hexagonsOver(const Window &window)
    {
        const double side = edgeDeg / std::sqrt(3.0);
        return {Point(window.westDeg, window.northDeg), edgeDeg,
                std::llround((window.eastDeg - window.westDeg) / edgeDeg - 0.5),
                static_cast<std::int64_t>(((window.northDeg - window.southDeg) / side - 0.5) / 1.5)};
    }

    static Method on(Cells cells) { return cells == Cells::Hexagons ? hexagons(1) : squares(cells); }
    static Method plain(Cells cells, Guidance guidance) { return with(on(cells), guidance); }
    static Method improved(Cells cells) { return with(with(on(cells), Cost::Sailing), Guidance::Wang); }

    Answer solve(const Method &method) const
    {
        const auto answer = sea_.plan(method, start_, goal_, true);
        if (!answer)
            throw demos::Failure(demos::Exit::NoRoute, std::string("no route in the window of ") + window_.id);
        return *answer;
    }

    double miles(const Route &route) const
    {
        seahex::GeoRoute written;
        for (const Point &p : route.waypoints())
            written.waypoints.push_back(arena_->projection().inverse(p));
        return seahex::rhumbLengthM(written) / 1852.0;
    }

    void push(Table &table, const std::string &column, const Route &route, const Measured &measured,
              const Answer &answer) const
    {
        const double values[] = {
            miles(route), static_cast<double>(measured.nodes), static_cast<double>(answer.counters.expanded),
            static_cast<double>(measured.metrics.potentialHazards), static_cast<double>(measured.metrics.turns)};
        table.columns.push_back(column);
        for (std::size_t i = 0; i < table.rows.size(); ++i)
            table.rows[i].values.emplace_back(values[i]);
    }

    void pushPublished(Table &table, const std::string &column, int method) const
    {
        if (!window_.isPublished)
            return;
        table.columns.push_back(column);
        for (std::size_t i = 0; i < table.rows.size(); ++i)
            table.rows[i].values.emplace_back(publishedTable[i][method]);
    }

    Table table(Cells cells) const
    {
        const bool onSquares = cells == Cells::Squares;
        Table table;
        table.id = std::string("wang2017_table1_") + window_.id + (onSquares ? "_squares" : "_hexagons");
        table.title = std::string("[Wang2017] table 1, window of ") + window_.id + ", " +
                      (onSquares ? "squares, 8 neighbours" : "its counterpart on hexagons, 6 neighbours") + ": " +
                      window_.from + " to " + window_.to;
        table.rows = {{"sailing distance, NM", {}, 2},
                      {"route nodes", {}, 0},
                      {"nodes traversed", {}, 0},
                      {"potential hazards", {}, 0},
                      {"turns", {}, 0}};
        const Answer dijkstra = solve(plain(cells, Guidance::None));
        const Answer aStar = solve(plain(cells, Guidance::Euclidean));
        const Answer weighted = solve(improved(cells));
        const auto pushPath = [&](const std::string &column, const Answer &answer)
        {
            push(table, column, answer.path, measurePath(sea_, cells, answer.path), answer);
        };
        const auto pushSmoothed = [&](const std::string &column, const Route &route)
        {
            push(table, column, route, measureSmoothed(sea_, cells, route), weighted);
        };
        if (onSquares)
            pushPublished(table, "Dijkstra published", 0);
        pushPath("Dijkstra", dijkstra);
        if (onSquares)
            pushPublished(table, "A* published", 1);
        pushPath("A*", aStar);
        if (onSquares)
            pushPublished(table, "improved A* published", 2);
        pushPath("improved, not smoothed", weighted);
        pushSmoothed("improved, smoothed as text", smoothedAsPublished(sea_, cells, weighted.path));
        pushSmoothed("improved, with margin", smoothedWithMargin(sea_, cells, weighted.path));
        pushSmoothed("improved, string pulled", seahex::pullString(weighted.path, sea_.occupancy(cells)));
        table.note =
            "Improved: safety weight and pilot quantity. With margin: smoothing keeps a cell off blocked cells, as "
            "the authors' program does.\nString pulled: this project's smoothing, which looks at length alone.";
        return table;
    }

    void addFigure(Study &study, const std::string &name, const std::string &title, const Method &method,
                   bool isSmoothed) const
    {
        const Answer answer = solve(method);
        std::optional<Route> smoothed;
        if (isSmoothed)
            smoothed = smoothedWithMargin(sea_, method.cells, answer.path);
        const Route &route = smoothed ? *smoothed : answer.path;
        char numbers[160];
        std::snprintf(numbers, sizeof numbers, "\n[Wang2017], window of %s: %.2f NM, %zu nodes, %llu cells expanded",
                      window_.id, miles(route), route.waypoints().size(),
                      static_cast<unsigned long long>(answer.counters.expanded));
        study.figures.push_back(makeFigure(name, title + numbers, sea_, method.cells, arena_, answer, smoothed));
    }

    Window window_;
    std::shared_ptr<const seahex::ChartArena> arena_;
    Sea sea_;
    Point start_;
    Point goal_;
};

}  // namespace

Study wangStudy()
{
    Study study = WangExperiment(sanya).run();
    Study other = WangExperiment(shangchuan).run();
    study.tables.insert(study.tables.end(), other.tables.begin(), other.tables.end());
    study.figures.insert(study.figures.end(), other.figures.begin(), other.figures.end());
    return study;
}

}  // namespace reproduce_papers
