#pragma once

#include <seahex/geometry/Box.h>
#include <seahex/geometry/Point.h>
#include <seahex/io/Picture.h>

namespace seahex
{

/// Where the plane lies on the page of a picture.
///
/// Page coordinates are pixels of a PNG or user units of an SVG, x to the right and y down from the upper left corner.
/// The plate carree frame is squeezed east to west by the ratio of a degree of longitude to one of latitude (WGS-84) at
/// the middle latitude, so that shapes and short distances look right there.
struct PictureFrame
{
    int widthPx = 0;
    int heightPx = 0;
    double unit = 1.0;         ///< pixels for one unit of type and line widths; 1 at a width of 1600
    Box map;                   ///< the map's rectangle on the page
    Box plane;                 ///< the part of the plane that fills it
    double pxPerUnitX = 1.0;   ///< pixels for one plane unit to the east
    double pxPerUnitY = 1.0;   ///< pixels for one plane unit to the north
    double metresPerPx = 1.0;  ///< on the ground, in the middle of the map
    double legendTop = 0.0;    ///< page y of the band below the map's labels

    Point toPage(const Point &p) const
    {
        return {map.min.x() + (p.x() - plane.min.x()) * pxPerUnitX, map.min.y() + (plane.max.y() - p.y()) * pxPerUnitY};
    }
    Point toPlane(const Point &page) const
    {
        return {plane.min.x() + (page.x() - map.min.x()) / pxPerUnitX,
                plane.max.y() - (page.y() - map.min.y()) / pxPerUnitY};
    }
};

/// The frame that writePicture uses for this content. The shown box is the crop box, widened where needed so that
/// neither side is more than eight times the other.
/// @throws PictureError as writePicture does for a null occupancy, a bad crop box or a bad width
PictureFrame pictureFrame(const PictureContent &content);

}  // namespace seahex
