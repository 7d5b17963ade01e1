#pragma once

#include "PictureCanvas.h"

namespace seahex
{

/// The meridians and parallels across the map.
void drawGraticule(PictureCanvas &canvas, const Projection &projection);

/// The border around the map: barred in small steps of the graticule, the lines labelled on the left and below.
void drawBorder(PictureCanvas &canvas, const Projection &projection);

}  // namespace seahex
