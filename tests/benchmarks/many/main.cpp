// Many queries on one chart: batches over threads, matrices, replanning after a change, each held against single
// searches. Prints medians; lengths of matrices and replanning are compared with those of single searches.
//
//   seahex_many [WORLD] [QUERIES]      N, 200

#include "contest/Median.h"
#include "contest/Queries.h"
#include "contest/Stopwatch.h"
#include "contest/World.h"

#include <seahex/geometry/HexTraversal.h>
#include <seahex/search/LengthMatrix.h>
#include <seahex/search/LengthSearch.h>
#include <seahex/search/Replanner.h>
#include <seahex/search/ShortestPaths.h>
#include <seahex/world/CellBits.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <random>
#include <stdexcept>
#include <string>

using namespace seahex;
using namespace seahex::contest;

namespace
{

constexpr int rings = 3;

using Cells = std::shared_ptr<const HexOccupancy>;

void expectEqual(double length, double expected)
{
    if (!(std::abs(length - expected) <= 1e-7 * expected))
        throw std::runtime_error("a length of " + std::to_string(length) + " where a single search finds " +
                                 std::to_string(expected));
}

void compareBatches(const Cells &cells, const std::vector<Query> &drawn)
{
    std::vector<CellQuery> queries;
    for (const Query &query : drawn)
        queries.push_back({query.start, query.goal});
    constexpr int runs = 7;
    std::map<unsigned int, std::vector<double>> seconds;
    std::map<unsigned int, std::vector<double>> work;  // of all processors
    std::vector<double> speedUp2, speedUp4, work2;
    for (int run = 0; run < runs; ++run)
    {
        for (const unsigned int threads : {1U, 2U, 4U})
        {
            BatchControl control;
            control.threads = threads;
            const Stopwatch watch;
            const std::clock_t begin = std::clock();
            shortestPaths(*cells, rings, queries, control);
            seconds[threads].push_back(watch.seconds());
            work[threads].push_back(static_cast<double>(std::clock() - begin));
        }
        work2.push_back(work[2].back() / work[1].back());
        speedUp2.push_back(seconds[1].back() / seconds[2].back());
        speedUp4.push_back(seconds[1].back() / seconds[4].back());
    }
    std::printf(
        "batch of %zu queries: %.0f, %.0f, %.0f ms on 1, 2, 4 threads; 2 threads %.2f times one, 4 threads %.2f; "
        "2 threads take %.2f of the processor time of one\n",
        queries.size(), 1e3 * medianOf(seconds[1]), 1e3 * medianOf(seconds[2]), 1e3 * medianOf(seconds[4]),
        medianOf(speedUp2), medianOf(speedUp4), medianOf(work2));
}

void compareMatrices(const Cells &cells, const std::vector<Query> &drawn)
{
    for (const std::size_t side : {2U, 5U, 10U, 20U})
    {
        std::vector<HexCoord> starts, goals;
        std::vector<CellQuery> queries;
        for (std::size_t i = 0; i < side; ++i)
        {
            starts.push_back(drawn[i].start);
            goals.push_back(drawn[i].goal);
        }
        for (const HexCoord start : starts)
            for (const HexCoord goal : goals)
                queries.push_back({start, goal});
        BatchControl control;
        control.threads = 1;
        std::vector<double> single, matrixTime;
        for (int run = 0; run < 3; ++run)
        {
            Stopwatch watch;
            const std::vector<ShortestPath> paths = shortestPaths(*cells, rings, queries, control);
            single.push_back(watch.ms());
            watch = Stopwatch();
            const LengthMatrix matrix = lengthMatrix(*cells, rings, starts, goals, control);
            matrixTime.push_back(watch.ms());
            for (std::size_t k = 0; k < paths.size(); ++k)
                expectEqual(matrix(k / side, k % side), paths[k].length);
        }
        std::printf("matrix %zu x %zu: %.1f ms, single queries %.1f ms, %.2f of these\n", side, side,
                    medianOf(matrixTime), medianOf(single), medianOf(matrixTime) / medianOf(single));
    }
}

/// The same cells with a round hazard.
Cells withHazard(const Cells &cells, HexCoord middle, std::int64_t radius)
{
    std::vector<std::uint64_t> words(cells->words().begin(), cells->words().end());
    for (std::int64_t s = -radius; s <= radius; ++s)
        for (std::int64_t q = -radius; q <= radius; ++q)
            if (const HexCoord cell = middle + HexCoord{q, s};
                hexNorm({q, s}) <= radius && cells->lattice().contains(cell))
            {
                const CellIndex index = cells->layout().index(cell);
                words[index >> 6] |= std::uint64_t{1} << (index & 63);
            }
    return std::make_shared<const HexOccupancy>(cells->lattice(), cells->layout(), std::move(words));
}

class Replanning
{
public:
    explicit Replanning(const Cells &cells) : cells_(cells), replanner_(cells, rings), fresh_(*cells, rings), random_(7)
    {
    }

