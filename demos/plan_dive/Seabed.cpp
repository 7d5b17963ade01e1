#include "Seabed.h"

#include "common/Arena.h"
#include "common/Failure.h"
#include "common/RasterSeabed.h"

#include <seahex/chart/CableCrossing.h>
#include <seahex/chart/ChartError.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace plan_dive
{

using demos::Exit;
using demos::Failure;

namespace
{

/// Start and goal with as much around them as lies between them, and a few miles at least: a voyage's waters.
seahex::GeoBox voyageBox(const Options &options)
{
    const auto [south, north] = std::minmax({options.from.place.latitudeDeg(), options.to.place.latitudeDeg()});
    const auto [west, east] = std::minmax({options.from.place.longitudeDeg(), options.to.place.longitudeDeg()});
    const double around = std::max({north - south, east - west, 0.05});
    return {west - around, south - around, east + around, north + around};
}

double millisecondsSince(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double spacingOver(const Options &options, const seahex::Chart &chart, const seahex::Projection &projection)
{
    if (options.spacingM > 0.0)
        return options.spacingM;
    const auto corner = [&](double latitudeDeg, double longitudeDeg)
    {
        return projection.forward(seahex::GeoPoint::fromLatLon(latitudeDeg, longitudeDeg));
    };
    return seahex::automaticPitchM(
        {corner(chart.bounds.southDeg, chart.bounds.westDeg), corner(chart.bounds.northDeg, chart.bounds.eastDeg)});
}

std::shared_ptr<const seahex::ChartArena> arenaAround(const Options &options, const seahex::Chart &chart,
                                                      const seahex::Projection &projection, double spacingM)
{
    seahex::ArenaOptions arena;
    arena.projection = projection;
    arena.scope = options.crossCablesM ? seahex::HazardScope::WaterColumnAboveCables : seahex::HazardScope::WaterColumn;
    arena.vessel.marginM = options.marginM;
    arena.pitch = spacingM;
    return demos::makeArena(chart, arena);
}

std::shared_ptr<const seahex::Bathymetry> depthsOf(const Options &options, const seahex::Chart &chart,
                                                   const seahex::Projection &projection, double spacingM)
{
    try
    {
        return seahex::chartBathymetry(chart, projection, spacingM, options.chartDepths);
    }
    catch (const std::domain_error &error)
    {
        throw Failure(Exit::Usage, std::string("--spacing ") + demos::plain(spacingM) + " m: " + error.what());
    }
    catch (const seahex::ChartError &error)
    {
        throw Failure(Exit::Chart, error.what());
    }
}

Seabed ofRaster(const Options &options)
{
    const seahex::GeoBox box = voyageBox(options);
    const demos::RasterSeabed seabed = demos::readRaster(
        options, seahex::Box{seahex::Point(box.westDeg, box.southDeg), seahex::Point(box.eastDeg, box.northDeg)});
    return {seabed.depths, seabed.projection, options.bathymetry, nullptr, nullptr};
}

}  // namespace

std::vector<std::string> Seabed::warnings() const
{
    return chart ? demos::warningsOf(*chart) : std::vector<std::string>{};
}

Seabed readSeabed(const Options &options)
{
    const auto begin = std::chrono::steady_clock::now();
    std::shared_ptr<const seahex::Chart> chart;
    if (!options.charts.empty())
        chart = demos::readChart(options.charts, voyageBox(options));
    Seabed seabed = [&]
    {
        if (!options.bathymetry.empty())
            return ofRaster(options);
        const auto projection = seahex::Projection::localEquirectangular(chart->bounds.centre());
        const double spacingM = spacingOver(options, *chart, projection);
        return Seabed{depthsOf(options, *chart, projection, spacingM), projection, "", nullptr, nullptr};
    }();
    if (chart)
    {
        seabed.chart = chart;
        seabed.around =
            arenaAround(options, *chart, seabed.projection, spacingOver(options, *chart, seabed.projection));
        if (options.crossCablesM)
        {
            seabed.aboveCablesM = *options.crossCablesM;
            seabed.depths =
                raiseCables(*seabed.depths, *chart, seabed.projection, seabed.aboveCablesM, options.marginM);
        }
        for (const seahex::CellReport &cell : chart->cells)
            seabed.source += (seabed.source.empty() ? "" : ", ") + ("chart " + cell.name);
    }
    seabed.readMs = millisecondsSince(begin);
    return seabed;
}

std::shared_ptr<const seahex::DiveArena> makeDiveArena(const Seabed &seabed, const seahex::DiveLimits &limits,
                                                       double inHandM)
{
    seahex::DiveLimits more = limits;
    more.clearanceM += inHandM;
    try
    {
        return std::make_shared<const seahex::DiveArena>(seabed.depths, more,
                                                         seabed.around ? seabed.around->occupancy() : nullptr);
    }
    catch (const std::runtime_error &error)
    {
        throw Failure(Exit::Chart, seabed.source + ": " + error.what());
    }
}

}  // namespace plan_dive
