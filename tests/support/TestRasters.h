#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gdal.h>

namespace seahex::test
{

/// A raster to write. Values run row by row as the file has them.
struct TestRaster
{
    int columns = 0;
    int rows = 0;
    std::vector<double> values;
    /// GDAL's: x and y of the first pixel's outer corner, steps and shears; none if empty.
    std::optional<std::array<double, 6>> transform = std::array<double, 6>{0.0, 1.0, 0.0, 0.0, 0.0, -1.0};
    GDALDataType type = GDT_Float32;
    int epsg = 32649;  ///< 0 for none; 32649 is UTM, 4326 degrees
    std::optional<double> noData;
    double scale = 1.0;
    double offset = 0.0;
    std::string unit;
    bool palette = false;               ///< values are numbers of colours
    std::vector<std::string> creation;  ///< options of GDAL's driver: "TILED=YES"
    std::string driver = "GTiff";
    std::vector<std::pair<std::string, std::string>> bandMetadata;
};

/// @throws std::runtime_error if GDAL refuses
void writeRaster(const std::filesystem::path &path, const TestRaster &raster);

/// A raster as GDAL reads it, for judges that share no code with the library: raw values of band 1 in doubles, what is
/// declared as no data not a number.
struct PlainRaster
{
    explicit PlainRaster(const std::filesystem::path &path);

    double at(int column, int row) const
    {
        return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                      static_cast<std::size_t>(column)];
    }
    /// Bilinear between the centres of pixels at a position in the raster's own coordinates; not a number outside.
    double bilinear(double x, double y) const;

    int columns = 0;
    int rows = 0;
    std::array<double, 6> transform{};
    std::vector<double> values;
};

}  // namespace seahex::test
