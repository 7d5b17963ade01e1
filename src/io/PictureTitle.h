#pragma once

#include "PictureCanvas.h"

#include <string>

namespace seahex
{

/// Where titles and legends begin and end, in units of type.
constexpr double pictureLeft = 116.0;
constexpr double pictureRight = 1556.0;

/// The style, made smaller until the text fits the room: hinted letters don't shrink as evenly as their size.
TextStyle fittedStyle(PictureCanvas &canvas, const std::string &text, TextStyle style, double room);

/// The lines above a picture, parted by '\n'. A line too long for the page is set smaller.
void drawTitle(PictureCanvas &canvas, const std::string &title);

/// What the title takes from the page's top, in units of type.
double titleHeight(const std::string &title);

}  // namespace seahex
