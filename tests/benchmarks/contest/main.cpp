// The benchmark that decides: every contender on every world, the same queries in one run, their costs held against a
// textbook's; then each target with what was measured. Times mean little on a shared machine: read the ratios.

#include "contest/Figures.h"
#include "contest/Filling.h"
#include "contest/FirstPath.h"
#include "contest/Opening.h"
#include "contest/Options.h"
#include "contest/ShortestPaths.h"
#include "contest/Stopwatch.h"
#include "contest/Targets.h"
#include "contest/Trial.h"

#include <benchmark/benchmark.h>

#include <iostream>
#include <memory>
#include <string>
#include <utility>

namespace
{

using namespace seahex::contest;

/// What the benchmarks share: one world at a time, since the large ones would not fit side by side.
class Contest
{
public:
    explicit Contest(Options options) : options_(std::move(options))
    {
        for (const std::string &file : options_.figures)
            measurements_.figures.merge(readFigures(file));
    }

    void registerAll()
    {
        for (const std::string &world : options_.worlds)
        {
            if (!isAvailable(world))
            {
                std::cerr << world << ": skipped, its chart was not found (SEAHEX_TEST_DATA)\n";
                continue;
            }
            registerChores(world);
            for (const ContenderKind &kind : contenders())
                add("search/" + world + "/" + kind.name,
                    [this, world, &kind](benchmark::State &state) { search(state, world, kind); });
        }
    }

    const Measurements &measurements() const { return measurements_; }
    bool hasFailed() const { return hasFailed_; }

private:
    template <class Run>
    void add(const std::string &name, Run &&run)
    {
        benchmark::RegisterBenchmark(name.c_str(), std::forward<Run>(run))
            ->UseManualTime()
            ->Iterations(options_.passes)
            ->Unit(benchmark::kMillisecond);
    }

    /// What is no search: a function that returns milliseconds.
    void registerChores(const std::string &world)
    {
        const auto addChore = [&](const std::string &what, const std::string &by, double (*ms)(const Course &))
        {
            const std::string name = what + "/" + world + "/" + by;
            add(name, [this, name, world, ms](benchmark::State &state) { doChore(state, name, world, ms); });
        };
        addChore("fill", "hexagons", [](const Course &course) { return fillMs(course.world()); });
        addChore("fill", "gdal", [](const Course &course) { return rasterizeMs(course.world()); });
        addChore("first", "HexAStar", firstPathMs);
        addChore("exact", "taut", exactMs);
        add("gap/" + world, [this, world](benchmark::State &state) { findGap(state, world); });
        if (world.rfind("archipelago", 0) == 0)
            return;  // of no chart
        addChore("open", "seahex", [](const Course &course) { return openMs(course.world().chart); });
        addChore("open", "gdal", [](const Course &course) { return gdalReadMs(course.world().chart); });
    }

    void doChore(benchmark::State &state, const std::string &name, const std::string &world,
                 double (*ms)(const Course &))
    try
    {
        const Course &course = courseOn(world);
        for (auto _ : state)
        {
            const double taken = ms(course);
            state.SetIterationTime(1e-3 * taken);
            measurements_.noteLeast(name, taken);
        }
    }
    catch (const std::exception &error)
    {
        fail(state, error);
    }

    void findGap(benchmark::State &state, const std::string &world)
    try
    {
        const Course &course = courseOn(world);
        for (auto _ : state)
        {
            const Stopwatch watch;
            const Gap gap = gapOfPulled(course);
            state.SetIterationTime(watch.seconds());
            measurements_.figures["gap/" + world + "/median"] = gap.median;
            measurements_.figures["gap/" + world + "/worst"] = gap.worst;
            state.counters["median_percent"] = gap.median;
            state.counters["worst_percent"] = gap.worst;
        }
    }
    catch (const std::exception &error)
    {
        fail(state, error);
    }

    Course &courseOn(const std::string &world)
    {
        if (!course_ || course_->world().name != world)
        {
            course_.reset();
            course_ = std::make_unique<Course>(makeWorld(world), options_.queries, options_.seed);
        }
        return *course_;
    }

    void search(benchmark::State &state, const std::string &world, const ContenderKind &kind)
    try
    {
        Course &course = courseOn(world);
        if (course.world().occupancy->lattice().cellCount() > kind.mostCells)
        {
            state.SkipWithError("the world is too large for it");
            return;
        }
        Trial trial(course, kind);
        for (auto _ : state)
            state.SetIterationTime(trial.pass());
        note(state, trial.result());
    }
    catch (const std::exception &error)
    {
        fail(state, error);
    }

    void fail(benchmark::State &state, const std::exception &error)
    {
        hasFailed_ = true;
        std::cerr << error.what() << '\n';
        state.SkipWithError(error.what());
    }

    void note(benchmark::State &state, const Result &result)
    {
        state.counters["expanded"] = result.expanded();
        state.counters["median_ms"] = result.medianMs();
        state.counters["mean_ms"] = result.meanMs();
        state.counters["queries_per_s"] = 1e3 / result.meanMs();
        state.counters["ns_per_expansion"] = result.nsPerExpansion();
        state.counters["bytes_per_touched"] = result.bytesPerTouched();
        state.counters["bits_per_cell"] = result.bitsPerIndex();
        state.counters["cells"] = static_cast<double>(result.cells);
        measurements_.results.push_back(result);
    }

    Options options_;
    std::unique_ptr<Course> course_;
    Measurements measurements_;
    bool hasFailed_ = false;
};

}  // namespace

int main(int argc, char **argv)
try
{
    benchmark::Initialize(&argc, argv);
    Contest contest(readOptions({argv + 1, argv + argc}));
    contest.registerAll();
    benchmark::RunSpecifiedBenchmarks();
    printVerdicts(contest.measurements(), std::cout);
    return contest.hasFailed() ? 1 : 0;
}
catch (const std::exception &error)
{
    std::cerr << error.what() << '\n';
    return 2;
}
