#include "Options.h"

#include "common/ChengScenario.h"
#include "common/CommandLine.h"
#include "common/Failure.h"
#include "common/OwnFiles.h"
#include "common/PlannerCatalogue.h"

#include <seahex/io/PositionParser.h>

#include <CLI/CLI.hpp>

#include <filesystem>

namespace plan_route
{
namespace
{

const char *const description =
    "Plans a safe route for a surface vessel on a nautical chart.\n"
    "NOT FOR NAVIGATION: bridges, overhead cables, restricted areas and traffic rules are reported, not yet obeyed.";

const char *const footer =
    "Exit codes: 0 a route; 2 usage; 3 chart unreadable, damaged or without water; 4 start or goal not navigable;\n"
    "            5 no route at this cell size; 6 out of time; 1 internal error.\n"
    "Examples:\n"
    "  plan_route --chart maps/shangchuan.000 --from 21.635,112.521 --to 21.669,112.901 --picture route.svg\n"
    "  plan_route --chart ENC_ROOT --from \"42 20.5N, 70 53.2W\" --to \"42 16.0N, 70 50.0W\" --draught 2 --margin 25 "
    "--json\n"
    "  plan_route --scenario cheng2020 --rings 1";

/// The texts of the command line, before they are checked.
struct Texts
{
    std::string from;
    std::string to;
    std::string guidance;
    std::string metric;
    std::string scenario;
    bool noSmoothing = false;
    bool pulled = false;
};

void declare(CLI::App &app, Options &o, Texts &t)
{
    app.footer(footer);
    demos::declareChart(app, o.charts);
    app.add_option("--from", t.from, "start: latitude,longitude in degrees or degrees and minutes")
        ->type_name("LAT,LON");
    app.add_option("--to", t.to, "goal")->type_name("LAT,LON");
    demos::declareVesselAndPitch(app, o, "metres (degrees with --scenario)");
    app.add_option("--cells", o.cells,
                   "keep the cells in this file: a later run with the same chart, vessel and cells takes them from "
                   "it, any other fills and replaces it")
        ->type_name("FILE");
    app.add_option("--rings", o.rings, "rings of successors, 1, 2 or 3: 6, 18 or 36 of them")
        ->capture_default_str()
        ->type_name("N");
    app.add_option("--guidance", t.guidance,
                   "what leads the search: none, distance, euclidean, cheng and wang (as published), tie_break "
                   "relaxed or automatic [automatic]")
        ->type_name("NAME");
    app.add_option("--metric", t.metric,
                   "what an edge costs: euclidean (metres) or lattice (steps between cells) [euclidean]")
        ->type_name("NAME");
    app.add_option("--planner", o.planner, "HexAStar, or another on the same arena: " + demos::plannerNames())
        ->capture_default_str()
        ->type_name("NAME");
    app.add_option("--time", o.timeS, "time limit of the search, seconds; sampling planners use all of it")
        ->capture_default_str()
        ->type_name("S");
    app.add_option("--seed", o.seed, "seed of sampling planners")->capture_default_str()->type_name("N");
    app.add_flag("--no-smoothing", t.noSmoothing, "leave the planner's path as it is");
    app.add_flag("--pulled", t.pulled,
                 "pull HexAStar's path taut and leave it at that; without it the route is the shortest of all, proven");
    app.add_option("--out", o.out, "write the route as GeoJSON")->type_name("FILE");
    app.add_flag("--blocked-cells", o.blockedCells, "put the blocked cells into that file too (large)");
    app.add_option("--picture", o.picture, "draw chart, cells and route")->type_name("FILE.svg|FILE.png");
    app.add_flag("--json", o.json, "print one JSON object instead of text");
    app.add_option("--scenario", t.scenario,
                   "cheng2020: the published chart window, lattice in degrees, start, goal, metric and "
                   "guidance, land only; other options win")
        ->type_name("NAME");
}

[[noreturn]] void usage(const std::string &message)
{
    throw demos::Failure(demos::Exit::Usage, message);
}

seahex::GeoPoint position(const std::string &option, const std::string &text)
{
    if (text.empty())
        usage(option + " is missing: a position such as 21.635,112.521 is needed");
    try
    {
        return seahex::parsePosition(text);
    }
    catch (const seahex::PositionError &error)
    {
        usage(option + ": " + error.what());
    }
}

void checkNumbers(const Options &o)
{
    demos::requireNotNegative("--time", o.timeS, "seconds");
    if (o.rings < 1 || o.rings > 3)
        usage("--rings must be 1, 2 or 3, not " + std::to_string(o.rings));
    if (!demos::isPlannerName(o.planner))
        usage("--planner: there is no planner '" + o.planner + "'; known are HexAStar, " + demos::plannerNames());
}

void requireDifferent(const char *option, const std::string &file, const char *other, const std::string &otherFile)
{
    if (file.empty() || otherFile.empty())
        return;
    std::error_code ignored;
    if (std::filesystem::absolute(file).lexically_normal() == std::filesystem::absolute(otherFile).lexically_normal() ||
        std::filesystem::equivalent(file, otherFile, ignored))
        usage(std::string(option) + " and " + other + " name the same file");
}

void checkFiles(const Options &o)
{
    const auto checkFolder = [&o](const char *option, const std::string &file)
    {
        if (file.empty())
            return;
        std::error_code ignored;
        const std::filesystem::path folder = std::filesystem::absolute(file, ignored).parent_path();
        if (!std::filesystem::is_directory(folder, ignored))
            usage(std::string(option) + ": there is no folder " + folder.string());
        if (std::filesystem::exists(file, ignored) && !std::filesystem::is_regular_file(file, ignored))
            usage(std::string(option) + " must name a file, and " + file + " is a folder or a device");
        for (const std::string &chart : o.charts)
            if (std::filesystem::equivalent(file, chart, ignored))
                usage(std::string(option) + " would overwrite the chart " + chart);
    };
    checkFolder("--out", o.out);
    checkFolder("--picture", o.picture);
    checkFolder("--cells", o.cells);
    if (o.blockedCells && o.out.empty())
        usage("--blocked-cells needs --out");
    requireDifferent("--out", o.out, "--picture", o.picture);
    requireDifferent("--out", o.out, "--cells", o.cells);
    requireDifferent("--picture", o.picture, "--cells", o.cells);
    if (o.picture.empty())
        return;
    const std::string extension = std::filesystem::path(o.picture).extension().string();
    if (extension != ".svg" && extension != ".png" && extension != ".SVG" && extension != ".PNG")
        usage("--picture must end in .svg or .png, not '" + o.picture + "'");
}

void applyScenario(const CLI::App &app, Options &o, Texts &t)
{
    if (t.scenario.empty())
        return;
    if (t.scenario != "cheng2020")
        usage("--scenario: there is no scenario '" + t.scenario + "'; known is cheng2020");
    for (const char *option : {"--draught", "--ukc"})
        if (app.count(option) > 0)
            usage(std::string(option) + " has no meaning with --scenario cheng2020, which knows land only");
    if (o.vessel.marginM != 0.0)
        usage("--margin in metres has no meaning with --scenario cheng2020, whose frame is in degrees");
    o.chengScenario = true;
    if (o.charts.empty())
        o.charts = {demos::ownChart(demos::cheng2020::chart)};
    if (t.from.empty())
        t.from = demos::cheng2020::from;
    if (t.to.empty())
        t.to = demos::cheng2020::to;
    if (t.guidance.empty())
        t.guidance = "cheng";
    if (t.metric.empty())
        t.metric = "lattice";
}

void resolve(const CLI::App &app, Options &o, Texts &t)
{
    applyScenario(app, o, t);
    if (o.charts.empty())
        usage("--chart is missing: a chart file or folder is needed");
    o.from = position("--from", t.from);
    o.to = position("--to", t.to);
    demos::resolveVesselAndPitch(o);
    o.smoothing = !t.noSmoothing;
    const std::string guidance = t.guidance.empty() ? "automatic" : t.guidance;
    if (!seahex::guidanceFromString(guidance))
        usage("--guidance must be one of " + seahex::guidanceNames() + ", not '" + guidance + "'");
    o.guidance = *seahex::guidanceFromString(guidance);
    const std::string metric = t.metric.empty() ? "euclidean" : t.metric;
    if (metric != "euclidean" && metric != "lattice")
        usage("--metric must be euclidean or lattice, not '" + metric + "'");
    o.metric = metric == "lattice" ? seahex::LengthMetric::Lattice : seahex::LengthMetric::Euclidean;
    // of others their own path is wanted, and published figures are those of paths pulled taut
    o.exact = !t.pulled && o.planner == "HexAStar" && o.metric == seahex::LengthMetric::Euclidean && !o.chengScenario;
    checkNumbers(o);
    checkFiles(o);
}

}  // namespace

CommandLine readCommandLine(int argc, const char *const *argv)
{
    Options options;
    Texts texts;
    CLI::App app(description, "plan_route");
    declare(app, options, texts);
    if (const auto help = demos::parseCommandLine(app, argc, argv))
        return {std::nullopt, *help};
    resolve(app, options, texts);
    return {options, ""};
}

}  // namespace plan_route
