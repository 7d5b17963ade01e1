#include "GroupOne.h"

#include "Overlay.h"
#include "Tiling.h"

#include "seahex/chart/HazardCatalogue.h"

#include <boost/geometry/algorithms/num_points.hpp>

#include <algorithm>
#include <cstdio>

namespace seahex
{
namespace
{

std::string toDecimal(WideInteger value)
{
    if (value == 0)
        return "0";
    std::string digits;
    for (WideInteger rest = value < 0 ? -value : value; rest != 0; rest /= 10)
        digits += static_cast<char>('0' + static_cast<int>(rest % 10));
    if (value < 0)
        digits += '-';
    std::reverse(digits.begin(), digits.end());
    return digits;
}

/// Where areas of a source meet at a corner of only one of them, rounding opens a seam no wider than the grid.
constexpr double SEAM_GRID_UNITS = 2.0;

void addGap(CellContents &cell, Polygon gap, std::size_t number)
{
    DraftHazard hazard;
    hazard.object.objectClass = "M_COVR";
    hazard.object.rule = HazardRule::ChartGap;
    hazard.object.cell = cell.report.name;
    hazard.object.featureId = "gap " + std::to_string(number);
    hazard.lonLat.areas.push_back(std::move(gap));
    cell.hazards.push_back(std::move(hazard));
}

std::string percent(double fraction)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.3g %%", 100.0 * fraction);
    return text;
}

template <class Visit>
void forEachGroupOneArea(const CellContents &cell, Visit &&visit)
{
    for (const DraftHazard &hazard : cell.hazards)
    {
        const HazardClass *row = hazard.lonLat.areas.empty() ? nullptr : findHazardClass(hazard.object.objectClass);
        if (row != nullptr && row->groupOne)
            std::for_each(hazard.lonLat.areas.begin(), hazard.lonLat.areas.end(), visit);
    }
}

}  // namespace

std::vector<Polygon> groupOneAreas(const CellContents &cell)
{
    std::vector<Polygon> areas;
    forEachGroupOneArea(cell, [&areas](const Polygon &area) { areas.push_back(area); });
    return areas;
}

void checkGroupOne(CellContents &cell)
{
    std::size_t corners = 0;
    forEachGroupOneArea(cell, [&corners](const Polygon &area) { corners += boost::geometry::num_points(area); });
    Tiling tiling(cell.gridUnitsPerDegree, corners);
    for (const Polygon &area : cell.coverage)
        tiling.addWhole(area);
    forEachGroupOneArea(cell, [&tiling](const Polygon &area) { tiling.addPart(area); });

    GroupOneCheck &check = cell.report.groupOne;
    check.applicable = true;
    check.twiceAreaDifference = toDecimal(tiling.twiceAreaDifference());
    check.tiles = tiling.twiceAreaDifference() == 0;
    // Equal sums are what a sound cell has, but a gap and an overlap of one size have them too.
    if (check.tiles && tiling.boundariesAddUp())
        return;

    const std::string fault = "the areas of group 1 do not tile the coverage of " + cell.report.name + ": ";
    std::vector<Polygon> gaps;
    if (!subtract(cell.coverage, groupOneAreas(cell), SEAM_GRID_UNITS / cell.gridUnitsPerDegree, gaps))
    {
        // Where they are can't be found, so that all of the coverage must count as undescribed.
        gaps = cell.coverage;
        cell.warn(fault + "where can't be found out, so that all of it is blocked");
    }
    else if (!gaps.empty())
        cell.warn(fault + percent(areaDeg2(gaps) / areaDeg2(cell.coverage)) +
                  " of it is described by none and is blocked");
    else if (!check.tiles)
        cell.warn(fault + "they overlap each other or reach beyond it");
    check.tiles = check.tiles && gaps.empty();
    check.gapFraction = areaDeg2(gaps) / areaDeg2(cell.coverage);
    for (std::size_t i = 0; i < gaps.size(); ++i)
        addGap(cell, std::move(gaps[i]), i + 1);
}

}  // namespace seahex
