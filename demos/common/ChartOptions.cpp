#include "ChartOptions.h"

#include "Failure.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace demos
{
namespace
{

double parsePitch(const std::string &text)
{
    if (text == "auto")
        return 0.0;
    double pitch = 0.0;
    if (!CLI::detail::lexical_cast(text, pitch) || !std::isfinite(pitch) || pitch <= 0.0)
        throw Failure(Exit::Usage, "--pitch must be a positive number of metres or auto, not '" + text + "'");
    return pitch;
}

}  // namespace

void declareChart(CLI::App &app, std::vector<std::string> &charts)
{
    app.add_option("--chart", charts,
                   "S-57 cell (.000; updates beside it are applied), folder of cells, or any OGR source whose "
                   "layers bear S-57 names; several may be given")
        ->type_name("FILE|FOLDER...");
}

void declareVesselAndPitch(CLI::App &app, ChartOptions &options, const std::string &pitchUnit)
{
    app.add_option("--draught", options.vessel.draughtM, "draught of the vessel, metres")
        ->capture_default_str()
        ->type_name("M");
    app.add_option("--ukc", options.vessel.underKeelClearanceM, "water that must remain under the keel, metres")
        ->capture_default_str()
        ->type_name("M");
    app.add_option("--margin", options.vessel.marginM, "least distance to any hazard, metres")
        ->capture_default_str()
        ->type_name("M");
    app.add_option("--pitch", options.pitchText,
                   "width of a cell, " + pitchUnit + "; auto: the larger of 20 m and what gives 4 million cells")
        ->capture_default_str()
        ->type_name("M|auto");
}

void resolveVesselAndPitch(ChartOptions &options)
{
    options.pitch = parsePitch(options.pitchText);
    requireNotNegative("--draught", options.vessel.draughtM, "metres");
    requireNotNegative("--ukc", options.vessel.underKeelClearanceM, "metres");
    requireNotNegative("--margin", options.vessel.marginM, "metres");
}

void requireNotNegative(const char *option, double value, const char *unit)
{
    if (!std::isfinite(value) || value < 0.0)
        throw Failure(Exit::Usage, std::string(option) + " must be 0 or more " + unit + ", not " + plain(value));
}

}  // namespace demos
