#pragma once

#include "CellContents.h"

namespace seahex
{

/// Checks that the group 1 areas tile the coverage, and where they do not, makes the gaps hazards of rule ChartGap and
/// adds a warning to the report.
void checkGroupOne(CellContents &cell);

}  // namespace seahex
