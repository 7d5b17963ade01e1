#include "contest/World.h"

#include "contest/Archipelago.h"

#include <seahex/chart/ChartReader.h>
#include <seahex/chart/Projection.h>
#include <seahex/world/BlockingRule.h>
#include <seahex/world/OccupancyBuilder.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>

namespace seahex::contest
{
namespace
{

/// A window of a chart.
struct Window
{
    std::string chart;
    GeoBox box;
    double pitchM;
    /// Of the lattice; as many as cover the window if empty.
    std::optional<OffsetCoord> size;
    std::string what;
};

std::string norwayChart()
{
    const char *data = std::getenv("SEAHEX_TEST_DATA");
    return data == nullptr ? "" : std::string(data) + "/charts/generated/ZZ3NORWY.000";
}

std::optional<Window> windowNamed(const std::string &name)
{
    const std::string shangchuan = SEAHEX_MAPS_DIR "/shangchuan.000";
    const GeoBox offShangchuan{112.45, 21.50, 113.10, 22.10};
    const GeoBox offNorway{4.5, 60.0, 7.0, 62.0};
    if (name == "S")
        return Window{shangchuan, offShangchuan, 470.0, OffsetCoord{143, 159}, "Shangchuan, 470 m"};
    if (name == "P")
        return Window{shangchuan, offShangchuan, 47.0, std::nullopt, "Shangchuan, 47 m"};
    if (name == "N")
        return Window{norwayChart(), offNorway, 93.0, std::nullopt, "Norwegian coast, 93 m"};
    if (name == "N100")
        return Window{norwayChart(), offNorway, 18.6, std::nullopt, "Norwegian coast, 18.6 m"};
    return std::nullopt;
}

std::optional<double> archipelagoCells(const std::string &name)
{
    const std::string prefix = "archipelago:";
    if (name.rfind(prefix, 0) != 0)
        return std::nullopt;
    const double cells = std::strtod(name.c_str() + prefix.size(), nullptr);
    if (!(cells >= 1e3 && cells <= 1e9))
        throw std::runtime_error(name + ": an archipelago has 1e3 to 1e9 cells");
    return cells;
}

void fill(World &world, const HexLattice &lattice)
{
    OccupancyBuilder<HexLattice> builder(lattice);
    for (const Shape &shape : world.land)
        builder.block(shape, 0.0);
    world.occupancy = builder.build();
}

/// The box in the plane that the corners of a geographic one span.
Box planeBox(const GeoBox &window, const Projection &projection)
{
    Box box;
    box.min = box.max = projection.forward(window.centre());
    for (const double lat : {window.southDeg, window.northDeg})
        for (const double lon : {window.westDeg, window.eastDeg})
        {
            const Point corner = projection.forward(GeoPoint::fromLatLon(lat, lon));
            box.min = box.min.cwiseMin(corner);
            box.max = box.max.cwiseMax(corner);
        }
    return box;
}

World fromChart(const std::string &name, const Window &window)
{
    World world{name, window.what, nullptr, {}, window.chart};
    const Chart chart = readChart(window.chart);
    const auto projection = Projection::transverseMercator(window.box.centre());
    for (const Hazard &hazard : projectHazards(chart, projection))
        if (judge(*hazard.object, Vessel(), HazardScope::LandOnly).blocks())
            world.land.push_back(hazard.shape);
    const Box box = planeBox(window.box, projection);
    fill(world, window.size
                    ? HexLattice({box.min.x(), box.max.y()}, window.pitchM, window.size->column, window.size->row)
                    : HexLattice::covering(box, window.pitchM));
    return world;
}

World islands(const std::string &name, double cells)
{
    World world{name, "synthetic archipelago", nullptr, {}, ""};
    // as many rows as columns: seven eighths as high as wide
    const auto side = static_cast<std::int64_t>(std::lround(std::sqrt(cells)));
    const HexLattice lattice(Point(0, 0), 1.0, side, side);
    for (Polygon &island : archipelago(lattice.bounds(), 2.0, 1))
    {
        Shape shape;
        shape.areas.push_back(std::move(island));
        world.land.push_back(std::move(shape));
    }
    fill(world, lattice);
    return world;
}

}  // namespace

World makeWorld(const std::string &name)
{
    if (const auto cells = archipelagoCells(name))
        return islands(name, *cells);
    const auto window = windowNamed(name);
    if (!window)
        throw std::runtime_error("no world is called " + name + "; there are S, P, N, N100 and archipelago:CELLS");
    return fromChart(name, *window);
}

bool isAvailable(const std::string &name)
{
    const auto window = windowNamed(name);
    return !window || std::filesystem::exists(window->chart);
}

}  // namespace seahex::contest
