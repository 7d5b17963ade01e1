#include "Options.h"

#include "common/CommandLine.h"
#include "common/Failure.h"
#include "common/OwnFiles.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace reproduce_papers
{
namespace
{

namespace fs = std::filesystem;

const char *const description =
    "Runs the experiments of [Cheng2020] and [Wang2017] on this project's charts, and that of [Xu] on random "
    "terrains:\n"
    "prints the papers' tables beside its own, draws their figures, and tries every claim on random pairs or terrains.";

const char *const footer =
    "[Cheng2020]  doi 10.3969/j.issn.1673-629X.2020.11.007: hexagons, a guide, more neighbours.\n"
    "[Wang2017]   doi 10.1007/978-3-319-65978-7_80: safety weights, pilot quantity, smoothing.\n"
    "[Xu]         Xu Yanmin, Chang Zheng, Zhao Junchao and others: dives through slices of the water column.\n"
    "Writes the figures and report.json into --out. Random pairs are drawn on the project's two charts and on those "
    "of\n"
    "--charts.\n"
    "Exit codes: 0 done; 2 usage, or the folder can't be written; 3 a chart is unreadable, damaged or without water;\n"
    "            4 no pairs on a chart; 5 no route in a published window; 1 internal error.\n"
    "Examples:\n"
    "  reproduce_papers\n"
    "  reproduce_papers --charts my_charts --pairs 1000 --out /tmp/reproduction";

/// All cells (*.000) in a folder and below, or the file itself.
std::vector<std::string> chartsAt(const std::string &path)
{
    std::error_code error;
    if (!fs::is_directory(path, error))
        return {path};
    std::vector<std::string> charts;
    for (fs::recursive_directory_iterator it(path, error), end; !error && it != end; it.increment(error))
        if (it->path().extension() == ".000")
            charts.push_back(it->path().string());
    std::sort(charts.begin(), charts.end());
    if (error || charts.empty())
        throw demos::Failure(demos::Exit::Chart,
                             "--charts: the folder " + path + " " +
                                 (error ? "can't be read: " + error.message() : std::string("holds no chart (*.000)")));
    return charts;
}

[[noreturn]] void usage(const std::string &message)
{
    throw demos::Failure(demos::Exit::Usage, message);
}

void check(const Options &o)
{
    if (o.claims.pairs < 1 || o.claims.pairs > 100000)
        usage("--pairs must be 1 to 100000, not " + std::to_string(o.claims.pairs));
    if (!(o.claims.cells >= 1000.0) || o.claims.cells > 1e7)
        usage("--cells must be 1000 to 1e7, not " + demos::plain(o.claims.cells));
    if (o.claims.threads < 1 || o.claims.threads > 256)
        usage("--threads must be 1 to 256, not " + std::to_string(o.claims.threads));
    if (o.xu.terrains < 1 || o.xu.terrains > 100000)
        usage("--terrains must be 1 to 100000, not " + std::to_string(o.xu.terrains));
    if (o.format != "png" && o.format != "svg")
        usage("--format must be png or svg, not '" + o.format + "'");
    if (o.out.empty())
        usage("--out is empty");
}

}  // namespace

CommandLine readCommandLine(int argc, const char *const *argv)
{
    Options o;
    std::vector<std::string> charts;
    CLI::App app(description, "reproduce_papers");
    app.footer(footer);
    app.add_option("--charts", charts, "further S-57 charts for the random pairs: files, or folders of *.000")
        ->type_name("PATH...");
    app.add_option("--pairs", o.claims.pairs, "random pairs on each chart; pair k heads into the k-th sector")
        ->capture_default_str()
        ->type_name("N");
    app.add_option("--cells", o.claims.cells, "hexagons over each chart; [Cheng2020] has 22737")
        ->capture_default_str()
        ->type_name("N");
    app.add_option("--terrains", o.xu.terrains, "random terrains for the dives of [Xu]")
        ->capture_default_str()
        ->type_name("N");
    app.add_option("--seed", o.claims.seed, "seed of pairs and terrains")->capture_default_str()->type_name("N");
    app.add_option("--threads", o.claims.threads, "threads for random pairs and terrains")
        ->capture_default_str()
        ->type_name("N");
    app.add_option("--out", o.out, "folder of the figures and report.json")->capture_default_str()->type_name("FOLDER");
    app.add_option("--format", o.format, "of the figures: png or svg")->capture_default_str()->type_name("FORMAT");
    app.add_flag("--json", o.json, "print report.json instead of text");
    if (const auto help = demos::parseCommandLine(app, argc, argv))
        return {std::nullopt, *help};
    check(o);
    o.xu.seed = o.claims.seed;
    o.xu.threads = o.claims.threads;
    o.claims.charts = {demos::ownChart("shangchuan.000"), demos::ownChart("sanya.000")};
    for (const std::string &path : charts)
        for (const std::string &chart : chartsAt(path))
            o.claims.charts.push_back(chart);
    return {o, ""};
}

}  // namespace reproduce_papers
