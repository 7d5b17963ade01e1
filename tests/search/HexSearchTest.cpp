// AStar and JumpGraph together: the search as the planner runs it.

#include <seahex/search/AStar.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/LengthWeight.h>

#include "support/AsciiWorld.h"
#include "support/ExplicitGraph.h"
#include "support/HexOracle.h"
#include "support/Random.h"

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

/// What is searched: starts and goals with what it costs to come and to finish there.
struct Problem
{
    std::shared_ptr<const HexOccupancy> occupancy;
    std::vector<GoalCell> starts;
    std::vector<GoalCell> goals;

    /// Up to three starts and goals in free cells, at random; none where no cell is free.
    static Problem random(Random &random)
    {
        const HexLattice lattice(Point(5.0, 7.0), 2.0, random.integer(1, 12), random.integer(1, 12));
        Problem problem{randomOccupancy(random, lattice, random.real(0.0, 0.5)), {}, {}};
        for (int i = 0; i < 20; ++i)
        {
            const HexCoord cell = random.cellOf(lattice);
            auto &terminals = random.chance(0.5) ? problem.starts : problem.goals;
            if (problem.occupancy->isFree(cell) && (terminals.empty() || (terminals.size() < 3 && random.chance(0.2))))
                terminals.push_back({cell, random.chance(0.5) ? 0.0 : random.real(0.0, 3.0)});
        }
        return problem;
    }

    /// From north to south or west to east through a wide water full of islands.
    static Problem amongIslands(Random &random)
    {
        const HexLattice lattice(Point::Zero(), 1.0, 120, 140);
        const HexCoord start = random.chance(0.5) ? toCube({60, 4}) : toCube({4, 70});
        const HexCoord goal = start == toCube({60, 4}) ? toCube({60, 135}) : toCube({115, 70});
        std::vector<HexCoord> islands;
        for (int i = 0; i < 14; ++i)
        {
            const HexCoord middle = random.cellOf(lattice);
            const double radius = random.real(3.0, 16.0);
            forEachCell(lattice, 0,
                        [&](HexCoord cell)
                        {
                            if ((lattice.centre(cell) - lattice.centre(middle)).norm() < radius &&
                                hexDistance(cell, start) > 2 && hexDistance(cell, goal) > 2)
                                islands.push_back(cell);
                        });
        }
        return {occupancyWith(lattice, islands), {{start, 0.0}}, {{goal, 0.0}}};
    }

    static Problem of(const AsciiWorld &world)
    {
        return {world.shared(), {{world.cell('A'), 0}}, {{world.cell('B'), 0}}};
    }

    bool complete() const { return !starts.empty() && !goals.empty(); }

    double cheapest(int rings, LengthMetric metric) const
    {
        const auto vertices = [this](const std::vector<GoalCell> &cells)
        {
            std::vector<ExplicitGraph::Terminal> terminals;
            for (const GoalCell &c : cells)
                terminals.emplace_back(vertexOf(occupancy->lattice(), toCube(c.cell)), c.finish);
            return terminals;
        };
        return jumpGraph(*occupancy, rings, metric).cheapest(vertices(starts), vertices(goals));
    }
};

/// How it is searched.
struct Method
{
    int rings = 3;
    LengthMetric metric = LengthMetric::Euclidean;
    Guidance guidance = Guidance::Distance;
    JumpSet set = JumpSet::Primitive;

    /// With Euclidean costs the published heuristic overestimates on rings 2 and 3.
    bool isOptimal() const { return guidance != Guidance::Cheng || metric == LengthMetric::Lattice || rings == 1; }

    std::string text() const
    {
        return "rings " + std::to_string(rings) + (metric == LengthMetric::Lattice ? ", lattice, " : ", euclidean, ") +
               toString(guidance) + (set == JumpSet::All ? ", all jumps" : ", primitive jumps");
    }
};

