#pragma once

#include <seahex/chart/Projection.h>
#include <seahex/geometry/Box.h>
#include <seahex/world/Bathymetry.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace seahex
{

/// A raster that is no bathymetry, or can't be read. One sentence that names file, band, and the value at fault.
class BathymetryError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// What a raster's values are, once scaled.
enum class RasterValues
{
    Automatic,  ///< depths if the band says `positive = down` or has a standard_name of depths (CF), else heights
    Heights,    ///< positive up
    Depths      ///< positive down
};

/// What a raster's coordinates are.
enum class RasterCoordinates
{
    Automatic,  ///< by the coordinate system; without one by the axes' units (netCDF); else the raster is refused
    Degrees,    ///< longitude and latitude
    Metres      ///< of a plane
};

struct BathymetryOptions
{
    int band = 1;
    RasterValues values = RasterValues::Automatic;
    RasterCoordinates coordinates = RasterCoordinates::Automatic;
    /// Added to every depth, metres: -1.2 if the raster counts from a mean sea level 1.2 m above the datum wanted.
    double datumOffsetM = 0.0;
    /// A value, before scaling, that means "none", besides those that the raster itself declares.
    std::optional<double> noData;
    /// Part to read, in the raster's coordinates (degrees, or metres): the fewest nodes that enclose what of it lies on
    /// the raster.
    std::optional<Box> window;
    /// More nodes than that are refused; the default takes 1 GB.
    std::int64_t mostNodes = 250000000;
};

struct BathymetryRaster
{
    std::shared_ptr<const Bathymetry> seabed;
    /// The frame of a raster in degrees: Projection::localEquirectangular at the middle of the nodes read, so that the
    /// seabed's plane is an affine image of longitude and latitude. Empty for a raster in metres, which keeps its own:
    /// those of its projection, which need not be metres on the ground (Mercator).
    std::optional<Projection> projection;
    std::string driver;        ///< "GTiff"
    bool areHeights = true;    ///< what its values were taken for
    std::int64_t unknown = 0;  ///< nodes without depth
    std::int64_t land = 0;     ///< nodes not below the datum
    double deepestM = 0.0;     ///< greatest depth of a node
};

/// Reads one band of any raster that GDAL knows (GeoTIFF, netCDF, ASCII grid, ...); a netCDF file of several grids by
/// GDAL's name of one of them: NETCDF:"file.nc":elevation.
///
/// Nodes are the centres of pixels, rows may run either way. Scale and offset of the band are applied; what the band
/// declares or masks as no data, and what is no finite number, is unknown. Depths are rounded to floats towards the
/// surface, never down. Positions are taken as WGS-84, whatever datum a raster in degrees names. Read by the file's
/// own blocks, so that little more is held than the nodes themselves.
///
/// @throws BathymetryError for a file that is missing, damaged or no raster; a band that isn't there, is complex, is a
///         picture, or not in metres; a raster that is rotated, mirrored, without place, without coordinate system (see
///         RasterCoordinates) or with fewer than 2 x 2 nodes; a window beside it; too many nodes; a depth beyond 12 km;
///         and where all nodes are unknown, or none is below the datum
BathymetryRaster readBathymetry(const std::string &path, const BathymetryOptions &options = {});

}  // namespace seahex
