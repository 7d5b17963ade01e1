#include "seahex/io/BathymetryReader.h"

#include "RasterBand.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

namespace seahex
{
namespace
{

/// No sea is deeper: a value beyond it marks missing data that nobody declared. The deepest sounding is 10,935 m, in
/// the Challenger Deep (GEBCO).
constexpr double DEEPEST_M = 12000.0;

/// Not deeper than the number it stands for.
float roundedUpwards(double depthM)
{
    const auto nearest = static_cast<float>(depthM);
    return static_cast<double>(nearest) > depthM ? std::nextafter(nearest, Bathymetry::unknownDepth) : nearest;
}

std::vector<float> allocate(const RasterBand &band, const PixelWindow &window, std::int64_t mostNodes)
{
    const std::int64_t count = std::int64_t(window.columns) * window.rows;
    const std::string size = std::to_string(window.columns) + " x " + std::to_string(window.rows) + " nodes";
    if (count > mostNodes)
        band.refuse(size + " are more than the " + std::to_string(mostNodes) + " allowed; give a window");
    try
    {
        return std::vector<float>(static_cast<std::size_t>(count), Bathymetry::unknownDepth);
    }
    catch (const std::bad_alloc &)
    {
        band.refuse(size + " do not fit into memory; give a window");
    }
}

}  // namespace

BathymetryRaster readBathymetry(const std::string &path, const BathymetryOptions &options)
{
    if (!std::isfinite(options.datumOffsetM))
        throw BathymetryError(path + ": a datum offset must be a number");
    const RasterBand band(path, options);
    const PixelWindow window = band.window(options.window);
    std::vector<float> depths = allocate(band, window, options.mostNodes);

    BathymetryRaster raster;
    raster.driver = band.driver();
    raster.areHeights = band.areHeights();
    raster.unknown = std::int64_t(window.columns) * window.rows;
    raster.deepestM = -std::numeric_limits<double>::infinity();
    band.forEachPiece(window,
                      [&](int column, int row, const double *values, int count)
                      {
                          const int fromTop = row - window.row;
                          const int fromSouth = band.isNorthUp() ? window.rows - 1 - fromTop : fromTop;
                          float *into =
                              depths.data() + std::ptrdiff_t(fromSouth) * window.columns + column - window.column;
                          for (int i = 0; i < count; ++i)
                          {
                              const double depth = (raster.areHeights ? -values[i] : values[i]) + options.datumOffsetM;
                              if (!std::isfinite(depth))
                                  continue;
                              if (depth > DEEPEST_M)
                                  band.refuse("value " + std::to_string(values[i]) + " at column " +
                                              std::to_string(column + i) + ", row " + std::to_string(row) +
                                              " is no depth of any sea; if it stands for missing data, say so");
                              into[i] = roundedUpwards(depth);
                              --raster.unknown;
                              raster.land += depth <= 0.0 ? 1 : 0;
                              raster.deepestM = std::max(raster.deepestM, depth);
                          }
                      });
    if (!std::isfinite(raster.deepestM))
        band.refuse("none of its " + std::to_string(depths.size()) + " nodes has a value");
    if (raster.deepestM <= 0.0)
        band.refuse("none of its nodes is under water: the deepest lies " + std::to_string(0.0 - raster.deepestM) +
                    " m above the datum, its values taken as " + (raster.areHeights ? "heights" : "depths"));

    const int southRow = band.isNorthUp() ? window.row + window.rows - 1 : window.row;
    Point southWest = band.centre(window.column, southRow);
    Point spacing = band.spacing();
    if (band.isInDegrees())
    {
        const Point middle = southWest + 0.5 * spacing.cwiseProduct(Point(window.columns - 1, window.rows - 1));
        raster.projection = Projection::localEquirectangular(GeoPoint::fromLonLat(middle.x(), middle.y()));
        const Point scale = metresPerDegree(middle.y());
        southWest = (southWest - middle).cwiseProduct(scale);
        spacing = spacing.cwiseProduct(scale);
    }
    raster.seabed = std::make_shared<const Bathymetry>(NodeGrid(southWest, spacing, window.columns, window.rows),
                                                       std::move(depths));
    return raster;
}

}  // namespace seahex
