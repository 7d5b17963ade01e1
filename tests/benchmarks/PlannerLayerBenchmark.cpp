// What OMPL's layer costs: the same queries solved through HexAStar as an ompl::base::Planner and by the search alone,
// in turns, on the chart's own lattice. Read the counter `ratio`; 1 would be no cost at all.

#include <seahex/chart/ChartArena.h>
#include <seahex/chart/ChartReader.h>
#include <seahex/planning/HexAStar.h>
#include <seahex/planning/Setup.h>
#include <seahex/search/AStar.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/LengthWeight.h>

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

double bareSearch(const HexOccupancy &occupancy, const Query &query, int rings)
{
    const HexLattice &lattice = occupancy.lattice();
    const HexJumps jumps(occupancy.layout(), rings, JumpSet::Primitive);
    JumpGraph<LengthWeight> graph(occupancy, jumps, {{query.goal, 0.0}},
                                  LengthWeight(lattice, jumps, LengthMetric::Euclidean, Guidance::Distance,
                                               lattice.centre(query.start), lattice.centre(query.goal)));
    AStar<JumpGraph<LengthWeight>> search(graph);
    search.addStart(occupancy.layout().index(query.start), 0.0);
    search.run([] { return false; }, 500);
    benchmark::DoNotOptimize(search.path());
    return search.hasPath() ? search.cost() * lattice.pitch() : -1.0;
}

double throughPlanner(og::SimpleSetup &setup, const Query &query, int rings)
{
    const HexLattice &lattice = shangchuan()->lattice();
    setup.clear();
    setStartAndGoal(setup, lattice.centre(query.start), lattice.centre(query.goal));
    HexAStar planner(setup.getSpaceInformation());
    planner.setRings(rings);
    planner.setAnytime(false);
    planner.setSmoothing(false);
    planner.setProblemDefinition(setup.getProblemDefinition());
    planner.setup();
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
    while (queries.size() < 10)
    {
        const Query query{freeCell(), freeCell()};
        if (hexDistance(query.start, query.goal) > lattice.columns() / 3 && bareSearch(occupancy, query, 1) > 0.0)
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
            const double bare = secondsOf([&] { expected = bareSearch(*occupancy, query, rings); });
            const double planner = secondsOf([&] { length = throughPlanner(setup, query, rings); });
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