std::vector<Method> allMethods()
{
    std::vector<Method> methods;
    for (const int rings : {1, 2, 3})
        for (const LengthMetric metric : {LengthMetric::Euclidean, LengthMetric::Lattice})
            for (const Guidance guidance :
                 {Guidance::None, Guidance::Distance, Guidance::Cheng, Guidance::TieBreak, Guidance::Relaxed})
                for (const JumpSet set : {JumpSet::Primitive, JumpSet::All})
                    methods.push_back({rings, metric, guidance, set});
    return methods;
}

std::size_t turnsOf(const std::vector<HexCoord> &cells)
{
    std::size_t turns = 0;
    for (std::size_t i = 2; i < cells.size(); ++i)
        turns += cells[i] - cells[i - 1] != cells[i - 1] - cells[i - 2] ? 1 : 0;
    return turns;
}

/// A search and all that it stands on.
class Search
{
public:
    Search(const Problem &problem, const Method &method)
        : problem_(problem), jumps_(problem.occupancy->layout(), method.rings, method.set),
          graph_(*problem.occupancy, jumps_, problem.goals, weightOf(problem, method)), search_(graph_)
    {
        search_.setTrace(&trace_);
        addStarts();
    }

    Search(const Search &) = delete;
    Search &operator=(const Search &) = delete;

    void addStarts()
    {
        for (const GoalCell &start : problem_.starts)
            search_.addStart(problem_.occupancy->layout().index(start.cell), start.finish);
    }

    AStar<JumpGraph<LengthWeight>> &operator*() { return search_; }
    AStar<JumpGraph<LengthWeight>> *operator->() { return &search_; }
    std::vector<CellIndex> &trace() { return trace_; }

    std::vector<HexCoord> path() const
    {
        std::vector<HexCoord> cells;
        for (const CellIndex index : search_.path())
            cells.push_back(problem_.occupancy->layout().cell(index));
        return cells;
    }

    /// What is wrong with the path; empty if it leads from a start to a goal by valid jumps and costs what is said.
    std::string judgePath() const
    {
        const std::vector<HexCoord> cells = path();
        const auto costAt = [](const std::vector<GoalCell> &terminals, HexCoord cell)
        {
            double cost = infinity;
            for (const GoalCell &t : terminals)
                cost = t.cell == toOffset(cell) ? std::min(cost, t.finish) : cost;
            return cost;
        };
        if (cells.empty())
            return "no path";
        double sum = costAt(problem_.starts, cells.front()) + costAt(problem_.goals, cells.back());
        for (std::size_t i = 1; i < cells.size(); ++i)
        {
            const HexCoord offset = cells[i] - cells[i - 1];
            std::size_t jump = 0;
            while (jump < jumps_.size() && jumps_.offset(jump).offset != offset)
                ++jump;
            if (jump == jumps_.size())
                return "a step that is no jump";
            sum += graph_.jumpCost(0, 0, jump, 255);
            bool free = true;
            forEachCell(problem_.occupancy->lattice(), 3,
                        [&](HexCoord cell) {
                            free = free && (problem_.occupancy->isFree(cell) ||
                                            !touchesExactly<std::int64_t>(cells[i - 1], cells[i], cell));
                        });
            if (!free)
                return "a jump touches a blocked cell";
        }
        return std::abs(sum - search_.cost()) < 1e-9 ? "" : "the path's jumps cost " + std::to_string(sum);
    }

private:
    LengthWeight weightOf(const Problem &problem, const Method &method) const
    {
        const HexLattice &lattice = problem.occupancy->lattice();
        LengthWeight weight(lattice, jumps_, method.metric, method.guidance,
                            lattice.centre(toCube(problem.starts.front().cell)),
                            lattice.centre(toCube(problem.goals.front().cell)));
        if (problem.goals.size() == 1)
            weight.setOccupancy(problem.occupancy);
        return weight;
    }

    Problem problem_;
    HexJumps jumps_;
    JumpGraph<LengthWeight> graph_;
    AStar<JumpGraph<LengthWeight>> search_;
    std::vector<CellIndex> trace_;
};

}  // namespace

