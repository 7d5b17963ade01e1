#pragma once

#include <seahex/chart/Chart.h>

#include <cstddef>
#include <string>
#include <vector>

namespace seahex
{

/// One object of a cell while it is being read: still open to changes.
struct DraftHazard
{
    HazardObject object;
    Shape lonLat;
};

/// A contour of a cell.
struct DraftContour
{
    double depthM;
    Shape lonLat;
};

/// All that is known of one cell before it becomes part of a chart.
struct CellContents
{
    CellReport report;
    std::vector<DraftHazard> hazards;
    std::vector<DraftContour> contours;
    std::vector<Polygon> coverage;    ///< the areas of M_COVR with CATCOV 1, as read
    std::vector<Polygon> noData;      ///< the areas of M_COVR with another CATCOV: no data within them
    double gridUnitsPerDegree = 1e7;  ///< the grid on which its coordinates are whole numbers

    void warn(const std::string &sentence) { report.warnings.push_back(sentence); }
    void skip(const std::string &reason, const std::string &objectClass, std::size_t count = 1)
    {
        if (count > 0)
            report.skipped[reason][objectClass] += count;
    }
};

/// The areas of the group 1 classes.
std::vector<Polygon> groupOneAreas(const CellContents &cell);

}  // namespace seahex