    void run(const std::vector<Query> &queries)
    {
        for (const Query &query : queries)
        {
            const HexCoord start = query.start;
            const HexCoord goal = query.goal;
            tell("first plan", cells_, start, goal, true);
            const std::vector<CellIndex> route = replanner_.path();
            const auto at = [&](double share)
            {
                return cells_->layout().cell(
                    route[static_cast<std::size_t>(share * static_cast<double>(route.size()))]);
            };
            tell("start on along the route by 1 %", cells_, at(0.01), goal);
            tell("start aside of the route, 5 cells", cells_, beside(at(0.02), 5), goal);
            tell("start aside of the route, 20 cells", cells_, beside(at(0.03), 20), goal);
            tell("", cells_, start, goal);
            for (const double share : {0.05, 0.2, 0.5, 0.8})
                for (const std::int64_t radius : {5, 10, 20})
                    hazard("hazard of " + std::to_string(radius) + " cells at " + std::to_string(share).substr(0, 4) +
                               " of the route",
                           start, goal, at(share), radius);
            const double any = std::uniform_real_distribution<>(0.05, 0.95)(random_);
            hazard("hazard of 10 cells anywhere on the route", start, goal, at(any), 10);
            hazard("hazard of 20 cells off the route", start, goal, awayFrom(route), 20);
            const HexCoord moved = beside(goal, 10);
            tell("goal moved by 10 cells, the first time", cells_, start, moved);
            tell("goal moved by 10 cells, again", cells_, start, beside(moved, 10));
        }
        for (const std::string &name : names_)
            std::printf("%-50s %6.2f ms, fresh %6.2f ms; share %.3f (quartiles %.3f, %.3f)\n", name.c_str(),
                        medianOf(events_[name].ms), medianOf(events_[name].freshMs), medianOf(events_[name].share),
                        quantile(events_[name].share, 0.25), quantile(events_[name].share, 0.75));
        std::printf("an occupancy with a hazard: made in %.2f ms\n", medianOf(makingMs_));
    }

private:
    struct Event
    {
        std::vector<double> ms, freshMs, share;
    };

    static double quantile(std::vector<double> values, double share)
    {
        std::sort(values.begin(), values.end());
        return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    }

    HexCoord beside(HexCoord cell, std::int64_t steps)
    {
        for (int tries = 0; tries < 1000; ++tries)
        {
            const HexCoord offset{
                static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(2 * steps + 1)) - steps,
                static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(2 * steps + 1)) - steps};
            if (hexNorm(offset) == steps && cells_->isFree(cell + offset))
                return cell + offset;
        }
        return cell;
    }

    HexCoord awayFrom(const std::vector<CellIndex> &route)
    {
        for (;;)
        {
            const HexCoord cell =
                toCube({static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(cells_->lattice().columns())),
                        static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(cells_->lattice().rows()))});
            if (cells_->isFree(cell) &&
                std::all_of(route.begin(), route.end(),
                            [&](CellIndex c) { return hexDistance(cells_->layout().cell(c), cell) > 40; }))
                return cell;
        }
    }

    void hazard(const std::string &name, HexCoord start, HexCoord goal, HexCoord middle, std::int64_t radius)
    {
        if (std::min(hexDistance(middle, start), hexDistance(middle, goal)) <= radius)
            return;
        const Stopwatch watch;
        const Cells changed = withHazard(cells_, middle, radius);
        makingMs_.push_back(watch.ms());
        tell(name, changed, start, goal);
        tell(name + ", gone", cells_, start, goal);
        tell("", cells_, start, goal, true);  // a tree that no hazard has pruned
    }

    void tell(const std::string &name, const Cells &cells, HexCoord start, HexCoord goal, bool isFirst = false)
    {
        if (isFirst)  // another voyage before, so that no tree is left of this one
            replanner_.plan(goal, start);
        Stopwatch watch;
        replanner_.setOccupancy(cells);
        const SearchStatus status = replanner_.plan(start, goal);
        const std::vector<CellIndex> path = replanner_.path();
        const double ms = watch.ms();
        if (name.empty())
            return;
        LengthSearch &fresh = freshOn(cells);
        watch = Stopwatch();
        fresh.begin(start, goal);
        fresh.run();
        const std::vector<CellIndex> freshPath = fresh.path();
        const double freshMs = watch.ms();
        if ((status == SearchStatus::Found) != fresh.hasPath())
            throw std::runtime_error("one of the searches finds a path, the other does not");
        if (fresh.hasPath())
            expectEqual(replanner_.length(), fresh.cost());
        if (events_.find(name) == events_.end())
            names_.push_back(name);
        events_[name].ms.push_back(ms);
        events_[name].freshMs.push_back(freshMs);
        events_[name].share.push_back(ms / freshMs);
    }

    /// A warm search on these cells.
    LengthSearch &freshOn(const Cells &cells)
    {
        if (cells == cells_)
            return fresh_;
        if (other_ != cells)
        {
            other_ = cells;
            otherFresh_ = std::make_unique<LengthSearch>(*cells, rings);
        }
        return *otherFresh_;
    }

    Cells cells_;
    Replanner replanner_;
    LengthSearch fresh_;
    Cells other_;
    std::unique_ptr<LengthSearch> otherFresh_;
    std::mt19937_64 random_;
    std::map<std::string, Event> events_;
    std::vector<std::string> names_;
    std::vector<double> makingMs_;
};

}  // namespace

int main(int argc, char **argv)
{
    const World world = makeWorld(argc > 1 ? argv[1] : "N");
    const auto count = static_cast<std::size_t>(argc > 2 ? std::atoi(argv[2]) : 200);
    const std::vector<Query> queries = drawQueries(*world.occupancy, count, 1);
    const std::string parts = argc > 3 ? argv[3] : "bmr";
    std::printf("%s: %s, %zu queries\n", world.name.c_str(), world.what.c_str(), queries.size());
    if (parts.find('b') != std::string::npos)
        compareBatches(world.occupancy, queries);
    if (parts.find('m') != std::string::npos)
        compareMatrices(world.occupancy, queries);
    if (parts.find('r') != std::string::npos)
        Replanning(world.occupancy)
            .run({queries.begin(), queries.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(100, count))});
    return 0;
}