TEST(HexSearch, costsEqualDijkstrasForEveryMethod)
{
    int reached = 0;
    int unreachable = 0;
    for (std::uint64_t seed = 1; seed <= 3000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Problem problem = Problem::random(random);
        if (!problem.complete())
            continue;
        double expected = infinity;
        for (const Method &method : allMethods())
        {
            SCOPED_TRACE(method.text());
            if (method.guidance == Guidance::None && method.set == JumpSet::Primitive)
                expected = problem.cheapest(method.rings, method.metric);
            Search search(problem, method);
            const SearchStatus status = search->run(never, 1000);
            ASSERT_EQ(search.trace().size(), search->counters().expanded);
            if (method.guidance == Guidance::Relaxed)
            {
                ASSERT_EQ(search->counters().reopened, 0u) << "not even where the goal can't be reached";
            }
            if (std::isinf(expected))
            {
                ASSERT_EQ(status, SearchStatus::Exhausted);
                ASSERT_FALSE(search->hasPath());
                ASSERT_TRUE(search.path().empty());
                ASSERT_EQ(search->cost(), infinity);
                continue;
            }
            ASSERT_EQ(status, SearchStatus::Found) << toPicture(*problem.occupancy);
            ASSERT_EQ(search.judgePath(), "") << toPicture(*problem.occupancy, search.path());
            // where D p overestimates what remains, then by no more than D does: 2 / root 3
            const double excess = method.isOptimal() ? 1.0 : 2.0 / std::sqrt(3.0);
            ASSERT_GE(search->cost(), expected - 1e-9) << toPicture(*problem.occupancy, search.path());
            ASSERT_LE(search->cost(), excess * expected + 1e-9) << toPicture(*problem.occupancy, search.path());
        }
        (std::isinf(expected) ? unreachable : reached) += 1;
    }
    EXPECT_GE(reached, 1000) << "so many lattices at least";
    EXPECT_GE(unreachable, 50);
}

TEST(HexSearch, unreachableGoalsExhaustTheSearch)
{
    const AsciiWorld world(R"(
         A . # . . .
        . . # . . .
         . . # . B .
        . . # . . .
         . . # . . .
    )");
    for (const Method &method : allMethods())
    {
        SCOPED_TRACE(method.text());
        Search search(Problem::of(world), method);
        EXPECT_EQ(search->run(never, 1), SearchStatus::Exhausted);
        EXPECT_FALSE(search->hasPath());
        // every cell on this side of the reef, once
        std::vector<CellIndex> cells = search.trace();
        std::sort(cells.begin(), cells.end());
        EXPECT_EQ(std::unique(cells.begin(), cells.end()) - cells.begin(), 10);
        EXPECT_EQ(search->counters().generated, 10u);
    }
}

TEST(HexSearch, theWayThroughAGap)
{
    const AsciiWorld world(R"(
         . . . # . . .
        . . . # . . .
         A . . # . . B
        . . . # . . .
         . . . . . . .
    )");
    Search search(Problem::of(world), {1, LengthMetric::Lattice, Guidance::Distance, JumpSet::Primitive});
    EXPECT_EQ(search->run(never, 1), SearchStatus::Found);
    EXPECT_EQ(search->cost(), 8.0);
    EXPECT_EQ(search.judgePath(), "");
    const std::vector<HexCoord> path = search.path();
    EXPECT_EQ(std::count(path.begin(), path.end(), toCube({3, 4})), 1) << toPicture(world.occupancy(), path);
    // the second ring cannot hop through the reef either
    Search jumping(Problem::of(world), {2, LengthMetric::Lattice, Guidance::Distance, JumpSet::All});
    EXPECT_EQ(jumping->run(never, 1), SearchStatus::Found);
    EXPECT_EQ(jumping->cost(), 8.0);
}

