#pragma once

#include <seahex/io/BathymetryReader.h>
#include <seahex/world/DiveArena.h>

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace demos
{

/// What every program on dives asks for: the raster of the seabed, and the limits of the vehicle.
struct DiveOptions
{
    std::string bathymetry;  ///< raster; empty: none was named
    seahex::BathymetryOptions raster;
    seahex::DiveLimits limits;

    // The texts of the command line, before they are checked.
    std::string valuesText = "auto";
    std::optional<double> noDataText;
    bool inDegrees = false;
};

/// Declares --bathymetry, and how it is read: --band, --values, --datum-offset, --no-data and --degrees.
void declareRaster(CLI::App &app, DiveOptions &options);

/// Declares --clearance, --ceiling and --deepest.
void declareDiveLimits(CLI::App &app, DiveOptions &options);

/// Reads the texts and checks the numbers.
/// @throws Failure (Exit::Usage) with one sentence
void resolveDive(DiveOptions &options);

}  // namespace demos
