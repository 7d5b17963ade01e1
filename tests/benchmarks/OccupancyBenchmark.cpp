// Filling cells from polygons against GDAL's rasteriser, both in memory, one thread, the same projected polygons, as
// many cells. Read the ratio of the two within one run; times alone mean little on a shared machine.

#include <seahex/chart/ChartReader.h>
#include <seahex/chart/Projection.h>
#include <seahex/geometry/HexLattice.h>
#include <seahex/world/BlockingRule.h>
#include <seahex/world/OccupancyBuilder.h>

#include <benchmark/benchmark.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_geometry.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>

namespace
{

using seahex::Box;
using seahex::Point;

/// The polygons that block a small vessel on a chart, in metres.
struct World
{
    std::vector<seahex::Shape> shapes;
    Box box;
};

std::string chartPath()
{
    const char *data = std::getenv("SEAHEX_TEST_DATA");
    return data == nullptr ? "" : std::string(data) + "/charts/generated/ZZ3NORWY.000";
}

const World &norway()
{
    static const World world = []
    {
        World w;
        const seahex::Chart chart = seahex::readChart(chartPath());
        const auto projection = seahex::Projection::transverseMercator(chart.bounds.centre());
        for (const seahex::Hazard &hazard : projectHazards(chart, projection))
            if (!hazard.shape.areas.empty() && judge(*hazard.object, seahex::Vessel()).blocks())
                w.shapes.push_back(hazard.shape);
        const seahex::Shape coverage = projection.forward(chart.coverage);
        w.box.min = w.box.max = coverage.areas.front().outer().front();
        for (const Point &p : coverage.areas.front().outer())
        {
            w.box.min = w.box.min.cwiseMin(p);
            w.box.max = w.box.max.cwiseMax(p);
        }
        return w;
    }();
    return world;
}

bool skipWithoutChart(benchmark::State &state)
{
    if (chartPath().empty())
    {
        state.SkipWithError("SEAHEX_TEST_DATA is not set: no chart to fill from");
        return true;
    }
    return false;
}

void fillHexagons(benchmark::State &state)
{
    if (skipWithoutChart(state))
        return;
    const World &world = norway();
    const Point extent = world.box.max - world.box.min;
    const auto cells = static_cast<double>(state.range(0));
    const double pitch = std::sqrt(extent.x() * extent.y() / cells / (0.5 * std::sqrt(3.0)));
    const seahex::HexLattice lattice = seahex::HexLattice::covering(world.box, pitch);
    std::int64_t blocked = 0;
    for (auto _ : state)
    {
        seahex::OccupancyBuilder builder(lattice);
        for (const seahex::Shape &shape : world.shapes)
            builder.block(shape, 0.0);
        blocked = builder.build()->blockedCount();
        benchmark::DoNotOptimize(blocked);
    }
    state.counters["cells"] = static_cast<double>(lattice.cellCount());
    state.counters["blocked"] = static_cast<double>(blocked);
}

std::unique_ptr<OGRPolygon> toOgr(const seahex::Polygon &polygon)
{
    auto result = std::make_unique<OGRPolygon>();
    const auto add = [&result](const seahex::Ring &ring)
    {
        auto *line = new OGRLinearRing();
        for (const Point &p : ring)
            line->addPoint(p.x(), p.y());
        result->addRingDirectly(line);
    };
    add(polygon.outer());
    for (const seahex::Ring &hole : polygon.inners())
        add(hole);
    return result;
}

void rasterizeSquares(benchmark::State &state)
{
    if (skipWithoutChart(state))
        return;
    GDALAllRegister();
    const World &world = norway();
    std::vector<std::unique_ptr<OGRPolygon>> polygons;
    std::vector<OGRGeometryH> handles;
    for (const seahex::Shape &shape : world.shapes)
        for (const seahex::Polygon &area : shape.areas)
        {
            polygons.push_back(toOgr(area));
            handles.push_back(OGRGeometry::ToHandle(polygons.back().get()));
        }
    const Point extent = world.box.max - world.box.min;
    const double size = std::sqrt(extent.x() * extent.y() / static_cast<double>(state.range(0)));
    const int columns = static_cast<int>(std::ceil(extent.x() / size));
    const int rows = static_cast<int>(std::ceil(extent.y() / size));
    double transform[6] = {world.box.min.x(), size, 0.0, world.box.max.y(), 0.0, -size};
    char allTouched[] = "ALL_TOUCHED=TRUE";
    char *options[] = {allTouched, nullptr};
    int band = 1;
    const std::vector<double> burn(handles.size(), 1.0);
    for (auto _ : state)
    {
        GDALDataset *raster =
            GetGDALDriverManager()->GetDriverByName("MEM")->Create("", columns, rows, 1, GDT_Byte, nullptr);
        raster->SetGeoTransform(transform);
        GDALRasterizeGeometries(raster, 1, &band, static_cast<int>(handles.size()), handles.data(), nullptr, nullptr,
                                burn.data(), options, nullptr, nullptr);
        GDALClose(raster);
    }
    state.counters["cells"] = static_cast<double>(columns) * rows;
}

}  // namespace

BENCHMARK(fillHexagons)->Arg(4000000)->Unit(benchmark::kMillisecond)->MinTime(1.0);
BENCHMARK(rasterizeSquares)->Arg(4000000)->Unit(benchmark::kMillisecond)->MinTime(1.0);
