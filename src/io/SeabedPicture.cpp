#include "seahex/io/SeabedPicture.h"

#include "PictureCanvas.h"
#include "PictureFile.h"
#include "PictureFormat.h"
#include "PictureTitle.h"
#include "SeabedScene.h"

#include "seahex/io/Picture.h"

#include <cmath>

namespace seahex
{
namespace
{

constexpr double legendHeight = 92.0;  // below the scene

void requireInRange(const char *name, double value, double low, double high)
{
    if (!(value >= low && value <= high))
        throw PictureError(std::string("a picture's ") + name + " must be " + std::to_string(low) + " to " +
                           std::to_string(high) + ", not " + std::to_string(value));
}

void check(const SeabedPictureContent &content)
{
    if (content.seabed == nullptr)
        throw PictureError("a picture of the seabed needs one");
    requireInRange("width", content.widthPx, 400, 8000);
    requireInRange("elevation", content.elevationDeg, 10.0, 80.0);
    requireInRange("azimuth", content.azimuthDeg, -360.0, 360.0);
    requireInRange("exaggeration", content.exaggeration, 0.0, 1e6);
}

}  // namespace

void writeSeabedPicture(const std::string &path, const SeabedPictureContent &content)
{
    const PictureFormat format = pictureFormatOf(path);
    check(content);
    PictureFrame frame;
    frame.widthPx = content.widthPx;
    frame.unit = content.widthPx / 1600.0;
    const double top = 24.0 + titleHeight(content.title);
    SeabedScene scene(content, {frame.unit * pictureLeft, frame.unit * top}, frame.unit * (pictureRight - pictureLeft));
    frame.heightPx = static_cast<int>(std::ceil(scene.bottom() + frame.unit * legendHeight));
    PictureCanvas canvas(format, frame);
    drawTitle(canvas, content.title);
    scene.draw(canvas);
    scene.drawLegend(canvas);
    replacePictureFile(path, canvas.finish());
}

}  // namespace seahex
