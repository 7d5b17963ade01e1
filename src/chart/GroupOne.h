#pragma once

#include "CellContents.h"

#include <string>
#include <vector>

namespace seahex
{

/// Twice the area of `coverage` minus twice the area of `parts`, exact, in squared units of a grid of
/// `gridUnitsPerDegree`; as decimal text. Overlaps count as often as they occur.
std::string twiceAreaDifference(const std::vector<Polygon> &coverage, const std::vector<Polygon> &parts,
                                double gridUnitsPerDegree);

/// Checks that the group 1 areas tile the coverage, and where they do not, makes the gaps hazards of rule ChartGap and
/// adds a warning to the report.
void checkGroupOne(CellContents &cell);

}  // namespace seahex
