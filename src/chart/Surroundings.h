#pragma once

#include "CellContents.h"

namespace seahex
{

/// Fills surroundingDepthM of every danger of the cell: the least DRVAL1 of the depth areas and dredged areas that it
/// touches, boundaries included. An unknown DRVAL1 counts as -1 m; a danger that touches unsurveyed water gets none.
void fillSurroundingDepths(CellContents &cell);

}  // namespace seahex
