// AStar on HeadingGraph with TurnWeight: few turns found, not hoped for.

#include <seahex/route/RouteMetrics.h>
#include <seahex/search/AStar.h>
#include <seahex/search/HeadingGraph.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/TurnWeight.h>

#include "search/RandomTurnCosts.h"
#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"
#include "support/Random.h"

#include <seahex/geometry/HexTraversal.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();
const auto never = []
{
    return false;
};

struct Problem
{
    std::shared_ptr<const HexOccupancy> occupancy;
    std::vector<GoalCell> starts;
    std::vector<GoalCell> goals;

    /// Up to two starts and goals in free cells, at random; none where no cell is free.
    static Problem random(Random &random)
    {
        const HexLattice lattice(Point(5.0, 7.0), 2.0, random.integer(1, 9), random.integer(1, 9));
        Problem problem{randomOccupancy(random, lattice, random.real(0.0, 0.45)), {}, {}};
        for (int i = 0; i < 20; ++i)
        {
            const HexCoord cell = random.cellOf(lattice);
            auto &terminals = random.chance(0.5) ? problem.starts : problem.goals;
            if (problem.occupancy->isFree(cell) && (terminals.empty() || (terminals.size() < 2 && random.chance(0.2))))
                terminals.push_back({cell, random.chance(0.5) ? 0.0 : random.real(0.0, 3.0)});
        }
        return problem;
    }

    static Problem of(const AsciiWorld &world)
    {
        return {world.shared(), {{world.cell('A'), 0}}, {{world.cell('B'), 0}}};
    }

    bool complete() const { return !starts.empty() && !goals.empty(); }
    const HexLattice &lattice() const { return occupancy->lattice(); }
    Point centre(const GoalCell &terminal) const { return lattice().centre(toCube(terminal.cell)); }
};

struct Method
{
    int rings = 3;
    TurnCosts turns;
    LengthMetric metric = LengthMetric::Euclidean;
    Guidance guidance = Guidance::Distance;
    JumpSet set = JumpSet::Primitive;

    std::string text() const
    {
        return "rings " + std::to_string(rings) + ", " + std::to_string(turns.perTurn) + " a turn, " +
               std::to_string(turns.perRadian) + " a radian" +
               (metric == LengthMetric::Lattice ? ", lattice, " : ", euclidean, ") + toString(guidance) +
               (set == JumpSet::All ? ", all jumps" : ", primitive jumps");
    }
};

Method randomMethod(Random &random)
{
    Method method;
    method.rings = static_cast<int>(random.integer(1, 3));
    method.turns = randomTurnCosts(random);
    method.metric = random.chance(0.2) ? LengthMetric::Lattice : LengthMetric::Euclidean;
    method.guidance = std::vector<Guidance>{Guidance::None, Guidance::Distance, Guidance::Distance,
                                            Guidance::TieBreak}[static_cast<std::size_t>(random.integer(0, 3))];
    method.set = random.chance(0.5) ? JumpSet::All : JumpSet::Primitive;
    return method;
}

/// A search and all that it stands on.
class Search
{
public:
    using Cells = JumpGraph<TurnWeight>;
    using Graph = HeadingGraph<Cells>;

    Search(const Problem &problem, const Method &method)
        : problem_(problem), jumps_(problem.occupancy->layout(), method.rings, method.set),
          graph_(Cells(*problem.occupancy, jumps_, problem.goals,
                       TurnWeight(problem.lattice(), jumps_, method.metric, method.turns, method.guidance,
                                  problem.centre(problem.starts.front()), problem.centre(problem.goals.front())))),
          search_(graph_)
    {
        addStarts();
        status_ = search_.run(never, 1000);
    }

    Search(const Search &) = delete;
    Search &operator=(const Search &) = delete;

    SearchStatus status() const { return status_; }
    double cost() const { return search_.cost(); }
    const SearchCounters &counters() const { return search_.counters(); }
    Graph &graph() { return graph_; }
    const HexJumps &jumps() const { return jumps_; }

    /// The cells of the path, each turn's own once.
    std::vector<HexCoord> path() const
    {
        std::vector<HexCoord> cells;
        for (const CellIndex state : search_.path())
        {
            const HexCoord cell = problem_.occupancy->layout().cell(graph_.cellOf(state));
            if (cells.empty() || cell != cells.back())
                cells.push_back(cell);
        }
        return cells;
    }

    /// The numbers by which routes are compared, of the path from centre to centre.
    RouteMetrics metrics() const
    {
        std::vector<Point> points;
        for (const HexCoord cell : path())
            points.push_back(problem_.lattice().centre(cell));
        return measureRoute(Route(points), *problem_.occupancy, CountedLegs::All);
    }

