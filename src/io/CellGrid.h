#pragma once

#include "CellOutline.h"
#include "PictureCanvas.h"

namespace seahex
{

/// Faint edges of all cells of the window, each drawn once, if these are large enough on the page to be told apart.
void drawCellGrid(PictureCanvas &canvas, const Lattice &lattice, const CellWindow &window);

}  // namespace seahex
