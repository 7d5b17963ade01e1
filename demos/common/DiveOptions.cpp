#include "DiveOptions.h"

#include "ChartOptions.h"
#include "Failure.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace demos
{
namespace
{

[[noreturn]] void usage(const std::string &message)
{
    throw Failure(Exit::Usage, message);
}

void checkLimits(const seahex::DiveLimits &limits)
{
    requireNotNegative("--clearance", limits.clearanceM, "metres");
    requireNotNegative("--ceiling", limits.ceilingM, "metres");
    if (!(limits.deepestM > limits.ceilingM))
        usage("--deepest must be below the ceiling of " + plain(limits.ceilingM) + " m, not " + plain(limits.deepestM) +
              " m");
}

}  // namespace

void declareRaster(CLI::App &app, DiveOptions &options)
{
    app.add_option("--bathymetry", options.bathymetry,
                   "raster of heights or depths in degrees: GeoTIFF, netCDF, ASCII grid, whatever GDAL reads")
        ->type_name("RASTER");
    app.add_option("--band", options.raster.band, "of the raster")->capture_default_str()->type_name("N");
    app.add_option("--values", options.valuesText, "the raster's values: auto, heights (positive up) or depths")
        ->capture_default_str()
        ->type_name("NAME");
    app.add_option("--datum-offset", options.raster.datumOffsetM, "added to every depth of the raster, metres")
        ->capture_default_str()
        ->type_name("M");
    app.add_option("--no-data", options.noDataText, "a value of the raster that means none")->type_name("VALUE");
    app.add_flag("--degrees", options.inDegrees, "the raster's coordinates are degrees though it doesn't say so");
}

void declareDiveLimits(CLI::App &app, DiveOptions &options)
{
    app.add_option("--clearance", options.limits.clearanceM, "least water between vehicle and seabed, metres")
        ->capture_default_str()
        ->type_name("M");
    app.add_option("--ceiling", options.limits.ceilingM, "least depth of the vehicle, metres; 0: it may surface")
        ->capture_default_str()
        ->type_name("M");
    app.add_option("--deepest", options.limits.deepestM, "greatest depth that it bears, metres [none]")->type_name("M");
}

void resolveDive(DiveOptions &options)
{
    if (options.valuesText != "auto" && options.valuesText != "heights" && options.valuesText != "depths")
        usage("--values must be auto, heights or depths, not '" + options.valuesText + "'");
    if (options.valuesText != "auto")
        options.raster.values =
            options.valuesText == "heights" ? seahex::RasterValues::Heights : seahex::RasterValues::Depths;
    if (options.inDegrees)
        options.raster.coordinates = seahex::RasterCoordinates::Degrees;
    options.raster.noData = options.noDataText;
    if (options.raster.band < 1)
        usage("--band must be 1 or more, not " + std::to_string(options.raster.band));
    if (!std::isfinite(options.raster.datumOffsetM))
        usage("--datum-offset must be a number of metres");
    checkLimits(options.limits);
}

}  // namespace demos
