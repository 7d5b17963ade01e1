// benchmark_planners: this project's planners and OMPL's on one chart, or over one seabed. The options are in
// Options.cpp, the two worlds in ChartWorld.cpp and DiveWorld.cpp, their planners in Roster.cpp and DiveRoster.cpp,
// what a process does in Job.cpp, what is made of the logs in report/.

#include "Campaign.h"
#include "ChartWorld.h"
#include "DiveWorld.h"
#include "Manifest.h"
#include "Options.h"
#include "ReportProgram.h"
#include "common/Arena.h"
#include "common/DivePairs.h"
#include "common/Failure.h"
#include "common/Pairs.h"
#include "common/Program.h"
#include "common/Progress.h"
#include "common/RasterSeabed.h"
#include "common/Waters.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace
{

using namespace benchmark_planners;

std::unique_ptr<World> makeChartWorld(const Options &options)
{
    demos::Progress progress;
    progress.stage("reading the chart");
    const auto chart = demos::readChart(options.charts);
    progress.stage("filling cells");
    seahex::ArenaOptions wanted;
    wanted.vessel = options.vessel;
    wanted.pitch = options.pitch;
    const auto arena = demos::makeArena(*chart, wanted);
    const seahex::HexOccupancy &occupancy = *arena->occupancy();
    return std::make_unique<ChartWorld>(
        chart, arena,
        drawPairs(occupancy, demos::LargestWater(occupancy), {options.pairs, options.leastDistance, options.seed}));
}

std::shared_ptr<const seahex::DiveArena> makeDiveArena(const demos::RasterSeabed &seabed,
                                                       const seahex::DiveLimits &limits, const std::string &name)
{
    try
    {
        return std::make_shared<const seahex::DiveArena>(seabed.depths, limits);
    }
    catch (const std::runtime_error &error)
    {
        throw demos::Failure(demos::Exit::Chart, name + ": " + error.what());
    }
}

std::unique_ptr<World> makeDiveWorld(const Options &options)
{
    demos::Progress progress;
    progress.stage("reading the seabed");
    const demos::RasterSeabed seabed = demos::readRaster(options.dive);
    const std::string name = std::filesystem::path(options.dive.bathymetry).filename().string();
    const auto arena = makeDiveArena(seabed, options.dive.limits, name);
    progress.stage("drawing pairs");
    return std::make_unique<DiveWorld>(
        name, arena, seabed.projection,
        demos::drawDivePairs(*arena, {options.pairs, options.leastDistance, options.seed}));
}

std::string pairLine(unsigned number, const PairFacts &pair)
{
    char line[160];
    std::snprintf(line, sizeof line, "pair %3u  %9.5f,%10.5f  to %9.5f,%10.5f  course %03.0f, %6.1f km", number,
                  pair.start.latitudeDeg(), pair.start.longitudeDeg(), pair.goal.latitudeDeg(),
                  pair.goal.longitudeDeg(), pair.courseDeg, pair.distanceM / 1000.0);
    std::string text = line;
    if (pair.dive)
    {
        std::snprintf(line, sizeof line, ", from %.0f m to %.0f m%s", pair.dive->startDepthM, pair.dive->goalDepthM,
                      pair.dive->isSeabedInTheWay ? ", seabed in the way" : "");
        text += line;
    }
    return text + "\n";
}

void printPlan(const Options &options, const World &world)
{
    char line[160];
    std::snprintf(line, sizeof line, "seed %u, %u pairs, %u run(s) of %zu planners, %g s each; results in ",
                  static_cast<unsigned>(options.seed), options.pairs, options.runs, options.planners.size(),
                  options.timeS);
    std::string text = line + options.out.string() + "\n";
    unsigned inTheWay = 0;
    for (unsigned number = 1; number <= world.pairCount(); ++number)
    {
        const PairFacts pair = world.pair(number);
        text += pairLine(number, pair);
        inTheWay += pair.dive && pair.dive->isSeabedInTheWay ? 1 : 0;
    }
    if (!options.dive.bathymetry.empty())
        text += "the seabed is in the way of the straight line of " + std::to_string(inTheWay) + " pairs\n";
    demos::print(text);
}

void printShard(const Options &options, std::size_t jobs)
{
    const nlohmann::ordered_json report = {
        {"status", "success"},
        {"exit", 0},
        {"shard", std::to_string(options.shard->index) + "/" + std::to_string(options.shard->count)},
        {"jobs", jobs}};
    demos::print(options.json ? report.dump(2) + "\n"
                              : "all " + std::to_string(jobs) +
                                    " jobs of this shard are done; --merge makes the page "
                                    "when the others are done too\n");
}

void runCampaign(const Options &options)
{
    const ResultsFolder folder(options.out);
    const std::unique_ptr<World> world =
        options.dive.bathymetry.empty() ? makeChartWorld(options) : makeDiveWorld(options);
    folder.claim(makeManifest(options, *world));
    if (!options.json)
        printPlan(options, *world);

    Campaign campaign(options, *world, folder);
    campaign.run();
    if (options.shard)
        printShard(options, campaign.jobCount());
    else
        makeReport(options, {options.out.string()});
}

void run(const Options &options)
{
    if (options.merge)
        makeReport(options, *options.merge);
    else
        runCampaign(options);
}

}  // namespace

int main(int argc, char **argv)
{
    return demos::runProgram("benchmark_planners", argc, argv,
                             [argc, argv]
                             {
                                 const CommandLine commandLine = readCommandLine(argc, argv);
                                 if (commandLine.options)
                                     run(*commandLine.options);
                                 else
                                     demos::print(commandLine.text);
                             });
}
