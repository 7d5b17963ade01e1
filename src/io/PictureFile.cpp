#include "PictureFile.h"

#include "PartFile.h"

#include "seahex/io/Picture.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace seahex
{

void replacePictureFile(const std::string &path, const std::string &bytes)
{
    try
    {
        const PartFile part(path);
        errno = 0;
        std::ofstream file(part.name(), std::ios::binary);
        file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        file.close();
        if (!file)
            throw PartFile::Failure(std::strerror(errno != 0 ? errno : EIO));
        part.takePlace();
    }
    catch (const PartFile::Failure &failure)
    {
        throw PictureError("can't write the picture " + path + ": " + failure.what());
    }
}

}  // namespace seahex
