#include "seahex/chart/ChartReader.h"

#include "CellReader.h"
#include "GdalDataset.h"
#include "Overlay.h"
#include "SourceFinder.h"

#include "seahex/chart/ChartError.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace seahex
{
namespace
{

GeoBox boundsOf(const std::vector<Polygon> &areas)
{
    constexpr double INF = std::numeric_limits<double>::infinity();
    GeoBox box{INF, INF, -INF, -INF};
    for (const Polygon &area : areas)
    {
        for (const Point &corner : area.outer())
        {
            box.westDeg = std::min(box.westDeg, corner.x());
            box.southDeg = std::min(box.southDeg, corner.y());
            box.eastDeg = std::max(box.eastDeg, corner.x());
            box.northDeg = std::max(box.northDeg, corner.y());
        }
    }
    return box;
}

bool boxesMeet(const GeoBox &a, const GeoBox &b)
{
    return a.westDeg < b.eastDeg && b.westDeg < a.eastDeg && a.southDeg < b.northDeg && b.southDeg < a.northDeg;
}

/// The cells as one list, S-57 first.
std::vector<CellContents> readCells(const SourceFiles &files)
{
    std::vector<CellContents> cells;
    for (const std::filesystem::path &path : files.cells)
        cells.push_back(readS57Cell(path));
    if (!files.layers.empty())
        cells.push_back(readLayerCell(files.layers, files.layersName, files.layersSource));
    for (CellContents &cell : cells)
        cell.report.bounds = boundsOf(cell.coverage);
    return cells;
}

/// One warning for each pair of cells, in the report of the later one.
void warnOfOverlaps(std::vector<CellContents> &cells)
{
    for (std::size_t later = 1; later < cells.size(); ++later)
        for (std::size_t earlier = 0; earlier < later; ++earlier)
        {
            const CellContents &other = cells[earlier];
            CellContents &cell = cells[later];
            if (boxesMeet(cell.report.bounds, other.report.bounds) && overlap(cell.coverage, other.coverage))
                cell.warn("the coverage of " + cell.report.name + " overlaps that of " + other.report.name +
                          ": objects of both count there");
        }
}

void warnOfDatums(std::vector<CellContents> &cells)
{
    for (std::size_t i = 1; i < cells.size(); ++i)
        if (cells[i].report.soundingDatum != cells.front().report.soundingDatum)
            cells[i].warn("the depths of " + cells[i].report.name + " refer to another datum than those of " +
                          cells.front().report.name);
}

/// Leaves the cells aside that do not meet the window, unless none would be left.
void keepCellsIn(const GeoBox &window, std::vector<CellContents> &cells)
{
    const auto isAway = [&window](const CellContents &cell)
    {
        return !boxesMeet(cell.report.bounds, window);
    };
    std::string names;
    for (const CellContents &cell : cells)
        if (isAway(cell))
            names += (names.empty() ? "" : ", ") + cell.report.name;
    if (names.empty() || std::all_of(cells.begin(), cells.end(), isAway))
        return;
    cells.erase(std::remove_if(cells.begin(), cells.end(), isAway), cells.end());
    cells.front().warn("left aside, because it lies away from the voyage: " + names);
}

/// A local frame bends and stretches too much beyond this, and a box of longitudes can't tell east from west.
void demandOneRegion(const Chart &chart)
{
    constexpr double widestDeg = 60.0;
    const double widthDeg = chart.bounds.eastDeg - chart.bounds.westDeg;
    if (chart.bounds.westDeg < -180.0 || chart.bounds.eastDeg > 180.0 || widthDeg > widestDeg)
        throw ChartUnsupported("the chart spans " + std::to_string(static_cast<int>(widthDeg)) +
                               " degrees of longitude, from " + std::to_string(chart.bounds.westDeg) + " to " +
                               std::to_string(chart.bounds.eastDeg) +
                               "; at most 60 within -180 to 180 can be planned on (none across the antimeridian)");
}

bool holdsDepthArea(const CellContents &cell)
{
    return std::any_of(cell.hazards.begin(), cell.hazards.end(),
                       [](const DraftHazard &hazard)
                       { return hazard.object.rule == HazardRule::DepthArea && !hazard.lonLat.areas.empty(); });
}

void demandWater(const std::vector<CellContents> &cells, const std::vector<std::string> &sources)
{
    if (!std::any_of(cells.begin(), cells.end(), holdsDepthArea))
        throw ChartEmpty("chart '" + sources.front() +
                         "' holds no depth area (DEPARE, DRGARE), so no water to sail in");
}

std::vector<Polygon> uniteCoverage(std::vector<CellContents> &cells)
{
    std::vector<Polygon> all;
    for (const CellContents &cell : cells)
        all.insert(all.end(), cell.coverage.begin(), cell.coverage.end());
    std::vector<Polygon> whole = unite(all);
    if (!whole.empty())
        return whole;
    cells.front().warn("the coverage of the chart can't be united: its parts are kept as they are");
    return all;
}

Chart pool(std::vector<CellContents> cells)
{
    Chart chart;
    chart.coverage.lonLat.areas = uniteCoverage(cells);
    chart.bounds = boundsOf(chart.coverage.lonLat.areas);
    for (CellContents &cell : cells)
    {
        for (DraftHazard &hazard : cell.hazards)
            chart.hazards.push_back(
                {std::make_shared<const HazardObject>(std::move(hazard.object)), GeoShape{std::move(hazard.lonLat)}});
        for (DraftContour &contour : cell.contours)
            chart.contours.push_back({contour.depthM, GeoShape{std::move(contour.lonLat)}});
        chart.cells.push_back(std::move(cell.report));
    }
    return chart;
}

}  // namespace

Chart readChart(const std::vector<std::string> &sources, const std::optional<GeoBox> &window)
{
    const auto start = std::chrono::steady_clock::now();
    const DriverMessages messages;  // nothing is printed past the report
    const SourceFiles files = findSources(sources);
    std::vector<CellContents> cells = readCells(files);
    for (const std::string &warning : files.warnings)
        cells.front().warn(warning);
    if (window)
        keepCellsIn(*window, cells);
    demandWater(cells, sources);
    warnOfOverlaps(cells);
    warnOfDatums(cells);

    Chart chart = pool(std::move(cells));
    demandOneRegion(chart);
    chart.readMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return chart;
}

Chart readChart(const std::string &source)
{
    return readChart(std::vector<std::string>{source});
}

}  // namespace seahex
