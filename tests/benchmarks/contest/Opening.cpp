#include "contest/Opening.h"

#include "contest/Stopwatch.h"

#include <seahex/chart/ChartReader.h>
#include <seahex/chart/HazardCatalogue.h>

#include <ogrsf_frmts.h>

#include <stdexcept>

namespace seahex::contest
{
namespace
{

bool isRead(const std::string &layer)
{
    const HazardClass *found = findHazardClass(layer);
    return layer == "M_COVR" || layer == "DEPCNT" ||
           (found != nullptr && (found->rule != HazardRule::Ignored || found->groupOne));
}

}  // namespace

double openMs(const std::string &chart)
{
    const Stopwatch watch;
    const Chart read = readChart(chart);
    return read.hazards.empty() ? throw std::runtime_error(chart + " has no hazards") : watch.ms();
}

double gdalReadMs(const std::string &chart)
{
    GDALAllRegister();
    const char *drivers[] = {"S57", nullptr};
    const char *options[] = {"UPDATES=APPLY", "SPLIT_MULTIPOINT=OFF", "LNAM_REFS=ON", "RETURN_PRIMITIVES=OFF", nullptr};
    const Stopwatch watch;
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(chart.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, options));
    if (!dataset)
        throw std::runtime_error("GDAL can't read " + chart);
    std::size_t geometries = 0;
    for (OGRLayer *layer : dataset->GetLayers())
        if (isRead(layer->GetName()))
            for (const auto &feature : *layer)
                geometries += feature->GetGeometryRef() != nullptr ? 1 : 0;
    return geometries == 0 ? throw std::runtime_error(chart + " has no geometries") : watch.ms();
}

}  // namespace seahex::contest