TEST(HexSearch, startThatIsAGoal)
{
    const AsciiWorld world(R"(
         A . B
    )");
    Problem problem = Problem::of(world);
    problem.starts[0].finish = 0.4;
    problem.goals = {{world.cell('A'), 0.5}, {world.cell('B'), 0.1}};
    Search search(problem, {});
    EXPECT_EQ(search->run(never, 1), SearchStatus::Found);
    EXPECT_DOUBLE_EQ(search->cost(), 0.9);
    EXPECT_EQ(search.path(), std::vector<HexCoord>{world.cell('A')});
}

TEST(HexSearch, aDearFinishIsWeighedAgainstAFartherGoal)
{
    const AsciiWorld world(R"(
         C A . . B
    )");
    Problem problem = Problem::of(world);
    for (const double finish : {2.5, 1.5})
    {
        problem.goals = {{world.cell('C'), finish}, {world.cell('B'), 0.0}};
        Search search(problem, {});
        EXPECT_EQ(search->run(never, 1), SearchStatus::Found);
        EXPECT_DOUBLE_EQ(search->cost(), std::min(finish + 1.0, 3.0));
        EXPECT_EQ(search.path().back(), finish > 2.0 ? world.cell('B') : world.cell('C'));
    }
}

TEST(HexSearch, interruptedRunsFindTheSame)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Problem problem = Problem::random(random);
        if (!problem.complete())
            continue;
        const std::vector<Method> methods = allMethods();
        const Method method = methods[seed % methods.size()];
        Search whole(problem, method);
        const SearchStatus status = whole->run(never, 1);

        Search inParts(problem, method);
        const auto interval = static_cast<std::uint64_t>(random.integer(1, 5));
        const std::int64_t polls = random.integer(1, 4);
        SearchStatus last = SearchStatus::Stopped;
        int runs = 0;
        for (; last == SearchStatus::Stopped; ++runs)
        {
            ASSERT_LT(runs, 10000);
            std::int64_t left = polls;
            last = inParts->run([&left] { return left-- == 0; }, interval);
        }
        EXPECT_EQ(last, status);
        EXPECT_EQ(inParts->cost(), whole->cost());
        EXPECT_EQ(inParts.path(), whole.path());
        EXPECT_EQ(inParts.trace(), whole.trace());
        EXPECT_EQ(inParts->counters().generated, whole->counters().generated);
        EXPECT_EQ(inParts->counters().improved, whole->counters().improved);
    }
}

TEST(HexSearch, stopIsAskedBeforeTheFirstExpansionAndAtTheInterval)
{
    const AsciiWorld world(R"(
         A . . . . .
        . . . . . .
         . . . # # #
        . . . # B .
    )");
    Search search(Problem::of(world), {1, LengthMetric::Lattice, Guidance::None, JumpSet::Primitive});
    EXPECT_EQ(search->run([] { return true; }, 7), SearchStatus::Stopped);
    EXPECT_EQ(search->counters().expanded, 0u);
    std::vector<std::uint64_t> asked;
    EXPECT_EQ(search->run(
                  [&]
                  {
                      asked.push_back(search->counters().expanded);
                      return false;
                  },
                  7),
              SearchStatus::Exhausted);
    EXPECT_EQ(asked, (std::vector<std::uint64_t>{0, 7, 14}));
    EXPECT_EQ(search->counters().expanded, 18u);
}

TEST(HexSearch, resetForgetsEverything)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Problem problem = Problem::random(random);
        if (!problem.complete())
            continue;
        const std::vector<Method> methods = allMethods();
        const Method method = methods[seed % methods.size()];
        Search fresh(problem, method);
        const SearchStatus status = fresh->run(never, 10);

        Search used(problem, method);
        // stopped half-way, finished, and from other starts
        for (const std::int64_t polls : {random.integer(0, 20), std::int64_t{1000000}})
        {
            std::int64_t left = polls;
            used->run([&left] { return left-- == 0; }, 1);
            used->reset();
            EXPECT_FALSE(used->hasPath());
            EXPECT_EQ(used->cost(), infinity);
            EXPECT_EQ(used->counters().expanded, 0u);
            used->addStart(problem.occupancy->layout().index(problem.goals.front().cell), 0.25);
        }
        used->run(never, 10);
        used->reset();
        used.trace().clear();
        used.addStarts();
        EXPECT_EQ(used->run(never, 10), status);
        EXPECT_EQ(used->cost(), fresh->cost());
        if (method.guidance != Guidance::Relaxed)  // whose bound stays as sharp as it has become
        {
            EXPECT_EQ(used.path(), fresh.path());
            EXPECT_EQ(used.trace(), fresh.trace());
        }
    }
}

