#pragma once

#include "DiveOptions.h"

#include <seahex/chart/Projection.h>
#include <seahex/geometry/Box.h>
#include <seahex/world/Bathymetry.h>

#include <memory>
#include <optional>

namespace demos
{

/// The seabed of a raster in degrees, and the frame of its plane.
struct RasterSeabed
{
    std::shared_ptr<const seahex::Bathymetry> depths;
    seahex::Projection projection;
};

/// Reads --bathymetry.
/// @param window  the part to read, degrees; all of it if empty
/// @throws Failure (Exit::Chart) for what can't be read, is no seabed, or is not in degrees
RasterSeabed readRaster(const DiveOptions &options, const std::optional<seahex::Box> &window = std::nullopt);

}  // namespace demos
