#pragma once

#include <seahex/geometry/Box.h>
#include <seahex/geometry/Point3.h>
#include <seahex/io/PicturePalette.h>
#include <seahex/world/Bathymetry.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace seahex
{

/// A dive to be drawn over its seabed.
struct DiveLine
{
    std::vector<Point3> points;
    std::string name = "dive";  ///< in the legend, one line, UTF-8
    Colour colour = palette::route;
};

/// What a picture of the seabed in three dimensions shows.
struct SeabedPictureContent
{
    std::shared_ptr<const Bathymetry> seabed;  ///< never null
    std::vector<DiveLine> dives = {};

    std::optional<Box> crop = std::nullopt;  ///< part of the plane to show; by default what the seabed covers
    double exaggeration = 0.0;               ///< of heights; 0: such that the relief is a quarter as high as it is wide
    double azimuthDeg = 20.0;                ///< where the observer looks, clockwise from north
    double elevationDeg = 38.0;              ///< how far down he looks: 10 to 80

    std::string unit = "m";   ///< of depths, in the legend
    std::string title = {};   ///< lines parted by '\n', the first is set larger; UTF-8
    std::string footer = {};  ///< one line below; UTF-8
    int widthPx = 1600;       ///< 400 to 8000; the height follows
};

/// Draws the seabed as seen obliquely from above (parallel projection, nearer parts over farther ones), tinted by depth
/// and shaded, land buff, and the dives over it, into a .svg or .png file (by extension, in either case).
///
/// Of a large grid at most 160 x 160 places are drawn, so that what is finer than that doesn't show. Unknown seabed is
/// left out. What lies behind a rise is pale; below each dive its track on the seabed is drawn thin, with a plumb line
/// at its waypoints. Points that are not finite are left out.
///
/// The file appears complete or not at all: it is written beside its place and renamed.
///
/// @throws PictureError if the extension is neither, the file can't be written, there is no seabed, no known seabed in
///         the crop box, or a number is out of range
void writeSeabedPicture(const std::string &path, const SeabedPictureContent &content);

}  // namespace seahex
