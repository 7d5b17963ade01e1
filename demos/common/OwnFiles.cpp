#include "OwnFiles.h"

#include "Failure.h"

#include <filesystem>
#include <system_error>

namespace demos
{

std::string ownFile(const std::string &name)
{
    namespace fs = std::filesystem;
    std::error_code ignored;
    const fs::path folder = fs::read_symlink("/proc/self/exe", ignored).parent_path();
    for (const char *place : {"..", "../share/seahex"})
    {
        const fs::path candidate = folder / place / name;
        if (fs::exists(candidate, ignored))
            return fs::weakly_canonical(candidate, ignored).string();
    }
    return "";
}

std::string ownChart(const std::string &name)
{
    std::string found = ownFile("maps/" + name);
    if (found.empty())
        throw Failure(Exit::Chart, "the chart " + name +
                                       " is neither in the source tree nor in the install tree of this " +
                                       "program; name it with --chart");
    return found;
}

}  // namespace demos
