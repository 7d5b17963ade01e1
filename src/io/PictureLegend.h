#pragma once

#include "PictureCanvas.h"

namespace seahex
{

/// The band below the map: scale bars, the colours and symbols of what the picture holds, and the footer.
void drawLegend(PictureCanvas &canvas, const PictureContent &content);

}  // namespace seahex
