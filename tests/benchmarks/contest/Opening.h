#pragma once

#include <string>

namespace seahex::contest
{

/// Wall time of reading an S-57 cell with the library, all its checks included, milliseconds.
double openMs(const std::string &chart);

/// The same for GDAL alone: opened as the library opens it, every feature with its geometry of every layer that the
/// library reads (the hazard catalogue's and the coverage).
/// @throws std::runtime_error if GDAL can't read it
double gdalReadMs(const std::string &chart);

}  // namespace seahex::contest
