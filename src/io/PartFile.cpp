#include "PartFile.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>

namespace fs = std::filesystem;

namespace seahex
{
namespace
{

std::string followed(const std::string &target)
{
    std::error_code ignored;
    if (fs::is_symlink(target, ignored) && !fs::exists(target, ignored))
        return (fs::absolute(target, ignored).parent_path() / fs::read_symlink(target, ignored)).string();
    if (!fs::exists(target, ignored))
        return target;
    if (!fs::is_regular_file(target, ignored))
        throw PartFile::Failure(fs::is_directory(target, ignored) ? std::strerror(EISDIR) : "Not a regular file");
    return fs::is_symlink(target, ignored) ? fs::canonical(target).string() : target;
}

// A name of its own for each writer, so that two that write the same file at once don't meet.
std::string nameBeside(const std::string &target)
{
    static std::atomic<unsigned> count{0};
    static const unsigned process = std::random_device{}();
    return target + "." + std::to_string(process) + "-" + std::to_string(count++) + ".part";
}

}  // namespace

PartFile::PartFile(const std::string &target) : target_(followed(target)), name_(nameBeside(target_))
{
    // tries out the folder, for the system's reason
    errno = 0;
    if (!std::ofstream(name_, std::ios::binary))
        throw Failure(std::strerror(errno));
    std::error_code ignored;
    fs::remove(name_, ignored);
}

PartFile::~PartFile()
{
    std::error_code ignored;
    fs::remove(name_, ignored);
}

void PartFile::takePlace() const
{
    std::error_code failure;
    fs::rename(name_, target_, failure);
    if (failure)
        throw Failure(failure.message());
}

}  // namespace seahex
