#include <seahex/search/AStar.h>
#include <seahex/search/LengthAlgebra.h>

#include "support/ExplicitGraph.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();

/// A graph as a test double of a lattice: from cell u a jump k leads to u + k + 1 (mod the number of cells), if it is
/// there. Its bounds are what the test says; every `tiring`-th expansion is interrupted.
struct Circulant : LengthAlgebra
{
    std::vector<std::vector<double>> costs;  // infinity where there is no jump
    std::vector<double> bounds;
    std::vector<double> sharpBounds;  // in their place after so many expansions
    std::uint64_t patience = 0;
    CellIndex goal = 0;
    int tiring = 0;
    int calls = 0;

    static Circulant random(Random &random)
    {
        Circulant lattice;
        const auto cells = static_cast<std::size_t>(random.integer(2, 40));
        const auto jumps = static_cast<std::size_t>(random.integer(1, 6));
        lattice.costs.assign(cells, std::vector<double>(jumps, infinity));
        for (auto &row : lattice.costs)
            for (double &cost : row)
                if (random.chance(0.7))
                    cost = random.real(0.0, 10.0);
        lattice.goal = static_cast<CellIndex>(random.integer(1, static_cast<std::int64_t>(cells) - 1));
        return lattice;
    }

    CellIndex successor(CellIndex cell, std::size_t jump) const
    {
        return static_cast<CellIndex>((cell + jump + 1) % costs.size());
    }

    /// Exact cost from each cell to the goal.
    std::vector<double> costsToGoal() const
    {
        ExplicitGraph backwards(costs.size());
        for (CellIndex cell = 0; cell < costs.size(); ++cell)
            for (std::size_t jump = 0; jump < costs[cell].size(); ++jump)
                if (std::isfinite(costs[cell][jump]))
                    backwards.addEdge(successor(cell, jump), cell, costs[cell][jump]);
        return backwards.costsFrom({{goal, 0.0}});
    }

    std::size_t size() const { return costs.size(); }

    template <class Relax>
    bool expand(CellIndex cell, std::uint8_t, Relax &&relax)
    {
        const bool interrupted = tiring > 0 && ++calls % tiring == 0;
        const std::size_t end = interrupted ? costs[cell].size() / 2 : costs[cell].size();
        for (std::size_t jump = 0; jump < end; ++jump)
            if (std::isfinite(costs[cell][jump]))
                relax(successor(cell, jump), static_cast<std::uint8_t>(jump), costs[cell][jump]);
        return !interrupted;
    }

    CellIndex predecessor(CellIndex cell, std::uint8_t jump) const
    {
        return static_cast<CellIndex>((cell + costs.size() - (jump + 1u) % costs.size()) % costs.size());
    }
    double bound(CellIndex cell) const { return bounds[cell]; }
    bool sharpen(std::uint64_t expanded)
    {
        if (sharpBounds.empty() || expanded < patience)
            return false;
        bounds.swap(sharpBounds);
        sharpBounds.clear();
        return true;
    }
    double tie(CellIndex, double bound) const { return bound; }
    double finish(CellIndex cell) const { return cell == goal ? 0.0 : worst(); }
};

/// The same with another algebra: a path is as good as its least value, and more is better.
struct Widest : Circulant
{
    static double combine(double a, double b) { return std::min(a, b); }
    static bool better(double a, double b) { return a > b; }
    static double worst() { return -infinity; }
    static bool improves(double cost, double known) { return cost > known; }
    static double key(double estimate) { return estimate; }
    double bound(CellIndex) const { return infinity; }
    double finish(CellIndex cell) const { return cell == goal ? infinity : worst(); }
};

}  // namespace

TEST(AStar, inconsistentBoundsReopenCellsAndStayOptimal)
{
    std::uint64_t reopened = 0;
    int reached = 0;
    for (std::uint64_t seed = 1; seed <= 5000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        Circulant lattice = Circulant::random(random);
        const std::vector<double> exact = lattice.costsToGoal();
        // admissible, but one cell knows much and the next one nothing
        for (const double cost : exact)
            lattice.bounds.push_back(random.chance(0.5) ? 0.0 : (std::isinf(cost) ? 5.0 : cost * random.unit()));
        lattice.tiring = random.chance(0.5) ? static_cast<int>(random.integer(2, 5)) : 0;
        AStar<Circulant> search(lattice);
        search.addStart(0, 0.5);
        SearchStatus status = SearchStatus::Stopped;
        for (int runs = 0; status == SearchStatus::Stopped; ++runs)
        {
            ASSERT_LT(runs, 100000);
            status = search.run([] { return false; }, 10);
        }
        if (std::isinf(exact[0]))
        {
            ASSERT_EQ(status, SearchStatus::Exhausted);
            continue;
        }
        ++reached;
        ASSERT_EQ(status, SearchStatus::Found);
        ASSERT_NEAR(search.cost(), exact[0] + 0.5, 1e-9);
        ASSERT_EQ(search.path().front(), 0u);
        ASSERT_EQ(search.path().back(), lattice.goal);
        reopened += search.counters().reopened;
    }
    EXPECT_GT(reached, 1000);
    EXPECT_GT(reopened, 500u) << "the bounds were not inconsistent enough to mean something";
}

TEST(AStar, anotherAlgebraFindsTheWidestWay)
{
    int reached = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        Widest lattice;
        static_cast<Circulant &>(lattice) = Circulant::random(random);
        // the widest width at which the goal can still be reached, by trying each
        double widest = -infinity;
        for (const auto &row : lattice.costs)
            for (const double width : row)
            {
                Circulant narrowed = lattice;
                for (auto &other : narrowed.costs)
                    for (double &w : other)
                        w = std::isfinite(w) && w >= width ? 1.0 : infinity;
                if (std::isfinite(width) && width > widest && std::isfinite(narrowed.costsToGoal()[0]))
                    widest = width;
            }
        AStar<Widest> search(lattice);
        search.addStart(0, infinity);
        ASSERT_EQ(search.run([] { return false; }, 10),
                  std::isfinite(widest) ? SearchStatus::Found : SearchStatus::Exhausted);
        ASSERT_EQ(search.cost(), widest);
        reached += std::isfinite(widest) ? 1 : 0;
    }
    EXPECT_GT(reached, 500);
}

TEST(AStar, boundsThatGrowOnTheWayLeaveTheCostAndSaveWork)
{
    std::uint64_t blunt = 0;
    std::uint64_t sharpened = 0;
    for (std::uint64_t seed = 1; seed <= 3000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        Circulant lattice = Circulant::random(random);
        const std::vector<double> exact = lattice.costsToGoal();
        lattice.bounds.assign(exact.size(), 0.0);
        const auto solve = [&](Circulant graph)
        {
            AStar<Circulant> search(graph);
            search.addStart(0, 0.5);
            EXPECT_EQ(search.run([] { return false; }, 10),
                      std::isfinite(exact[0]) ? SearchStatus::Found : SearchStatus::Exhausted);
            if (std::isfinite(exact[0]))
            {
                EXPECT_NEAR(search.cost(), exact[0] + 0.5, 1e-9);
            }
            EXPECT_EQ(search.counters().reopened, 0u);
            return search.counters().expanded;
        };
        blunt += solve(lattice);
        for (const double cost : exact)
            lattice.sharpBounds.push_back(std::min(cost, 1e6));  // as sharp as can be, and consistent
        lattice.patience = static_cast<std::uint64_t>(random.integer(0, 10));
        sharpened += solve(lattice);
    }
    EXPECT_LT(sharpened, blunt * 9 / 10);
}
