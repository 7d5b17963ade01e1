#include "support/TestData.h"

#include <cstdlib>
#include <system_error>

namespace seahex::test
{

namespace fs = std::filesystem;

std::optional<fs::path> testData(const std::string &name)
{
    const char *folder = std::getenv("SEAHEX_TEST_DATA");
    if (folder == nullptr)
        return std::nullopt;
    fs::path data = fs::path(folder) / name;
    std::error_code error;
    return fs::is_directory(data, error) ? std::optional<fs::path>(data) : std::nullopt;
}

std::string whyNoTestData(const std::string &name)
{
    const char *folder = std::getenv("SEAHEX_TEST_DATA");
    if (folder == nullptr)
        return "the environment variable SEAHEX_TEST_DATA does not name the folder that holds " + name + "/";
    return "'" + std::string(folder) + "' (SEAHEX_TEST_DATA) holds no folder " + name + "/";
}

}  // namespace seahex::test
