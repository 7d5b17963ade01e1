#pragma once

#include "contest/World.h"

namespace seahex::contest
{

/// Wall time of filling the world's lattice from its land anew, milliseconds.
double fillMs(const World &world);

/// The same for GDAL's rasteriser (GDALRasterizeGeometries, all touched) and a raster in memory of as many square cells
/// over the same box, one byte each. Making GDAL's polygons is not counted.
/// @throws std::runtime_error if GDAL refuses
double rasterizeMs(const World &world);

}  // namespace seahex::contest
