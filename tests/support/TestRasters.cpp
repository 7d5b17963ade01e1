#include "support/TestRasters.h"

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace seahex::test
{
namespace
{

struct Close
{
    void operator()(GDALDataset *dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, Close>;

void demand(bool done, const std::string &what)
{
    if (!done)
        throw std::runtime_error("test raster: " + what + ": " + CPLGetLastErrorMsg());
}

}  // namespace

void writeRaster(const std::filesystem::path &path, const TestRaster &raster)
{
    GDALAllRegister();
    // Formats that can only be copied to are written by way of one in memory.
    GDALDriver *driver = GetGDALDriverManager()->GetDriverByName(raster.driver.c_str());
    demand(driver != nullptr, "no driver " + raster.driver);
    const bool creates = raster.driver == "GTiff";
    GDALDriver *writer = creates ? driver : GetGDALDriverManager()->GetDriverByName("MEM");
    std::vector<const char *> options;
    for (const std::string &option : raster.creation)
        options.push_back(option.c_str());
    options.push_back(nullptr);
    char **creation = const_cast<char **>(options.data());
    Dataset dataset(
        writer->Create(path.c_str(), raster.columns, raster.rows, 1, raster.type, creates ? creation : nullptr));
    demand(dataset != nullptr, "create " + path.string());
    if (raster.transform)
    {
        std::array<double, 6> transform = *raster.transform;
        demand(dataset->SetGeoTransform(transform.data()) == CE_None, "transform");
    }
    if (raster.epsg != 0)
    {
        OGRSpatialReference frame;
        demand(frame.importFromEPSG(raster.epsg) == OGRERR_NONE, "coordinate system");
        demand(dataset->SetSpatialRef(&frame) == CE_None, "coordinate system");
    }
    GDALRasterBand *band = dataset->GetRasterBand(1);
    if (raster.noData)
        band->SetNoDataValue(*raster.noData);
    if (raster.scale != 1.0 || raster.offset != 0.0)
    {
        band->SetScale(raster.scale);
        band->SetOffset(raster.offset);
    }
    if (!raster.unit.empty())
        band->SetUnitType(raster.unit.c_str());
    if (raster.palette)
    {
        GDALColorTable colours;
        const GDALColorEntry sand{200, 180, 120, 255};
        colours.SetColorEntry(0, &sand);
        demand(band->SetColorTable(&colours) == CE_None, "palette");
    }
    for (const auto &[key, value] : raster.bandMetadata)
        band->SetMetadataItem(key.c_str(), value.c_str());
    if (!raster.values.empty())
    {
        std::vector<double> values = raster.values;
        demand(band->RasterIO(GF_Write, 0, 0, raster.columns, raster.rows, values.data(), raster.columns, raster.rows,
                              GDT_Float64, 0, 0, nullptr) == CE_None,
               "write");
    }
    if (!creates)
    {
        const Dataset copy(driver->CreateCopy(path.c_str(), dataset.get(), FALSE, creation, nullptr, nullptr));
        demand(copy != nullptr, "copy to " + path.string());
    }
}

PlainRaster::PlainRaster(const std::filesystem::path &path)
{
    GDALAllRegister();
    const Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
    demand(dataset != nullptr, "open " + path.string());
    demand(dataset->GetGeoTransform(transform.data()) == CE_None, "transform");
    columns = dataset->GetRasterXSize();
    rows = dataset->GetRasterYSize();
    values.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    GDALRasterBand *band = dataset->GetRasterBand(1);
    demand(band->RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows, GDT_Float64, 0, 0, nullptr) ==
               CE_None,
           "read");
    int declared = 0;
    const double noData = band->GetNoDataValue(&declared);
    for (double &value : values)
        if (declared != 0 && value == noData)
            value = std::numeric_limits<double>::quiet_NaN();
}

double PlainRaster::bilinear(double x, double y) const
{
    const double column = (x - transform[0]) / transform[1] - 0.5;
    const double row = (y - transform[3]) / transform[5] - 0.5;
    constexpr double rounding = 1e-7;
    if (!(column >= -rounding && row >= -rounding && column <= columns - 1 + rounding && row <= rows - 1 + rounding))
        return std::numeric_limits<double>::quiet_NaN();
    const int i = std::clamp(static_cast<int>(std::floor(column)), 0, columns - 2);
    const int j = std::clamp(static_cast<int>(std::floor(row)), 0, rows - 2);
    const double u = column - i;
    const double v = row - j;
    return at(i, j) * (1 - u) * (1 - v) + at(i + 1, j) * u * (1 - v) + at(i, j + 1) * (1 - u) * v +
           at(i + 1, j + 1) * u * v;
}

}  // namespace seahex::test
