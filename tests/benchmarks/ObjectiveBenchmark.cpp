// What the fields behind the objectives cost to make, for a million cells, and what a motion costs to price.

#include <seahex/planning/ClearanceObjective.h>
#include <seahex/planning/SafetyWeightObjective.h>
#include <seahex/planning/Setup.h>
#include <seahex/world/CellBits.h>
#include <seahex/world/Clearance.h>
#include <seahex/world/ClearanceField.h>
#include <seahex/world/SafetyWeights.h>

#include <benchmark/benchmark.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <cstdlib>
#include <limits>
#include <memory>
#include <random>
#include <utility>

namespace ob = ompl::base;

namespace
{

using seahex::HexOccupancy;
using seahex::Point;

/// A thousand by a thousand cells of 20 m, with 400 islands of up to 60 cells across.
const HexOccupancy &archipelago()
{
    static const std::unique_ptr<const HexOccupancy> occupancy = []
    {
        const seahex::HexLattice lattice(Point(0, 0), 20.0, 1000, 1000);
        const seahex::CellLayout layout(lattice.columns(), lattice.rows());
        seahex::CellBits bits(layout);
        std::mt19937_64 engine(1);
        for (int i = 0; i < 400; ++i)
        {
            const auto column = static_cast<std::int64_t>(engine() % 1000);
            const auto row = static_cast<std::int64_t>(engine() % 1000);
            const auto radius = static_cast<std::int64_t>(engine() % 30);
            for (std::int64_t k = -radius; k <= radius; ++k)
                bits.setSpan(row + k, column - (radius - std::abs(k) / 2), column + (radius - std::abs(k) / 2));
        }
        bits.setOutside();
        return std::make_unique<const HexOccupancy>(lattice, layout, std::move(bits.words()));
    }();
    return *occupancy;
}

void safetyWeights(benchmark::State &state)
{
    const HexOccupancy &occupancy = archipelago();
    for (auto _ : state)
        benchmark::DoNotOptimize(seahex::SafetyWeights(occupancy));
}

/// Up to so many cells' widths from the nearest blocked cell; 0 for all the way.
void clearanceField(benchmark::State &state)
{
    const HexOccupancy &occupancy = archipelago();
    const double limit =
        state.range(0) == 0 ? std::numeric_limits<double>::infinity() : 20.0 * static_cast<double>(state.range(0));
    for (auto _ : state)
        benchmark::DoNotOptimize(seahex::ClearanceField(occupancy, limit));
}

/// The same all the way by asking for one cell after the other.
void clearanceCellByCell(benchmark::State &state)
{
    const HexOccupancy &occupancy = archipelago();
    for (auto _ : state)
    {
        double sum = 0.0;
        for (std::int64_t row = 0; row < 1000; ++row)
            for (std::int64_t column = 0; column < 1000; ++column)
                sum += nearestBlocked(occupancy, occupancy.lattice().centre(seahex::toCube({column, row}))).distance;
        benchmark::DoNotOptimize(sum);
    }
}

enum class Priced
{
    Length,
    OnArrival,
    AlongLine,
    Clearance
};

/// One motion over so many cells, in a direction that is not the lattice's.
void motion(benchmark::State &state, Priced priced)
{
    const HexOccupancy &occupancy = archipelago();
    const auto si = std::make_shared<ob::SpaceInformation>(seahex::planarSpace(occupancy));
    si->setStateValidityChecker([](const ob::State *) { return true; });
    si->setup();
    std::unique_ptr<ob::OptimizationObjective> objective;
    if (priced == Priced::Length)
        objective = std::make_unique<ob::PathLengthOptimizationObjective>(si);
    else if (priced == Priced::Clearance)
        objective = std::make_unique<seahex::ClearanceObjective>(si, occupancy, 200.0, 2.0);
    else
        objective = std::make_unique<seahex::SafetyWeightObjective>(
            si, occupancy,
            priced == Priced::OnArrival ? seahex::SafetyCharge::OnArrival : seahex::SafetyCharge::AlongLine);
    const seahex::PlanarEmbedding embedding(si->getStateSpace().get());
    ob::ScopedState<> from(si);
    ob::ScopedState<> to(si);
    const Point start(9000.0, -9000.0);
    embedding.place(from.get(), start);
    embedding.place(to.get(), start + 20.0 * static_cast<double>(state.range(0)) * Point(0.8, 0.6));
    for (auto _ : state)
        benchmark::DoNotOptimize(objective->motionCost(from.get(), to.get()));
}

BENCHMARK(safetyWeights)->Unit(benchmark::kMillisecond);
BENCHMARK(clearanceField)->Arg(5)->Arg(25)->Arg(0)->Unit(benchmark::kMillisecond);
BENCHMARK(clearanceCellByCell)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(motion, length, Priced::Length)->Arg(1)->Arg(100);
BENCHMARK_CAPTURE(motion, safetyOnArrival, Priced::OnArrival)->Arg(1)->Arg(100);
BENCHMARK_CAPTURE(motion, safetyAlongLine, Priced::AlongLine)->Arg(1)->Arg(100);
BENCHMARK_CAPTURE(motion, clearance, Priced::Clearance)->Arg(1)->Arg(100);

}  // namespace
