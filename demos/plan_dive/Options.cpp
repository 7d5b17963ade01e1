#include "Options.h"

#include "PlannerOptions.h"
#include "common/ChartOptions.h"
#include "common/CommandLine.h"
#include "common/Failure.h"

#include <seahex/io/PositionParser.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <filesystem>
#include <limits>

namespace plan_dive
{
namespace
{

const char *const description =
    "Plans a safe dive for an underwater vehicle over a real seabed.\n"
    "NOT FOR NAVIGATION: a raster knows nothing of wrecks, nets and traffic, a chart promises depths, not free water.";

const char *const footer =
    "A position with its depth is LAT,LON@METRES: 39.5,12.5@1500. Depths count down from the seabed's datum.\n"
    "Exit codes: 0 a dive; 2 usage; 3 seabed or chart unreadable, damaged or without water; 4 start or goal not\n"
    "            navigable; 5 no dive at this resolution; 6 out of time; 1 internal error.\n"
    "Examples:\n"
    "  plan_dive --bathymetry seabed.nc --from 38.5,3.5@300 --to 39.5,12.5@1500 --clearance 50 --profile profile.svg\n"
    "  plan_dive --chart maps/sanya.000 --from 18.15,109.38@4 --to 18.13,109.75@6 --clearance 2 --planner BITstar";

/// The texts of the command line, before they are checked.
struct Texts
{
    std::string from;
    std::string to;
    std::string spacing = "auto";
    PlannerTexts planner;
    std::string chartDepths = "least";
};

void declareSeabed(CLI::App &app, Options &o, Texts &t)
{
    demos::declareRaster(app, o);
    demos::declareChart(app, o.charts);
    app.add_option("--spacing", t.spacing,
                   "width of the chart's cells, metres; auto: the larger of 20 m and what gives 4 million cells")
        ->capture_default_str()
        ->type_name("M|auto");
    app.add_option("--chart-depths", t.chartDepths,
                   "between soundings: least (what depth areas promise) or interpolated (soundings and contours)")
        ->capture_default_str()
        ->type_name("NAME");
    app.add_option("--margin", o.marginM, "least distance to what stands in the chart's water, metres")
        ->capture_default_str()
        ->type_name("M");
    app.add_option("--cross-cables", o.crossCablesM,
                   "cross the chart's submarine cables and cable areas above them, so many metres higher than the "
                   "clearance over bare seabed [cables are kept out of at every depth]")
        ->type_name("M");
}

void declareDive(CLI::App &app, Options &o, Texts &t)
{
    app.add_option("--from", t.from, "start, and its depth in metres")->type_name("LAT,LON@M");
    app.add_option("--to", t.to, "goal, and its depth")->type_name("LAT,LON@M");
    demos::declareDiveLimits(app, o);
}

void declareOutput(CLI::App &app, Options &o)
{
    app.add_option("--out", o.out, "write the dive as GeoJSON, heights below the datum negative")->type_name("FILE");
    app.add_option("--profile", o.profile, "draw the vertical section along the track")->type_name("FILE.svg|FILE.png");
    app.add_option("--picture3d", o.picture, "draw seabed and dive in three dimensions")
        ->type_name("FILE.svg|FILE.png");
    app.add_flag("--json", o.json, "print one JSON object instead of text");
}

[[noreturn]] void usage(const std::string &message)
{
    throw demos::Failure(demos::Exit::Usage, message);
}

/// "39.5,12.5@1500"
DivePosition divePosition(const std::string &option, const std::string &text)
{
    const std::size_t at = text.rfind('@');
    if (at == std::string::npos)
        usage(option + (text.empty() ? " is missing: a" : ": '" + text + "' has no depth; a") +
              " position with its depth such as 39.5,12.5@1500 is needed");
    double depthM = 0.0;
    if (!CLI::detail::lexical_cast(text.substr(at + 1), depthM) || !std::isfinite(depthM))
        usage(option + ": '" + text.substr(at + 1) + "' is no depth in metres");
    try
    {
        return {seahex::parsePosition(text.substr(0, at)), depthM};
    }
    catch (const seahex::PositionError &error)
    {
        usage(option + ": " + error.what());
    }
}

void checkNumbers(const Options &o)
{
    demos::requireNotNegative("--margin", o.marginM, "metres");
    if (o.crossCablesM)
        demos::requireNotNegative("--cross-cables", *o.crossCablesM, "metres");
    if (o.crossCablesM && o.charts.empty())
        usage("--cross-cables needs --chart: a raster knows no cables");
}

void checkFiles(const Options &o)
{
    namespace fs = std::filesystem;
    const std::vector<std::pair<const char *, const std::string *>> files = {
        {"--out", &o.out}, {"--profile", &o.profile}, {"--picture3d", &o.picture}};
    std::error_code ignored;
    for (const auto &[option, file] : files)
    {
        if (file->empty())
            continue;
        const fs::path path = fs::absolute(*file, ignored).lexically_normal();
        if (!fs::is_directory(path.parent_path(), ignored))
            usage(std::string(option) + ": there is no folder " + path.parent_path().string());
        if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
            usage(std::string(option) + " must name a file, and " + *file + " is a folder or a device");
        std::vector<std::string> sources = o.charts;
        sources.push_back(o.bathymetry);
        for (const std::string &source : sources)
            if (fs::equivalent(path, source, ignored))
                usage(std::string(option) + " would overwrite " + source);
        for (const auto &[other, name] : files)
            if (other != option && !name->empty() && fs::absolute(*name, ignored).lexically_normal() == path)
                usage(std::string(option) + " and " + other + " name the same file");
        const std::string extension = path.extension().string();
        if (file != &o.out && extension != ".svg" && extension != ".png" && extension != ".SVG" && extension != ".PNG")
            usage(std::string(option) + " must end in .svg or .png, not '" + *file + "'");
    }
}

void resolve(const CLI::App &app, Options &o, const Texts &t)
{
    if (o.bathymetry.empty() && o.charts.empty())
        usage("--bathymetry or --chart is missing: a seabed is needed");
    if (t.chartDepths != "least" && t.chartDepths != "interpolated")
        usage("--chart-depths must be least or interpolated, not '" + t.chartDepths + "'");
    o.from = divePosition("--from", t.from);
    o.to = divePosition("--to", t.to);
    if (t.chartDepths == "interpolated")
        o.chartDepths = seahex::ChartDepths::Interpolated;
    o.spacingM = positiveOrAuto("--spacing", t.spacing);
    demos::resolveDive(o);
    checkNumbers(o);
    resolvePlanner(app, o, t.planner);
    checkFiles(o);
}

}  // namespace

CommandLine readCommandLine(int argc, const char *const *argv)
{
    Options options;
    Texts texts;
    CLI::App app(description, "plan_dive");
    app.footer(footer);
    declareSeabed(app, options, texts);
    declareDive(app, options, texts);
    declarePlanner(app, options, texts.planner);
    declareOutput(app, options);
    if (const auto help = demos::parseCommandLine(app, argc, argv))
        return {std::nullopt, *help};
    resolve(app, options, texts);
    return {options, ""};
}

}  // namespace plan_dive
