#include "S57Cell.h"

#include "S57Updates.h"

#include "seahex/chart/ChartError.h"

namespace seahex
{
namespace
{

// S-57's codes: an exchange purpose, a unit of depth, a horizontal datum and a unit of position.
constexpr int NEW_DATA_SET = 1;
constexpr int METRES = 1;
constexpr int WGS_84 = 2;
constexpr int LATITUDE_AND_LONGITUDE = 1;

GdalDataset open(const std::string &path, bool withUpdates, const DriverMessages &messages)
{
    // Soundings stay multipoints, so that the number of features is that of the file; the reader splits them.
    GdalDataset dataset = openVector(path, {"S57"},
                                     {withUpdates ? "UPDATES=APPLY" : "UPDATES=IGNORE", "SPLIT_MULTIPOINT=OFF",
                                      "LNAM_REFS=ON", withUpdates ? "RETURN_PRIMITIVES=OFF" : "RETURN_PRIMITIVES=ON"});
    if (!dataset && withUpdates)
        throw ChartDamaged("the updates of '" + path + "' can't be applied: " + messages.last());
    if (!dataset)
        throw ChartUnreadable("'" + path + "' can't be read as an S-57 cell: " + messages.last());
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

void checkCounts(GDALDataset &dataset, const S57Header &header, const std::string &path)
{
    const S57Counts counts = countS57Records(dataset);
    const auto check = [&path](std::int64_t found, std::int64_t promised, const char *kind)
    {
        if (found != promised)
            throw ChartDamaged("'" + path + "' holds " + std::to_string(found) + " of " + std::to_string(promised) +
                               " " + kind + " records: the file is cut or damaged");
    };
    check(counts.features, header.promisedFeatures, "feature");
    check(counts.spatials, header.promisedSpatials, "spatial");
}

}  // namespace

S57Cell openS57Cell(const std::filesystem::path &path, const DriverMessages &messages)
{
    // The counts of the header are those of the base file, so it is read without its updates first.
    const std::string file = path.string();
    S57Cell cell;
    cell.dataset = open(file, false, messages);
    cell.header = readS57Header(*cell.dataset, file);
    checkCounts(*cell.dataset, cell.header, file);
    checkUnits(cell.header, file);

    S57UpdatePlan plan = planS57Updates(path, cell.header);
    cell.warnings = std::move(plan.warnings);
    if (plan.lastToApply == 0)
        return cell;
    // GDAL starts at update 1 whatever the base holds, and then takes none or fails (its issue 13456).
    if (cell.header.updateNumber > 0)
        throw ChartDamaged("update " + std::to_string(plan.lastToApply) + " of '" + file +
                           "' can't be applied, because the cell is re-issued at update " +
                           std::to_string(cell.header.updateNumber) + ": take a later re-issue or edition");

    cell.dataset = open(file, true, messages);
    cell.header = readS57Header(*cell.dataset, file);
    if (cell.header.updateNumber != plan.lastToApply)
        throw ChartDamaged("update " + std::to_string(plan.lastToApply) + " of '" + file +
                           "' lies beside it but can't be applied: the cell is at update " +
                           std::to_string(cell.header.updateNumber));
    return cell;
}

}  // namespace seahex
