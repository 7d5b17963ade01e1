#include "Arena.h"

#include "Failure.h"

#include <seahex/chart/ChartError.h>
#include <seahex/chart/ChartReader.h>
#include <seahex/io/GeoRoute.h>

#include <cmath>

namespace demos
{
namespace
{

/// How many cells of a pitch in metres cover a box.
double cellsOver(const seahex::GeoBox &box, double pitch)
{
    const auto corner = [](double lat, double lon)
    {
        return seahex::GeoPoint::fromLatLon(lat, lon);
    };
    const double middleDeg = box.centre().latitudeDeg();
    const double width = seahex::rhumbLengthM({{corner(middleDeg, box.westDeg), corner(middleDeg, box.eastDeg)}});
    const double height =
        seahex::rhumbLengthM({{corner(box.southDeg, box.westDeg), corner(box.northDeg, box.westDeg)}});
    return (width / pitch) * (height / pitch) / (0.5 * std::sqrt(3.0));
}

void requireWater(const seahex::ChartArena &arena)
{
    const seahex::HexOccupancy &occupancy = *arena.occupancy();
    if (occupancy.blockedCount() < occupancy.lattice().cellCount())
        return;
    throw Failure(Exit::Chart, "the chart has no navigable cell: all " + std::to_string(occupancy.blockedCount()) +
                                   " cells, " + plain(occupancy.lattice().pitch()) +
                                   (arena.projection().isMetric() ? " m" : " degrees") +
                                   " wide, are blocked for a vessel that needs " +
                                   plain(arena.vessel().requiredDepthM()) + " m of water");
}

}  // namespace

std::shared_ptr<const seahex::Chart> readChart(const std::vector<std::string> &sources,
                                               const std::optional<seahex::GeoBox> &window)
{
    try
    {
        return std::make_shared<const seahex::Chart>(seahex::readChart(sources, window));
    }
    catch (const seahex::ChartError &error)
    {
        throw Failure(Exit::Chart, error.what());
    }
}

std::vector<std::string> warningsOf(const seahex::Chart &chart)
{
    std::vector<std::string> warnings;
    for (const seahex::CellReport &cell : chart.cells)
        warnings.insert(warnings.end(), cell.warnings.begin(), cell.warnings.end());
    return warnings;
}

std::shared_ptr<const seahex::ChartArena> makeArena(const seahex::Chart &chart, const seahex::ArenaOptions &options)
{
    if (options.pitch != 0.0 && !options.lattice)
        checkCellCount(options.pitch, cellsOver(chart.bounds, options.pitch));
    try
    {
        auto arena = std::make_shared<const seahex::ChartArena>(chart, options);
        requireWater(*arena);
        return arena;
    }
    catch (const seahex::ChartError &error)
    {
        throw Failure(Exit::Chart, error.what());
    }
    catch (const std::domain_error &error)
    {
        throw Failure(Exit::Usage, error.what());
    }
    catch (const std::length_error &error)
    {
        throw Failure(Exit::Usage, std::string("--pitch is too small: ") + error.what());
    }
}

void checkCellCount(double pitch, double cells)
{
    constexpr double mostCells = 1e9;
    if (cells > mostCells)
        throw Failure(Exit::Usage, "--pitch " + plain(pitch) + " is too small: it would need " + plain(cells) +
                                       " cells, and at most " + plain(mostCells) + " are possible");
}

}  // namespace demos
