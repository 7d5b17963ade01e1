// benchmark_planners: HexAStar and OMPL's planners on one chart. The options are in Options.cpp, the planners in
// Roster.cpp, what a process does in Job.cpp, what is made of the logs in report/.

#include "Campaign.h"
#include "Manifest.h"
#include "Options.h"
#include "ReportProgram.h"
#include "common/Arena.h"
#include "common/Pairs.h"
#include "common/Program.h"
#include "common/Progress.h"
#include "common/Waters.h"

#include <cstdio>

namespace
{

using namespace benchmark_planners;

World makeWorld(const Options &options)
{
    demos::Progress progress;
    progress.stage("reading the chart");
    const auto chart = demos::readChart(options.charts);
    progress.stage("filling cells");
    seahex::ArenaOptions arena;
    arena.vessel = options.vessel;
    arena.pitch = options.pitch;
    return {chart, demos::makeArena(*chart, arena)};
}

void printPlan(const Options &options, const nlohmann::ordered_json &manifest)
{
    char line[160];
    std::snprintf(line, sizeof line, "seed %u, %u pairs, %u run(s) of %zu planners, %g s each; results in ",
                  static_cast<unsigned>(options.seed), options.pairs, options.runs, options.planners.size(),
                  options.timeS);
    std::string text = line + options.out.string() + "\n";
    for (const auto &pair : manifest.at("pair_list"))
    {
        std::snprintf(line, sizeof line, "pair %3d  %9.5f,%10.5f  to %9.5f,%10.5f  course %03.0f, %6.1f km\n",
                      pair.at("number").get<int>(), pair.at("start").at(0).get<double>(),
                      pair.at("start").at(1).get<double>(), pair.at("goal").at(0).get<double>(),
                      pair.at("goal").at(1).get<double>(), pair.at("course_deg").get<double>(),
                      pair.at("distance_m").get<double>() / 1000.0);
        text += line;
    }
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
    const World world = makeWorld(options);
    const seahex::HexOccupancy &occupancy = *world.arena->occupancy();
    const std::vector<demos::Pair> pairs =
        drawPairs(occupancy, demos::LargestWater(occupancy), {options.pairs, options.leastDistance, options.seed});
    const nlohmann::ordered_json manifest = makeManifest(options, world, pairs);
    folder.claim(manifest);
    if (!options.json)
        printPlan(options, manifest);

    Campaign campaign(options, world, folder, pairs);
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
