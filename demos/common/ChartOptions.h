#pragma once

#include <seahex/world/Vessel.h>

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace demos
{

/// What every program on a chart asks for: the chart, the vessel and the cells.
struct ChartOptions
{
    std::vector<std::string> charts;
    seahex::Vessel vessel;
    double pitch = 0.0;  ///< in the frame's unit; 0: automatic
    std::string pitchText = "auto";
};

/// Declares --chart.
void declareChart(CLI::App &app, std::vector<std::string> &charts);

/// Declares --draught, --ukc, --margin and --pitch.
/// @param pitchUnit  "metres", and what else it may be
void declareVesselAndPitch(CLI::App &app, ChartOptions &options, const std::string &pitchUnit);

/// Reads the pitch's text and checks the numbers.
/// @throws Failure (Exit::Usage) with one sentence
void resolveVesselAndPitch(ChartOptions &options);

/// @throws Failure (Exit::Usage) if a number that is given by an option is not finite or is negative
void requireNotNegative(const char *option, double value, const char *unit);

}  // namespace demos
