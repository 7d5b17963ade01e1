#include "seahex/world/KeptOccupancy.h"

#include "seahex/world/OccupancyFile.h"

#include <system_error>

namespace seahex
{
namespace
{

namespace fs = std::filesystem;

bool isNobodys(const fs::path &file)
{
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    return status.type() == fs::file_type::not_found ||
           (fs::is_regular_file(status) && fs::file_size(file, error) == 0 && !error);
}

/// The file's occupancy; nullptr if it is another one or damaged.
std::shared_ptr<const HexOccupancy> load(const fs::path &file, const std::string &provenance,
                                         std::vector<std::string> &warnings)
{
    try
    {
        return readProvenance(file) == provenance ? loadHexOccupancy(file, provenance) : nullptr;
    }
    catch (const OccupancyFileError &error)
    {
        warnings.push_back(std::string(error.what()) + "; it is replaced");
        return nullptr;
    }
}

/// Where a link leads to, so that the link stays one.
fs::path targetOf(const fs::path &file)
{
    std::error_code error;
    const fs::path target = fs::weakly_canonical(file, error);
    return error ? file : target;
}

}  // namespace

KeptOccupancy loadOrMake(const fs::path &file, const std::string &provenance,
                         const std::function<std::shared_ptr<const HexOccupancy>()> &make)
{
    KeptOccupancy kept;
    const bool isOurs = isOccupancyFile(file);
    if (isOurs)
        kept.occupancy = load(file, provenance, kept.warnings);
    kept.isFromFile = kept.occupancy != nullptr;
    if (kept.isFromFile)
        return kept;

    kept.occupancy = make();
    if (!isOurs && !isNobodys(file))
    {
        kept.warnings.push_back("'" + file.string() + "' holds no cells and is left alone: these are not kept");
        return kept;
    }
    try
    {
        saveOccupancy(targetOf(file), *kept.occupancy, provenance);
    }
    catch (const OccupancyFileError &error)
    {
        kept.warnings.push_back(error.what());
    }
    return kept;
}

}  // namespace seahex
