#include "SoundingSurface.h"

#include "GdalDataset.h"

#include <gdal_alg.h>

#include <limits>

namespace seahex
{

std::vector<float> soundingSurface(const std::vector<PlaneSounding> &soundings, const NodeGrid &grid)
{
    const float none = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> surface(static_cast<std::size_t>(grid.nodeCount()), none);
    if (soundings.size() < 3)
        return surface;
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> z;
    for (const PlaneSounding &sounding : soundings)
    {
        x.push_back(sounding.position.x());
        y.push_back(sounding.position.y());
        z.push_back(sounding.depthM);
    }
    GDALGridLinearOptions options{};
    options.nSizeOfStructure = sizeof options;
    options.dfRadius = 0.0;
    options.dfNoDataValue = static_cast<double>(none);
    const DriverMessages quiet;
    // GDAL counts from the outer edges of cells whose centres are our nodes.
    const Point low = grid.bounds().min - 0.5 * grid.spacing();
    const Point high = grid.bounds().max + 0.5 * grid.spacing();
    if (GDALGridCreate(GGA_Linear, &options, static_cast<GUInt32>(soundings.size()), x.data(), y.data(), z.data(),
                       low.x(), high.x(), low.y(), high.y(), static_cast<GUInt32>(grid.columns()),
                       static_cast<GUInt32>(grid.rows()), GDT_Float32, surface.data(), nullptr, nullptr) != CE_None)
        surface.assign(surface.size(), none);
    return surface;
}

}  // namespace seahex
