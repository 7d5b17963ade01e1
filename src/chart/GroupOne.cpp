#include "GroupOne.h"

#include "GridCoordinates.h"
#include "Overlay.h"
#include "Tiling.h"

#include "seahex/chart/HazardCatalogue.h"

#include <algorithm>
#include <cstdio>

namespace seahex
{
namespace
{

WideInteger twiceArea(const Ring &ring, double gridUnitsPerDegree)
{
    const WideInteger sum = twiceSignedArea(ring, gridUnitsPerDegree);
    return sum < 0 ? -sum : sum;
}

WideInteger twiceArea(const std::vector<Polygon> &areas, double gridUnitsPerDegree)
{
    WideInteger sum = 0;
    for (const Polygon &area : areas)
    {
        sum += twiceArea(area.outer(), gridUnitsPerDegree);
        for (const Ring &hole : area.inners())
            sum -= twiceArea(hole, gridUnitsPerDegree);
    }
    return sum;
}

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

}  // namespace

std::vector<Polygon> groupOneAreas(const CellContents &cell)
{
    std::vector<Polygon> areas;
    for (const DraftHazard &hazard : cell.hazards)
    {
        const HazardClass *row = findHazardClass(hazard.object.objectClass);
        if (row != nullptr && row->groupOne)
            areas.insert(areas.end(), hazard.lonLat.areas.begin(), hazard.lonLat.areas.end());
    }
    return areas;
}

std::string twiceAreaDifference(const std::vector<Polygon> &coverage, const std::vector<Polygon> &parts,
                                double gridUnitsPerDegree)
{
    return toDecimal(twiceArea(coverage, gridUnitsPerDegree) - twiceArea(parts, gridUnitsPerDegree));
}

void checkGroupOne(CellContents &cell)
{
    GroupOneCheck &check = cell.report.groupOne;
    const std::vector<Polygon> parts = groupOneAreas(cell);
    check.applicable = true;
    check.twiceAreaDifference = twiceAreaDifference(cell.coverage, parts, cell.gridUnitsPerDegree);
    check.tiles = check.twiceAreaDifference == "0";

    // Equal sums are what a sound cell has, but a gap and an overlap of one size have them too.
    if (check.tiles && boundariesAddUp(cell.coverage, parts, cell.gridUnitsPerDegree))
        return;

    const std::string fault = "the areas of group 1 do not tile the coverage of " + cell.report.name + ": ";
    std::vector<Polygon> gaps;
    if (!subtract(cell.coverage, parts, SEAM_GRID_UNITS / cell.gridUnitsPerDegree, gaps))
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
