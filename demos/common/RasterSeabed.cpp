#include "RasterSeabed.h"

#include "Failure.h"

namespace demos
{
namespace
{

seahex::BathymetryRaster read(const DiveOptions &options, const std::optional<seahex::Box> &window)
{
    seahex::BathymetryOptions raster = options.raster;
    raster.window = window;
    try
    {
        return seahex::readBathymetry(options.bathymetry, raster);
    }
    catch (const seahex::BathymetryError &error)
    {
        throw Failure(Exit::Chart, error.what());
    }
}

}  // namespace

RasterSeabed readRaster(const DiveOptions &options, const std::optional<seahex::Box> &window)
{
    const seahex::BathymetryRaster raster = read(options, window);
    if (!raster.projection)
        throw Failure(Exit::Chart, options.bathymetry + ": its coordinates are metres, and positions are degrees; "
                                                        "gdalwarp -t_srs EPSG:4326 makes a raster in degrees of it");
    return {raster.seabed, *raster.projection};
}

}  // namespace demos