    /// What the path costs by its metrics, with what it costs to come to its first cell and to finish in its last.
    double costOfPath(const TurnCosts &turns) const
    {
        const auto ending = [](const std::vector<GoalCell> &terminals, HexCoord cell)
        {
            double least = infinity;
            for (const GoalCell &t : terminals)
                least = toCube(t.cell) == cell ? std::min(least, t.finish) : least;
            return least;
        };
        const RouteMetrics m = metrics();
        return ending(problem_.starts, path().front()) + m.lengthCells + m.turns * turns.perTurn +
               m.turnAngleRad * turns.perRadian + ending(problem_.goals, path().back());
    }

private:
    void addStarts()
    {
        for (const GoalCell &start : problem_.starts)
            search_.addStart(graph_.beginning(problem_.occupancy->layout().index(start.cell)), start.finish);
    }

    Problem problem_;
    HexJumps jumps_;
    Graph graph_;
    AStar<Graph> search_;
    SearchStatus status_;
};

/// The cells and the steps that lead to them, written out with the costs of turns: vertex cell * (steps + 1) + step,
/// the last where a path begins. It knows nothing of HexRing, HexJumps and TurnBound.
class StepGraph
{
public:
    StepGraph(const Problem &problem, const Method &method) : lattice_(problem.lattice())
    {
        for (std::int64_t q = -method.rings; q <= method.rings; ++q)
            for (std::int64_t s = -method.rings; s <= method.rings; ++s)
                if (const std::int64_t d = hexNorm(HexCoord{q, s}); d >= 1 && d <= method.rings)
                    steps_.push_back({q, s});
        graph_ = std::make_unique<ExplicitGraph>(static_cast<std::size_t>(lattice_.cellCount()) * (steps_.size() + 1));
        for (std::int64_t row = 0; row < lattice_.rows(); ++row)
            for (std::int64_t column = 0; column < lattice_.columns(); ++column)
                for (std::size_t k = 0; k < steps_.size(); ++k)
                    addStep(problem, method, toCube({column, row}), k);
    }

    double cheapest(const Problem &problem) const
    {
        std::vector<ExplicitGraph::Terminal> starts;
        for (const GoalCell &start : problem.starts)
            starts.emplace_back(vertex(toCube(start.cell), steps_.size()), start.finish);
        std::vector<ExplicitGraph::Terminal> goals;
        for (const GoalCell &goal : problem.goals)
            for (std::size_t k = 0; k <= steps_.size(); ++k)
                goals.emplace_back(vertex(toCube(goal.cell), k), goal.finish);
        return graph_->cheapest(starts, goals);
    }

private:
    std::size_t vertex(HexCoord cell, std::size_t step) const
    {
        return vertexOf(lattice_, cell) * (steps_.size() + 1) + step;
    }

    double course(std::size_t step) const
    {
        const Point way = lattice_.centre(steps_[step]) - lattice_.centre({0, 0});
        return std::atan2(way.y(), way.x());
    }

    void addStep(const Problem &problem, const Method &method, HexCoord from, std::size_t k)
    {
        const HexCoord to = from + steps_[k];
        if (!lattice_.contains(to) ||
            !forEachTouchedCell(from, to, [&](HexCoord cell) { return problem.occupancy->isFree(cell); }))
            return;
        const double length = method.metric == LengthMetric::Lattice
                                  ? static_cast<double>(hexNorm(steps_[k]))
                                  : (lattice_.centre(to) - lattice_.centre(from)).norm() / lattice_.pitch();
        for (std::size_t before = 0; before <= steps_.size(); ++before)
        {
            const double turned = before == steps_.size()
                                      ? 0.0
                                      : std::abs(std::remainder(course(k) - course(before), 2.0 * std::acos(-1)));
            const double cost = turned > leastTurnRad ? method.turns.perTurn + turned * method.turns.perRadian : 0.0;
            graph_->addEdge(vertex(from, before), vertex(to, k), length + cost);
        }
    }

    HexLattice lattice_;
    std::vector<HexCoord> steps_;
    std::unique_ptr<ExplicitGraph> graph_;
};

}  // namespace

TEST(TurnSearch, costsEqualDijkstrasOverCellsAndSteps)
{
    int reached = 0;
    int unreachable = 0;
    for (std::uint64_t seed = 1; seed <= 1500; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Problem problem = Problem::random(random);
        const Method method = randomMethod(random);
        SCOPED_TRACE(method.text());
        if (!problem.complete())
            continue;
        const double expected = StepGraph(problem, method).cheapest(problem);
        Search search(problem, method);
        if (std::isinf(expected))
        {
            ++unreachable;
            ASSERT_EQ(search.status(), SearchStatus::Exhausted);
            continue;
        }
        ++reached;
        ASSERT_EQ(search.status(), SearchStatus::Found) << toPicture(*problem.occupancy);
        ASSERT_NEAR(search.cost(), expected, 1e-9) << toPicture(*problem.occupancy, search.path());
        ASSERT_EQ(search.counters().reopened, 0u) << "the bound is consistent";
        if (method.metric == LengthMetric::Euclidean)
        {
            ASSERT_NEAR(search.costOfPath(method.turns), expected, 1e-9)
                << toPicture(*problem.occupancy, search.path());
        }
    }
    EXPECT_GE(reached, 800);
    EXPECT_GE(unreachable, 30);
}