TEST(HexSearch, theBetterGuidanceExpandsNoMore)
{
    std::uint64_t none = 0;
    std::uint64_t cheng = 0;
    std::uint64_t distance = 0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Problem problem = Problem::random(random);
        if (!problem.complete() || problem.goals.size() > 1 || problem.starts.size() > 1)
            continue;
        const auto expanded = [&problem](Guidance guidance)
        {
            Search search(problem, {3, LengthMetric::Lattice, guidance, JumpSet::All});
            search->run(never, 1000);
            return search->counters().expanded;
        };
        none += expanded(Guidance::None);
        cheng += expanded(Guidance::Cheng);
        distance += expanded(Guidance::Distance);
    }
    EXPECT_LT(distance, cheng);
    EXPECT_LT(cheng, none);
}

TEST(HexSearch, roundIslandsTheRelaxedGuidanceExpandsFewerCellsAndTurnsNoMore)
{
    for (const int rings : {1, 2, 3})
        for (const LengthMetric metric : {LengthMetric::Euclidean, LengthMetric::Lattice})
        {
            std::uint64_t expanded[2] = {0, 0};
            std::uint64_t turns[2] = {0, 0};
            for (std::uint64_t seed = 1; seed <= 60; ++seed)
            {
                Random random(seed);
                SCOPED_TRACE(random.seedText());
                const Problem problem = Problem::amongIslands(random);
                Search plain(problem, {rings, metric, Guidance::Distance, JumpSet::Primitive});
                Search relaxed(problem, {rings, metric, Guidance::Relaxed, JumpSet::Primitive});
                ASSERT_EQ(plain->run(never, 1000), relaxed->run(never, 1000));
                if (!plain->hasPath())
                    continue;
                ASSERT_NEAR(relaxed->cost(), plain->cost(), 1e-9);
                expanded[0] += plain->counters().expanded;
                expanded[1] += relaxed->counters().expanded;
                turns[0] += turnsOf(plain.path());
                turns[1] += turnsOf(relaxed.path());
            }
            EXPECT_LT(expanded[1], expanded[0] * 2 / 3) << "rings " << rings;
            EXPECT_LT(turns[1], turns[0] * 11 / 10) << "rings " << rings;
        }
}

TEST(HexSearch, inOpenWaterOnlyTheCellsOfThePathAreExpanded)
{
    // The bound is exact there and ties go to the cell nearest to the goal, so nothing off the path is touched.
    const HexLattice lattice(Point::Zero(), 1.0, 60, 60);
    for (std::uint64_t seed = 1; seed <= 1000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        // off the border, along which a jump of the second ring would touch the outside
        const HexCoord start = toCube({random.integer(1, 58), random.integer(1, 58)});
        const HexCoord goal = toCube({random.integer(1, 58), random.integer(1, 58)});
        const Problem problem{occupancyWith(lattice, {}), {{start, random.unit()}}, {{goal, random.unit()}}};
        for (const int rings : {1, 2, 3})
            for (const LengthMetric metric : {LengthMetric::Euclidean, LengthMetric::Lattice})
            {
                const Method method{rings, metric, Guidance::Distance, JumpSet::Primitive};
                SCOPED_TRACE(method.text());
                Search search(problem, method);
                ASSERT_EQ(search->run(never, 1000), SearchStatus::Found);
                EXPECT_EQ(search->counters().expanded, search.path().size());
            }
    }
}
