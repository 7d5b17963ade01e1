#pragma once

#include "PictureCanvas.h"

#include "seahex/geometry/Shape.h"

namespace seahex
{

/// Adds geometry of the plane to a canvas's current path, thinned and cut for the page.
///
/// Vertices closer than a third of a unit to the last one kept are left out. What lies far outside the map is cut off
/// at a margin around it: the sizes of charts exceed the range of cairo's numbers when a small part is shown.
class PicturePath
{
public:
    explicit PicturePath(PictureCanvas &canvas);

    /// Outer and inner rings; to be filled by the even-odd rule. A ring too small to see becomes a square of one unit.
    void addArea(const Polygon &area);
    void addLine(const LineString &line);

    /// True if the point, given in page coordinates, is finite and lies on the map or in the margin around it.
    bool isNear(const Point &page) const { return page.allFinite() && margin_.contains(page); }

private:
    void addRing(const Ring &ring);

    PictureCanvas &canvas_;
    Box margin_;
};

}  // namespace seahex
