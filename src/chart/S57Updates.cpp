#include "S57Updates.h"

#include "seahex/chart/ChartError.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <system_error>

namespace seahex
{
namespace
{

namespace fs = std::filesystem;

/// An edition number of 0 in an update cancels the cell.
constexpr const char *CANCELLED = "0";

constexpr std::size_t DIGITS = 3;

/// The number that a text of digits is; 0 if it is none.
int numberOf(const std::string &text)
{
    const bool isNumber = !text.empty() && text.size() <= DIGITS &&
                          std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    return isNumber ? std::atoi(text.c_str()) : 0;
}

std::string extensionOf(int update)
{
    std::string digits = std::to_string(update);
    return "." + std::string(DIGITS - digits.size(), '0') + digits;
}

/// Calls for every entry of a folder; for none if it can't be read.
template <class Visit>
void forEachEntry(const fs::path &folder, Visit &&visit)
{
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
         entry.increment(error))
        visit(entry->path());
}

S57Header readUpdate(const fs::path &path, int number)
{
    const DriverMessages messages;
    const GdalDataset dataset =
        openVector(path.string(), {"S57"}, {"UPDATES=IGNORE", "RETURN_PRIMITIVES=ON", "SPLIT_MULTIPOINT=OFF"});
    if (!dataset)
        throw ChartDamaged("update '" + path.string() + "' can't be read as S-57: " + messages.last());
    const S57Header header = readS57Header(*dataset, path.string());
    const S57Counts counts = countS57Records(*dataset);
    if (header.updateNumber != number)
        throw ChartDamaged("update '" + path.string() + "' says that it is number " +
                           std::to_string(header.updateNumber) + ", but its name says " + std::to_string(number));
    // Updates made by some tools count insertions only, so more records than promised are no damage.
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

S57UpdateFiles findS57Updates(const fs::path &cell)
{
    S57UpdateFiles updates;
    std::error_code error;
    const fs::path folder = cell.parent_path();
    forEachEntry(folder,
                 [&](const fs::path &entry)
                 {
                     const std::string extension = entry.extension().string();
                     const int number = extension.size() == DIGITS + 1 ? numberOf(extension.substr(1)) : 0;
                     if (number > 0 && entry.stem() == cell.stem() && fs::is_regular_file(entry, error))
                         updates.emplace(number, folder / entry.filename());
                 });
    forEachEntry(folder / "..",
                 [&](const fs::path &entry)
                 {
                     const int number = numberOf(entry.filename().string());
                     if (number == 0 || entry.filename() != std::to_string(number))
                         return;
                     fs::path update = folder / ".." / entry.filename() / cell.filename();
                     update.replace_extension(extensionOf(number));
                     if (fs::is_regular_file(update, error))
                         updates.emplace(number, update);
                 });
    return updates;
}

S57UpdatePlan planS57Updates(const fs::path &cell, const S57Header &base, const S57UpdateFiles &updates)
{
    S57UpdatePlan plan;
    int next = base.updateNumber + 1;
    bool inSequence = true;
    for (const auto &[number, path] : updates)
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
