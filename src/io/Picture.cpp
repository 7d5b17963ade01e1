#include "seahex/io/Picture.h"

#include "PictureBorder.h"
#include "PictureCanvas.h"
#include "PictureFile.h"
#include "PictureFormat.h"
#include "PictureLegend.h"
#include "PictureMap.h"
#include "PictureTitle.h"

namespace seahex
{

void writePicture(const std::string &path, const PictureContent &content)
{
    const PictureFormat format = pictureFormatOf(path);
    PictureCanvas canvas(format, pictureFrame(content));
    drawTitle(canvas, content.title);
    drawMap(canvas, content);
    drawBorder(canvas, content.projection);
    drawLegend(canvas, content);
    replacePictureFile(path, canvas.finish());
}

}  // namespace seahex
