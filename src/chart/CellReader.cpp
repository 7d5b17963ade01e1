#include "CellReader.h"

#include "GroupOne.h"
#include "LayerReader.h"
#include "Overlay.h"
#include "S57Cell.h"
#include "S57Classes.h"
#include "S57Updates.h"
#include "Surroundings.h"

#include "seahex/chart/ChartError.h"

#include <cpl_string.h>

#include <cstdlib>
#include <iterator>
#include <system_error>

namespace seahex
{
namespace
{

/// The layer in which the S-57 driver puts objects of classes that it does not know.
constexpr const char *UNKNOWN_CLASSES = "Generic";

/// The base file and every update found with it, whether it is applied or not.
std::vector<std::filesystem::path> filesOfCell(const std::filesystem::path &base)
{
    std::vector<std::filesystem::path> files{base};
    for (const auto &[number, update] : findS57Updates(base))
        files.push_back(update);
    return files;
}

/// All files that a source consists of: those of a shapefile are four or more.
std::vector<std::filesystem::path> filesOfDataset(GDALDataset &dataset)
{
    const CPLStringList names(dataset.GetFileList());
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (int i = 0; i < names.size(); ++i)
        if (std::filesystem::is_regular_file(names[i], ignored))
            files.emplace_back(names[i]);
    return files;
}

void fillReport(const S57Cell &source, const std::filesystem::path &path, CellReport &report)
{
    const S57Header &header = source.header;
    report.name = std::filesystem::path(header.dataSetName).stem().string();
    if (report.name.empty())
        report.name = path.stem().string();
    report.source = path.string();
    report.files = filesOfCell(path);
    if (!header.edition.empty())
        report.edition = std::atoi(header.edition.c_str());
    report.update = header.updateNumber;
    report.issueDate = header.issueDate;
    report.scale = header.scale;
    report.verticalDatum = header.verticalDatum;
    report.soundingDatum = header.soundingDatum;
    report.warnings = source.warnings;
}

std::size_t unknownObjects(const CellReport &report)
{
    const auto found = report.skipped.find(whyNotJudged(UNKNOWN_CLASSES));
    std::size_t count = 0;
    if (found != report.skipped.end())
        for (const auto &[objectClass, objects] : found->second)
            count += objects;
    return count;
}

void addMessages(const DriverMessages &messages, CellContents &cell)
{
    for (const std::string &line : messages.lines())
        cell.warn("driver: " + line);
}

/// Reads the layers of an OGR source that bear an S-57 name.
/// @return whether there was one
bool readNamedLayers(GDALDataset &dataset, const std::string &file, DriverMessages &messages, CellContents &cell)
{
    bool any = false;
    for (int i = 0; i < dataset.GetLayerCount(); ++i)
    {
        OGRLayer *layer = dataset.GetLayer(i);
        const std::string objectClass = s57ClassOf(layer->GetName());
        if (objectClass.empty())
        {
            cell.warn("layer " + std::string(layer->GetName()) + " of '" + file +
                      "' is not read, because its name is no S-57 class");
            continue;
        }
        any = true;
        LayerReader(*layer, objectClass, messages, cell).read();
    }
    return any;
}

bool readLayerFile(const std::string &file, CellContents &cell)
{
    DriverMessages messages;
    const GdalDataset dataset = openVector(file, {}, {});
    if (!dataset)
        throw ChartUnreadable("'" + file + "' can't be read as a chart: " + messages.last());
    if (std::string(dataset->GetDriver()->GetDescription()) == "S57")
        throw ChartUnreadable("'" + file + "' is S-57, but is not named like a cell (NAME.000)");
    const std::vector<std::filesystem::path> files = filesOfDataset(*dataset);
    cell.report.files.insert(cell.report.files.end(), files.begin(), files.end());
    const bool any = readNamedLayers(*dataset, file, messages, cell);
    addMessages(messages, cell);
    return any;
}

/// What must hold before the coverage may be trusted: its rings do not cross, and what is declared to hold no data is
/// no part of it.
void settleCoverage(CellContents &cell)
{
    if (!isSimple(cell.coverage))
        throw ChartDamaged("the coverage (M_COVR) of '" + cell.report.source + "' crosses itself");
    if (cell.noData.empty() || !overlap(cell.coverage, cell.noData))
        return;
    std::vector<Polygon> rest;
    if (!subtract(cell.coverage, cell.noData, 0.0, rest) || rest.empty())
        throw ChartEmpty("the coverage of '" + cell.report.source +
                         "' is declared to hold no data (M_COVR with CATCOV 2)");
    cell.coverage = std::move(rest);
    cell.warn("a part of the coverage of " + cell.report.name + " is declared to hold no data and is blocked");
}

/// Coverage that no M_COVR gives is what the areas of group 1 cover.
void coverByGroupOne(CellContents &cell)
{
    const std::vector<Polygon> areas = groupOneAreas(cell);
    if (areas.empty())
        throw ChartEmpty("chart '" + cell.report.source +
                         "' holds neither coverage (M_COVR with CATCOV 1) nor areas of group 1");
    cell.coverage = unite(areas);
    if (cell.coverage.empty())
        cell.coverage = areas;
    cell.warn("'" + cell.report.source +
              "' holds no coverage (M_COVR with CATCOV 1): that of its areas of group 1 is taken");
}

}  // namespace

CellContents readS57Cell(const std::filesystem::path &path)
{
    DriverMessages messages;
    const S57Cell source = openS57Cell(path, messages);
    CellContents cell;
    cell.gridUnitsPerDegree = source.header.gridUnitsPerDegree;
    fillReport(source, path, cell.report);

    for (int i = 0; i < source.dataset->GetLayerCount(); ++i)
    {
        OGRLayer *layer = source.dataset->GetLayer(i);
        if (!isS57Bookkeeping(layer->GetName()))
            LayerReader(*layer, layer->GetName(), messages, cell, LayerReader::InDegrees{}).read();
    }
    if (const std::size_t count = unknownObjects(cell.report); count > 0)
        cell.warn(cell.report.name + " holds " + std::to_string(count) +
                  " objects of unknown classes, which are not used");
    if (cell.coverage.empty())
        throw ChartEmpty("cell '" + path.string() + "' holds no coverage: no M_COVR with CATCOV 1");
    settleCoverage(cell);
    fillSurroundingDepths(cell);
    checkGroupOne(cell);
    addMessages(messages, cell);
    return cell;
}

CellContents readLayerCell(const std::vector<std::filesystem::path> &files, const std::string &name,
                           const std::string &source)
{
    CellContents cell;
    cell.report.name = name;
    cell.report.source = source;
    bool any = false;
    for (const std::filesystem::path &file : files)
        any = readLayerFile(file.string(), cell) || any;
    if (!any)
        throw ChartUnsupported("chart '" + source +
                               "' has no layer that bears the name of an S-57 class (DEPARE, LNDARE, ...)");

    DriverMessages messages;
    const bool hasCoverage = !cell.coverage.empty();
    if (!hasCoverage)
        coverByGroupOne(cell);
    settleCoverage(cell);
    fillSurroundingDepths(cell);
    if (hasCoverage)
        checkGroupOne(cell);
    addMessages(messages, cell);
    return cell;
}

}  // namespace seahex
