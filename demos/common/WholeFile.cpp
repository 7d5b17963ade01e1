#include "WholeFile.h"

#include "Failure.h"

#include <fstream>
#include <random>
#include <sstream>
#include <system_error>

namespace demos
{
namespace
{

namespace fs = std::filesystem;

[[noreturn]] void cannot(const char *what, const fs::path &file)
{
    throw Failure(Exit::Usage, std::string("can't ") + what + " " + file.string());
}

fs::path writePart(const fs::path &file, const std::string &text)
{
    fs::path part = partName(file);
    std::ofstream out(part, std::ios::binary);
    out << text;
    out.close();
    if (out)
        return part;
    std::error_code ignored;
    fs::remove(part, ignored);
    cannot("write", file);
}

}  // namespace

fs::path partName(const fs::path &file)
{
    std::random_device device;  // processes on other machines may write into the same folder
    std::ostringstream suffix;
    suffix << ".part-" << std::hex << device() << device();
    return file.string() + suffix.str();
}

void writeWhole(const fs::path &file, const std::string &text)
{
    const fs::path part = writePart(file, text);
    std::error_code error;
    fs::rename(part, file, error);
    if (error)
        cannot("write", file);
}

void writeWholeIfAbsent(const fs::path &file, const std::string &text)
{
    const fs::path part = writePart(file, text);
    std::error_code error;
    fs::create_hard_link(part, file, error);  // unlike a rename it never replaces
    std::error_code ignored;
    if (error && !fs::exists(file, ignored))
        fs::rename(part, file, ignored);  // a file system without hard links
    fs::remove(part, ignored);
    if (!fs::exists(file, ignored))
        cannot("write", file);
}

std::string readWhole(const fs::path &file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in)
        cannot("read", file);
    return text.str();
}

}  // namespace demos
