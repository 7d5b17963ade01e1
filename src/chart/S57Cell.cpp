#include "S57Cell.h"

#include "S57Records.h"
#include "S57Updates.h"

#include "seahex/chart/ChartError.h"

#include <utility>

namespace seahex
{
namespace
{

// S-57's codes: an exchange purpose, a unit of depth, a horizontal datum and a unit of position.
constexpr int NEW_DATA_SET = 1;
constexpr int METRES = 1;
constexpr int WGS_84 = 2;
constexpr int LATITUDE_AND_LONGITUDE = 1;

/// What a dataset is opened for.
enum class Purpose
{
    Counting,  ///< the records of the base file, spatial ones included
    Base,      ///< the objects of the base file
    Updated    ///< the objects after the updates
};

GdalDataset tryToOpen(const std::string &path, Purpose purpose)
{
    // Soundings stay multipoints, so that the number of features is that of the file; the reader splits them.
    return openVector(path, {"S57"},
                      {purpose == Purpose::Updated ? "UPDATES=APPLY" : "UPDATES=IGNORE", "SPLIT_MULTIPOINT=OFF",
                       "LNAM_REFS=ON",
                       purpose == Purpose::Counting ? "RETURN_PRIMITIVES=ON" : "RETURN_PRIMITIVES=OFF"});
}

GdalDataset open(const std::string &path, Purpose purpose, const DriverMessages &messages)
{
    GdalDataset dataset = tryToOpen(path, purpose);
    if (!dataset)
        throw ChartUnreadable("'" + path + "' can't be read as an S-57 cell: " + messages.last());
    return dataset;
}

GdalDataset openUpdated(const std::string &path, const DriverMessages &messages)
{
    GdalDataset dataset = tryToOpen(path, Purpose::Updated);
    if (!dataset)
    {
        const std::string fault = messages.last();
        open(path, Purpose::Base, messages);  // throws if it is the base that can't be read
        throw ChartDamaged("the updates of '" + path + "' can't be applied: " + fault);
    }
    return dataset;
}

void demand(bool holds, const std::string &message)
{
    if (!holds)
        throw ChartUnsupported(message);
}

std::string shown(const std::optional<int> &code)
{
    return code ? std::to_string(*code) : "missing";
}

void checkUnits(const S57Header &header, const std::string &path)
{
    demand(header.exchangePurpose == NEW_DATA_SET,
           "'" + path + "' is no base cell: its exchange purpose (EXPP) is " + std::to_string(header.exchangePurpose));
    demand(header.depthUnit == METRES,
           "depths of '" + path + "' are not in metres: the unit of depths (DUNI) is " + shown(header.depthUnit));
    demand(header.horizontalDatum.value_or(WGS_84) == WGS_84,
           "positions of '" + path + "' are not on WGS-84: the horizontal datum (HDAT) is " +
               shown(header.horizontalDatum));
    demand(header.positionUnit.value_or(LATITUDE_AND_LONGITUDE) == LATITUDE_AND_LONGITUDE,
           "positions of '" + path + "' are not in degrees: the unit of coordinates (COUN) is " +
               shown(header.positionUnit));
    if (!(header.gridUnitsPerDegree > 0.0))
        throw ChartDamaged("'" + path + "' has no usable multiplication factor of coordinates (COMF)");
}

void checkCounts(const S57Counts &counts, const S57Header &header, const std::string &path)
{
    const auto check = [&path](std::int64_t found, std::int64_t promised, const char *kind)
    {
        if (found != promised)
            throw ChartDamaged("'" + path + "' holds " + std::to_string(found) + " of " + std::to_string(promised) +
                               " " + kind + " records: the file is cut or damaged");
    };
    check(counts.features, header.promisedFeatures, "feature");
    check(counts.spatials, header.promisedSpatials, "spatial");
}

/// Opens the base file, checks that it is whole, and tells its header.
///
/// The driver takes long to count spatial records, so those of a file that is in order are counted by its directories.
S57Cell openBase(const std::string &file, const std::optional<S57Records> &records, const DriverMessages &messages)
{
    S57Cell cell;
    cell.dataset = open(file, records ? Purpose::Base : Purpose::Counting, messages);
    cell.header = readS57Header(*cell.dataset, file);
    S57Counts counts = countS57Records(*cell.dataset);
    if (records)
        counts.spatials = records->counts().spatials;
    checkCounts(counts, cell.header, file);
    checkUnits(cell.header, file);
    return cell;
}

/// The same without the dataset, for a file that is opened with its updates later; empty if it must be opened to tell.
std::optional<S57Header> headerOfBase(const std::string &file, const std::optional<S57Records> &records)
{
    std::optional<S57Header> header = records ? records->header() : std::nullopt;
    if (header)
    {
        checkCounts(records->counts(), *header, file);
        checkUnits(*header, file);
    }
    return header;
}

}  // namespace

S57Cell openS57Cell(const std::filesystem::path &path, const DriverMessages &messages)
{
    const std::string file = path.string();
    const std::optional<S57Records> records = S57Records::of(path);
    const S57UpdateFiles updates = findS57Updates(path);
    S57Cell cell;
    // The counts of the header are those of the base file, so it is checked without its updates first.
    const std::optional<S57Header> base = updates.empty() ? std::nullopt : headerOfBase(file, records);
    if (base)
        cell.header = *base;
    else
        cell = openBase(file, records, messages);

    S57UpdatePlan plan = planS57Updates(path, cell.header, updates);
    if (plan.lastToApply == 0)
    {
        if (!cell.dataset)
            cell = openBase(file, records, messages);
        cell.warnings = std::move(plan.warnings);
        return cell;
    }
    // GDAL starts at update 1 whatever the base holds, and then takes none or fails (its issue 13456).
    if (cell.header.updateNumber > 0)
        throw ChartDamaged("update " + std::to_string(plan.lastToApply) + " of '" + file +
                           "' can't be applied, because the cell is re-issued at update " +
                           std::to_string(cell.header.updateNumber) + ": take a later re-issue or edition");

    cell.warnings = std::move(plan.warnings);
    cell.dataset = openUpdated(file, messages);
    cell.header = readS57Header(*cell.dataset, file);
    if (cell.header.updateNumber != plan.lastToApply)
        throw ChartDamaged("update " + std::to_string(plan.lastToApply) + " of '" + file +
                           "' lies beside it but can't be applied: the cell is at update " +
                           std::to_string(cell.header.updateNumber));
    return cell;
}

}  // namespace seahex
