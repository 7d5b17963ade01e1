#include "S57Updates.h"

#include "seahex/chart/ChartError.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <system_error>

namespace seahex
{
namespace
{

namespace fs = std::filesystem;

constexpr int MAX_UPDATE = 999;

/// An edition number of 0 in an update cancels the cell.
constexpr const char *CANCELLED = "0";

std::string extensionOf(int update)
{
    char extension[8];
    std::snprintf(extension, sizeof extension, ".%03d", update);
    return extension;
}

/// Updates lie beside the cell, or in folders of their own: NAME/0/NAME.000, NAME/1/NAME.001. The driver knows both.
std::map<int, fs::path> findUpdates(const fs::path &cell)
{
    std::map<int, fs::path> updates;
    std::error_code error;
    for (int number = 1; number <= MAX_UPDATE; ++number)
    {
        fs::path beside = cell;
        beside.replace_extension(extensionOf(number));
        const fs::path inFolder = cell.parent_path() / ".." / std::to_string(number) / beside.filename();
        if (fs::is_regular_file(beside, error))
            updates.emplace(number, beside);
        else if (fs::is_regular_file(inFolder, error))
            updates.emplace(number, inFolder);
    }
    return updates;
}

S57Header readUpdate(const fs::path &path, int number)
{
    const std::string file = path.filename().string();
    const DriverMessages messages;
    const GdalDataset dataset =
        openVector(path.string(), {"S57"}, {"UPDATES=IGNORE", "RETURN_PRIMITIVES=ON", "SPLIT_MULTIPOINT=OFF"});
    if (!dataset)
        throw ChartDamaged("update '" + path.string() + "' can't be read as S-57: " + messages.last());

    S57Header header = readS57Header(*dataset, path.string());
    if (header.updateNumber != number)
        throw ChartDamaged("update '" + path.string() + "' says that it is number " +
                           std::to_string(header.updateNumber) + ", but its name says " + std::to_string(number));
    // Updates made by some tools count insertions only, so more records than promised are no damage.
    const S57Counts counts = countS57Records(*dataset);
    if (counts.features < header.promisedFeatures || counts.spatials < header.promisedSpatials)
        throw ChartDamaged("update '" + path.string() + "' holds " + std::to_string(counts.features) + " of " +
                           std::to_string(header.promisedFeatures) + " feature records and " +
                           std::to_string(counts.spatials) + " of " + std::to_string(header.promisedSpatials) +
                           " spatial records: the file is cut or damaged");
    return header;
}

/// True if the update is due; false, with a warning, if it is of an earlier edition.
bool isOfEdition(const S57Header &base, const S57Header &update, const fs::path &path,
                 std::vector<std::string> &warnings)
{
    if (update.edition == base.edition)
        return true;
    if (update.edition == CANCELLED)
        throw ChartUnsupported("cell '" + base.dataSetName + "' is cancelled by its update '" + path.string() + "'");
    if (std::atoi(update.edition.c_str()) > std::atoi(base.edition.c_str()))
        throw ChartDamaged("update '" + path.string() + "' belongs to edition " + update.edition +
                           ", but the cell beside it is edition " + base.edition);
    warnings.push_back("update '" + path.string() + "' belongs to the earlier edition " + update.edition +
                       " and is not applied");
    return false;
}

}  // namespace

S57UpdatePlan planS57Updates(const fs::path &cell, const S57Header &base)
{
    S57UpdatePlan plan;
    int next = base.updateNumber + 1;
    bool inSequence = true;
    for (const auto &[number, path] : findUpdates(cell))
    {
        if (number < next)
        {
            plan.warnings.push_back("update '" + path.string() +
                                    "' is already part of the cell, which is re-issued at update " +
                                    std::to_string(base.updateNumber));
            continue;
        }
        if (inSequence && number > next)
        {
            inSequence = false;
            plan.warnings.push_back(
                "update " + std::to_string(next) + " of '" + cell.string() +
                "' is missing, so that later ones beside it are not applied: the chart is out of date");
        }
        if (!inSequence)
            continue;
        if (isOfEdition(base, readUpdate(path, number), path, plan.warnings))
            plan.lastToApply = number;
        ++next;
    }
    return plan;
}

}  // namespace seahex