TEST(TurnSearch, freeTurnsAreAPlainSearch)
{
    int found = 0;
    forEachSeed(400,
                [&](Random &random)
                {
                    const Problem problem = Problem::random(random);
                    Method method = randomMethod(random);
                    method.turns = {};
                    if (!problem.complete())
                        return;
                    const HexJumps jumps(problem.occupancy->layout(), method.rings, method.set);
                    JumpGraph<LengthWeight> graph(*problem.occupancy, jumps, problem.goals,
                                                  LengthWeight(problem.lattice(), jumps, method.metric, method.guidance,
                                                               problem.centre(problem.starts.front()),
                                                               problem.centre(problem.goals.front())));
                    AStar<JumpGraph<LengthWeight>> plain(graph);
                    for (const GoalCell &start : problem.starts)
                        plain.addStart(problem.occupancy->layout().index(start.cell), start.finish);
                    const SearchStatus status = plain.run(never, 1000);
                    Search search(problem, method);
                    EXPECT_EQ(search.status(), status);
                    if (status == SearchStatus::Found)
                    {
                        ++found;
                        EXPECT_NEAR(search.cost(), plain.cost(), 1e-9) << method.text();
                    }
                });
    EXPECT_GE(found, 200);
}

TEST(TurnSearch, theDearerTheTurnsTheFewer)
{
    // Of any two optima the one with the dearer turns has no more of them, and is no shorter.
    int fewer = 0;
    forEachSeed(1000,
                [&](Random &random)
                {
                    const Problem problem = Problem::random(random);
                    Method method = randomMethod(random);
                    method.metric = LengthMetric::Euclidean;
                    const bool byCount = random.chance(0.5);
                    if (!problem.complete())
                        return;
                    double lastTurns = infinity;
                    double lastLength = 0.0;
                    for (const double weight : {0.01, 0.3, 1.0, 4.0, 50.0})
                    {
                        method.turns = byCount ? TurnCosts{weight, 0.0} : TurnCosts{0.0, weight};
                        Search search(problem, method);
                        if (search.status() != SearchStatus::Found)
                            return;
                        const RouteMetrics m = search.metrics();
                        const double turns = byCount ? m.turns : m.turnAngleRad;
                        // starts and goals have prices of their own, which belong to the length here
                        const double length = search.cost() - weight * turns;
                        EXPECT_LE(turns, lastTurns + 1e-9) << method.text();
                        EXPECT_GE(length, lastLength - 1e-9) << method.text();
                        fewer += turns < lastTurns - 1e-9 && !std::isinf(lastTurns) ? 1 : 0;
                        lastTurns = turns;
                        lastLength = length;
                    }
                });
    EXPECT_GE(fewer, 50);
}

TEST(TurnSearch, twoTurnsWhereTheShortestWayWindsThroughRocks)
{
    const AsciiWorld world(R"(
         . . . . . . . . . . . . . . . . . .
        . . . . . . . . . . . . . . . . . .
         . . . . . # . . . # . . . # . . . .
        . . . . . # . . . # . . . # . . . .
         . . . . . # . . . # . . . # . . . .
        . . . . . # . . . # . . . # . . . .
         A . . . . # . . . # . . . # . . . B
        . . . . . . . # . . . # . . . . . .
         . . . . . . . # . . . # . . . . . .
        . . . . . # # # # # # # # # . . . .
    )");
    for (const int rings : {1, 2, 3})
    {
        SCOPED_TRACE(rings);
        Search winding(Problem::of(world), {rings, {0.001, 0.0}});
        Search few(Problem::of(world), {rings, {50.0, 0.0}});
        EXPECT_EQ(few.metrics().turns, 2) << toPicture(world.occupancy(), few.path());
        EXPECT_GT(winding.metrics().turns, 2) << toPicture(world.occupancy(), winding.path());
        EXPECT_GT(few.metrics().lengthCells, winding.metrics().lengthCells);
    }
}

TEST(TurnSearch, aStartThatIsAGoalNeedsNoTurn)
{
    const AsciiWorld world(R"(
         A . B
    )");
    Problem problem = Problem::of(world);
    problem.starts[0].finish = 0.4;
    problem.goals = {{world.cell('A'), 0.5}, {world.cell('B'), 0.1}};
    Search search(problem, {3, {5.0, 5.0}});
    EXPECT_DOUBLE_EQ(search.cost(), 0.9);
    EXPECT_EQ(search.path(), std::vector<HexCoord>{world.cell('A')});
}
