#pragma once

#include <string>

namespace seahex
{

/// Puts the bytes into the file, or leaves everything as it was: they are written to a new file beside it, which then
/// takes its name.
/// @throws PictureError if that can't be done
void replacePictureFile(const std::string &path, const std::string &bytes);

}  // namespace seahex
