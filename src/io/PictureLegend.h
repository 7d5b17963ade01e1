#pragma once

#include "PictureCanvas.h"

namespace seahex
{

/// The lines above the map. A line too long for the page is set smaller.
void drawTitle(PictureCanvas &canvas, const PictureContent &content);

/// The band below the map: scale bars, the colours and symbols of what the picture holds, and the footer.
void drawLegend(PictureCanvas &canvas, const PictureContent &content);

}  // namespace seahex
