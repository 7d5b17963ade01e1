#include "seahex/io/PictureFrame.h"

#include "seahex/io/ScaleBar.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace seahex
{

namespace
{

// The page in units of type, 1600 wide.
constexpr double pageWidth = 1600.0;
constexpr double leftMargin = 116.0;  // room for a latitude
constexpr double rightMargin = 44.0;
constexpr double topMargin = 26.0;
constexpr double firstTitleLine = 36.0;
constexpr double titleLine = 25.0;
constexpr double neatline = 12.0;   // the chart's border, around the map
constexpr double labelBand = 34.0;  // longitudes below the border
constexpr double legendBand = 112.0;
constexpr double footerBand = 30.0;
constexpr double tallest = 1.25;  // map height over page width
constexpr double slimmest = 8.0;  // longer over shorter side of the map

Box checkedBox(const PictureContent &content)
{
    Box box = content.crop ? *content.crop : content.occupancy->lattice().bounds();
    const Point size = box.max - box.min;
    if (!box.min.allFinite() || !box.max.allFinite() || !size.allFinite() || !(size.minCoeff() > 0.0))
        throw PictureError("the picture's crop box has no extent: x " + plainNumber(box.min.x(), 6) + " to " +
                           plainNumber(box.max.x(), 6) + ", y " + plainNumber(box.min.y(), 6) + " to " +
                           plainNumber(box.max.y(), 6) + " plane units");
    return box;
}

// Metres for one plane unit to the east and to the north, in the middle of the box.
Point metresPerUnit(const Projection &projection, const Box &box)
{
    if (projection.isMetric())
        return {1.0, 1.0};
    const double latitudeDeg = std::clamp(0.5 * (box.min.y() + box.max.y()), -89.0, 89.0);
    return {metresPerDegreeOfLongitude(latitudeDeg), metresPerDegreeOfLatitude(latitudeDeg)};
}

void widen(double &least, double &most, double extent)
{
    const double more = 0.5 * (extent - (most - least));
    least -= more;
    most += more;
}

double titleHeight(const std::string &title)
{
    if (title.empty())
        return 0.0;
    return firstTitleLine + titleLine * static_cast<double>(std::count(title.begin(), title.end(), '\n'));
}

}  // namespace

PictureFrame pictureFrame(const PictureContent &content)
{
    if (!content.occupancy)
        throw PictureError("a picture needs an occupancy, but it is null");
    if (content.widthPx < 400 || content.widthPx > 8000)
        throw PictureError("the picture's width of " + std::to_string(content.widthPx) +
                           " pixels lies outside 400 to 8000 pixels");
    PictureFrame frame;
    frame.widthPx = content.widthPx;
    frame.unit = content.widthPx / pageWidth;
    frame.plane = checkedBox(content);

    const Point perUnit = metresPerUnit(content.projection, frame.plane);
    Point groundM = (frame.plane.max - frame.plane.min).cwiseProduct(perUnit);
    groundM = groundM.cwiseMax(groundM.maxCoeff() / slimmest);
    const double roomX = std::round((pageWidth - leftMargin - rightMargin) * frame.unit);
    const double roomY = std::round(tallest * pageWidth * frame.unit);
    frame.metresPerPx = std::max(groundM.x() / roomX, groundM.y() / roomY);
    frame.pxPerUnitX = perUnit.x() / frame.metresPerPx;
    frame.pxPerUnitY = perUnit.y() / frame.metresPerPx;

    // Whole pixels, so that an image of the cells falls on them; the box grows by what rounding up adds.
    const double mapWidth = std::min(roomX, std::ceil(groundM.x() / frame.metresPerPx - 1e-6));
    const double mapHeight = std::min(roomY, std::ceil(groundM.y() / frame.metresPerPx - 1e-6));
    widen(frame.plane.min.x(), frame.plane.max.x(), mapWidth / frame.pxPerUnitX);
    widen(frame.plane.min.y(), frame.plane.max.y(), mapHeight / frame.pxPerUnitY);

    const double left = std::round(leftMargin * frame.unit + 0.5 * (roomX - mapWidth));
    const double top = std::round((topMargin + titleHeight(content.title) + neatline) * frame.unit);
    frame.map = {{left, top}, {left + mapWidth, top + mapHeight}};
    frame.legendTop = frame.map.max.y() + (neatline + labelBand) * frame.unit;
    const double footer = content.footer.empty() ? 0.0 : footerBand;
    frame.heightPx = static_cast<int>(std::ceil(frame.legendTop + (legendBand + footer) * frame.unit));
    return frame;
}

}  // namespace seahex
