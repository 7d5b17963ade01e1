#include "PictureFile.h"

#include "seahex/io/Picture.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

namespace seahex
{

namespace
{

// A name of its own for each writer, so that two that write the same picture at once don't meet.
std::string partName(const std::string &path)
{
    static std::atomic<unsigned> count{0};
    static const unsigned process = std::random_device{}();
    return path + "." + std::to_string(process) + "-" + std::to_string(count++) + ".part";
}

}  // namespace

void replacePictureFile(const std::string &path, const std::string &bytes)
{
    const std::string part = partName(path);
    errno = 0;
    std::ofstream file(part, std::ios::binary);
    if (!file)
        throw PictureError("can't write the picture " + path + ": " + std::strerror(errno));
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    std::error_code failure;
    if (!file)
        failure = std::error_code(errno != 0 ? errno : EIO, std::generic_category());
    else
        std::filesystem::rename(part, path, failure);
    if (failure)
    {
        std::error_code ignored;
        std::filesystem::remove(part, ignored);
        throw PictureError("can't write the picture " + path + ": " + failure.message());
    }
}

}  // namespace seahex
