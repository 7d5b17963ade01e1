#include "seahex/io/Picture.h"

#include "PictureBorder.h"
#include "PictureCanvas.h"
#include "PictureFile.h"
#include "PictureLegend.h"
#include "PictureMap.h"

#include <algorithm>
#include <filesystem>

namespace seahex
{

namespace
{

PictureFormat formatOf(const std::string &path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (extension == ".png")
        return PictureFormat::Png;
    if (extension == ".svg")
        return PictureFormat::Svg;
    throw PictureError("the picture " + path + " must end in .svg or .png, not in " +
                       (extension.empty() ? "nothing" : extension));
}

}  // namespace

void writePicture(const std::string &path, const PictureContent &content)
{
    const PictureFormat format = formatOf(path);
    PictureCanvas canvas(format, pictureFrame(content));
    drawTitle(canvas, content);
    drawMap(canvas, content);
    drawBorder(canvas, content.projection);
    drawLegend(canvas, content);
    replacePictureFile(path, canvas.finish());
}

}  // namespace seahex
