// What OMPL's layer costs: the same queries solved through HexAStar as an ompl::base::Planner and by the search alone,
// in turns, on the chart's own lattice. Read the counter `ratio`; 1 would be no cost at all.

#include <seahex/chart/ChartArena.h>
#include <seahex/chart/ChartReader.h>
#include <seahex/planning/HexAStar.h>
#include <seahex/planning/Setup.h>
#include <seahex/search/LengthSearch.h>

#include <ompl/util/Console.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <vector>

namespace
{

namespace ob = ompl::base;
namespace og = ompl::geometric;
using namespace seahex;

struct Query
{
    HexCoord start;
    HexCoord goal;
};

const std::shared_ptr<const HexOccupancy> &shangchuan()
{
    static const auto occupancy = ChartArena(readChart(SEAHEX_MAPS_DIR "/shangchuan.000"), {}).occupancy();
    return occupancy;
}

double bareSearch(LengthSearch &search, const HexOccupancy &occupancy, const Query &query)
{
    search.begin(query.start, query.goal);
    search.run([] { return false; }, 500);
    benchmark::DoNotOptimize(search.path());
    return search.hasPath() ? search.cost() * occupancy.lattice().pitch() : -1.0;
}

/// With a planner that is kept, as a user with many problems keeps it.
double throughPlanner(og::SimpleSetup &setup, HexAStar &planner, const Query &query)
{
    const HexLattice &lattice = shangchuan()->lattice();
    setup.clear();
    setStartAndGoal(setup, lattice.centre(query.start), lattice.centre(query.goal));
    planner.clear();
    planner.setProblemDefinition(setup.getProblemDefinition());
    return planner.solve(ob::timedPlannerTerminationCondition(100.0)) == ob::PlannerStatus::EXACT_SOLUTION
               ? setup.getProblemDefinition()->getSolutionPath()->length()
               : -1.0;
}

/// Pairs that are joined by a way, at least a third of the chart apart.
std::vector<Query> queriesOn(const HexOccupancy &occupancy)
{
    const HexLattice &lattice = occupancy.lattice();
    std::mt19937_64 random(1);
    const auto freeCell = [&]
    {
        HexCoord cell{};
        do
            cell = toCube({static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(lattice.columns())),
                           static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(lattice.rows()))});
        while (!occupancy.isFree(cell));
        return cell;
    };
    std::vector<Query> queries;
    LengthSearch search(occupancy, 1);
    while (queries.size() < 10)
    {
        const Query query{freeCell(), freeCell()};
        if (hexDistance(query.start, query.goal) > lattice.columns() / 3 && bareSearch(search, occupancy, query) > 0.0)
            queries.push_back(query);
    }
    return queries;
}

void plannerLayer(benchmark::State &state)
{
    ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
    const auto &occupancy = shangchuan();
    const auto rings = static_cast<int>(state.range(0));
    static const std::vector<Query> queries = queriesOn(*occupancy);
    og::SimpleSetup setup(planarSpace(*occupancy));
    useOccupancy(setup, occupancy);
    setup.getSpaceInformation()->setup();
    LengthSearch search(*occupancy, rings);
    HexAStar kept(setup.getSpaceInformation());
    kept.setRings(rings);
    kept.setAnytime(false);
    kept.setSmoothing(false);

    const auto secondsOf = [](const auto &action)
    {
        const auto begin = std::chrono::steady_clock::now();
        action();
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    std::vector<double> ratios;
    double bareSeconds = 0.0;
    for (auto _ : state)
        for (const Query &query : queries)
        {
            double length = 0.0;
            double expected = 0.0;
            const double bare = secondsOf([&] { expected = bareSearch(search, *occupancy, query); });
            const double planner = secondsOf([&] { length = throughPlanner(setup, kept, query); });
            if (std::abs(length - expected) > 1e-6 * expected)
                state.SkipWithError("the two disagree");
            ratios.push_back(planner / bare);
            bareSeconds += bare;
        }
    std::sort(ratios.begin(), ratios.end());
    state.counters["ratio"] = ratios[ratios.size() / 2];
    state.counters["ratio_worst"] = ratios.back();
    state.counters["bare_ms"] = 1e3 * bareSeconds / static_cast<double>(ratios.size());
    state.counters["cells"] = static_cast<double>(occupancy->lattice().cellCount());
}

}  // namespace

BENCHMARK(plannerLayer)->Arg(1)->Arg(2)->Arg(3)->ArgName("rings")->Unit(benchmark::kMillisecond)->MinTime(3.0);
