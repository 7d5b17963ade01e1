#include "Options.h"

#include "Cores.h"
#include "DiveRoster.h"
#include "Roster.h"
#include "common/CommandLine.h"
#include "common/Failure.h"
#include "common/OwnFiles.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace benchmark_planners
{
namespace
{

const char *const description =
    "Compares HexAStar with OMPL's planners on one nautical chart, or this project's planners of dives with OMPL's "
    "over\n"
    "one seabed: one SpaceInformation (R^2 or R^3, exact validity), one core, one time limit for all; start-goal "
    "pairs\n"
    "in all headings. Writes OMPL's benchmark logs, an SQLite database, plots (PNG) and one self-contained HTML page,\n"
    "and prints the table.";

const char *const footer =
    "Without --chart and --bathymetry the project's own chart of Shangchuan is taken. Database and page need the "
    "Debian\n"
    "packages ompl-demos and python3-matplotlib.\n"
    "With --bathymetry every dive is looked at once more, at a tenth of the raster's cells; one that does not keep "
    "the\n"
    "limits is counted as unsafe.\n"
    "A job is a pair: all planners, one after another, in a process of its own. A planner that crashes costs its own\n"
    "results only: the pair is run again, a process a planner, and the report names the crash. What has been run is\n"
    "kept in --out: the same command continues where it was stopped.\n"
    "Exit codes: 0 page written, or shard done; 2 usage, or the folder holds other settings; 3 chart or\n"
    "            seabed unreadable, damaged or without water; 4 no such pairs there; 7 the logs are there but the page "
    "is not,\n"
    "            for instance because a package is missing (--merge makes it later); 1 internal error.\n"
    "Examples:\n"
    "  benchmark_planners\n"
    "  benchmark_planners --chart maps/sanya.000 --pitch 100 --planners HexAStar,RRTstar,BITstar --time 5\n"
    "  benchmark_planners --bathymetry seabed.nc --clearance 50 --ceiling 10\n"
    "A campaign on many machines that share a folder, through GNU parallel or as a Slurm array, then its page:\n"
    "  parallel -j1 --sshloginfile hosts --wd . benchmark_planners --pairs 360 --runs 10 --shard {}/8 ::: {1..8}\n"
    "  sbatch --array=1-36 --cpus-per-task=2 --wrap \\\n"
    "    'benchmark_planners --pairs 360 --runs 10 --shard $SLURM_ARRAY_TASK_ID/36'\n"
    "  benchmark_planners --merge";

/// The texts of the command line, before they are checked.
struct Texts
{
    std::string shard;
    std::vector<std::string> merge;
};

std::string joined(const std::vector<std::string> &names)
{
    std::string text;
    for (const std::string &name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// A raster takes the place of chart, vessel and cells.
void declareDive(CLI::App &app, demos::DiveOptions &dive)
{
    demos::declareRaster(app, dive);
    demos::declareDiveLimits(app, dive);
    for (const char *option : {"--chart", "--draught", "--ukc", "--margin", "--pitch"})
        app.get_option("--bathymetry")->excludes(option);
    for (const char *option :
         {"--band", "--values", "--datum-offset", "--no-data", "--degrees", "--clearance", "--ceiling", "--deepest"})
        app.get_option(option)->needs("--bathymetry");
}

void declare(CLI::App &app, Options &o, Texts &t)
{
    app.footer(footer);
    demos::declareChart(app, o.charts);
    demos::declareVesselAndPitch(app, o, "metres");
    declareDive(app, o.dive);
    app.add_option("--planners", o.planners,
                   "which planners, separated by commas: on a chart " + joined(rosterNames()) + "; over a seabed " +
                       joined(diveRosterNames()) + " [all]")
        ->delimiter(',')
        ->type_name("NAME,...");
    app.add_option("--pairs", o.pairs, "start-goal pairs; pair k heads into the k-th sector of the compass")
        ->capture_default_str()
        ->type_name("N");
    app.add_option("--runs", o.runs, "runs of every planner on every pair; deterministic ones differ in time only")
        ->capture_default_str()
        ->type_name("N");
    app.add_option("--time", o.timeS, "time limit of a run, seconds")->capture_default_str()->type_name("S");
    app.add_option("--least-distance", o.leastDistance,
                   "least distance from start to goal, as a share of the diagonal of chart or seabed")
        ->capture_default_str()
        ->type_name("SHARE");
    app.add_option("--seed", o.seed, "seed of the pairs and of the planners")->capture_default_str()->type_name("N");
    app.add_option("--jobs", o.jobs, "jobs at a time, each on a core of its own")
        ->capture_default_str()
        ->type_name("N");
    app.add_option("--shard", t.shard, "run the i-th of n shares of the jobs only, and make no page")->type_name("I/N");
    app.add_option("--out", o.out, "folder of logs, database, plots and page")
        ->capture_default_str()
        ->type_name("FOLDER");
    app.add_option("--merge", t.merge,
                   "run nothing: make database, plots and page of what these folders hold (if none is named, --out)")
        ->expected(0, -1)
        ->type_name("FOLDER...");
    app.add_flag("--json", o.json, "print one JSON object instead of text");
}

[[noreturn]] void usage(const std::string &message)
{
    throw demos::Failure(demos::Exit::Usage, message);
}

Shard parseShard(const std::string &text)
{
    Shard shard;
    int end = 0;
    const int read = std::sscanf(text.c_str(), "%u/%u%n", &shard.index, &shard.count, &end);
    const bool isWhole = read == 2 && static_cast<std::size_t>(end) == text.size() &&
                         text.find_first_not_of("0123456789/") == std::string::npos;
    if (!isWhole || shard.index < 1 || shard.index > shard.count)
        usage("--shard must be I/N with I from 1 to N, such as 2/8, not '" + text + "'");
    return shard;
}

/// The names asked for in the roster's order, each once; all if none was.
std::vector<std::string> resolvePlanners(const std::vector<std::string> &asked, std::vector<std::string> known)
{
    for (const std::string &name : asked)
        if (std::find(known.begin(), known.end(), name) == known.end())
            usage("--planners: there is no planner '" + name + "'; known are " + joined(known));
    if (asked.empty())
        return known;
    std::vector<std::string> chosen;
    for (const std::string &name : known)
        if (std::find(asked.begin(), asked.end(), name) != asked.end())
            chosen.push_back(name);
    return chosen;
}

void checkNumbers(const Options &o)
{
    const auto within = [](const char *option, double value, double least, double most)
    {
        if (!(value >= least && value <= most))
            usage(std::string(option) + " must lie between " + demos::plain(least) + " and " + demos::plain(most) +
                  ", not " + demos::plain(value));
    };
    within("--pairs", o.pairs, 1, 9999);
    within("--runs", o.runs, 1, 9999);
    within("--time", o.timeS, 0.01, 86400);
    within("--least-distance", o.leastDistance, 0.01, 0.9);
    within("--jobs", o.jobs, 1, 1024);
}

void checkMerge(const CLI::App &app, Options &o, const Texts &t)
{
    if (app.count("--merge") == 0)
        return;
    if (app.count("--shard") > 0)
        usage("--merge runs no jobs, so --shard has no meaning with it");
    o.merge.emplace();
    for (const std::string &folder : t.merge)  // CLI11 gives one empty text for none
        if (!folder.empty())
            o.merge->push_back(folder);
    if (o.merge->empty())
        o.merge->push_back(o.out.string());
    else if (app.count("--out") == 0)
        o.out = o.merge->front();
}

}  // namespace

CommandLine readCommandLine(int argc, const char *const *argv)
{
    Options options;
    options.jobs = static_cast<unsigned>(allowedCores().size());
    Texts texts;
    CLI::App app(description, "benchmark_planners");
    declare(app, options, texts);
    if (const auto help = demos::parseCommandLine(app, argc, argv))
        return {std::nullopt, *help};
    demos::resolveVesselAndPitch(options);
    demos::resolveDive(options.dive);
    const bool isDive = !options.dive.bathymetry.empty();
    options.planners = resolvePlanners(options.planners, isDive ? diveRosterNames() : rosterNames());
    if (app.count("--shard") > 0)
        options.shard = parseShard(texts.shard);
    checkNumbers(options);
    checkMerge(app, options, texts);
    if (options.charts.empty() && !isDive && !options.merge)
        options.charts = {demos::ownChart("shangchuan.000")};
    return {options, ""};
}

}  // namespace benchmark_planners
