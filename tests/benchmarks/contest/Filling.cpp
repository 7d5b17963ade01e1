#include "contest/Filling.h"

#include "contest/Stopwatch.h"

#include <seahex/world/OccupancyBuilder.h>

#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>

#include <cmath>
#include <stdexcept>

namespace seahex::contest
{
namespace
{

std::unique_ptr<OGRPolygon> toOgr(const Polygon &polygon)
{
    auto result = std::make_unique<OGRPolygon>();
    const auto add = [&result](const Ring &ring)
    {
        auto line = std::make_unique<OGRLinearRing>();
        for (const Point &p : ring)
            line->addPoint(p.x(), p.y());
        result->addRingDirectly(line.release());
    };
    add(polygon.outer());
    for (const Ring &hole : polygon.inners())
        add(hole);
    return result;
}

}  // namespace

double fillMs(const World &world)
{
    const Stopwatch watch;
    OccupancyBuilder<HexLattice> builder(world.occupancy->lattice());
    for (const Shape &shape : world.land)
        builder.block(shape, 0.0);
    const auto filled = builder.build();
    const double ms = watch.ms();
    if (filled->blockedCount() != world.occupancy->blockedCount())
        throw std::runtime_error("filling twice gave two occupancies");
    return ms;
}

double rasterizeMs(const World &world)
{
    GDALAllRegister();
    std::vector<std::unique_ptr<OGRPolygon>> polygons;
    std::vector<OGRGeometryH> handles;
    for (const Shape &shape : world.land)
        for (const Polygon &area : shape.areas)
        {
            polygons.push_back(toOgr(area));
            handles.push_back(OGRGeometry::ToHandle(polygons.back().get()));
        }
    const HexLattice &lattice = world.occupancy->lattice();
    const Box box = lattice.bounds();
    const Point extent = box.max - box.min;
    const double size = std::sqrt(extent.x() * extent.y() / static_cast<double>(lattice.cellCount()));
    double transform[6] = {box.min.x(), size, 0.0, box.max.y(), 0.0, -size};
    char allTouched[] = "ALL_TOUCHED=TRUE";
    char *options[] = {allTouched, nullptr};
    int band = 1;
    const std::vector<double> burn(handles.size(), 1.0);

    const Stopwatch watch;
    const GDALDatasetUniquePtr raster(GetGDALDriverManager()->GetDriverByName("MEM")->Create(
        "", static_cast<int>(std::ceil(extent.x() / size)), static_cast<int>(std::ceil(extent.y() / size)), 1, GDT_Byte,
        nullptr));
    if (!raster || raster->SetGeoTransform(transform) != CE_None ||
        GDALRasterizeGeometries(raster.get(), 1, &band, static_cast<int>(handles.size()), handles.data(), nullptr,
                                nullptr, burn.data(), options, nullptr, nullptr) != CE_None)
        throw std::runtime_error("GDAL can't rasterise the land");
    return watch.ms();
}

}  // namespace seahex::contest
