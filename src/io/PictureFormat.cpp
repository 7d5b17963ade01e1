#include "PictureFormat.h"

#include "seahex/io/Picture.h"

#include <algorithm>
#include <filesystem>

namespace seahex
{

PictureFormat pictureFormatOf(const std::string &path)
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

}  // namespace seahex
