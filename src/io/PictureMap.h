#pragma once

#include "PictureCanvas.h"

namespace seahex
{

/// Everything within the map's border, from the water to the markers of start and goal. Clips to the map.
void drawMap(PictureCanvas &canvas, const PictureContent &content);

/// The sample symbols that map and legend share.
void strokeRawPath(PictureCanvas &canvas);
void strokeRoute(PictureCanvas &canvas);
void addDangerCross(PictureCanvas &canvas, const Point &page);
void strokeDangers(PictureCanvas &canvas, bool dashed);
void drawMarker(PictureCanvas &canvas, const Point &page, const std::string &letter);

}  // namespace seahex
