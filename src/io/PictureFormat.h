#pragma once

#include <string>

namespace seahex
{

enum class PictureFormat
{
    Png,
    Svg
};

/// The format that a file's extension names, in either case.
/// @throws PictureError for another extension
PictureFormat pictureFormatOf(const std::string &path);

}  // namespace seahex
