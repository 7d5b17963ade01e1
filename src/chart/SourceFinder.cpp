#include "SourceFinder.h"

#include "seahex/chart/ChartError.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <system_error>

namespace seahex
{
namespace
{

namespace fs = std::filesystem;

/// Levels below a folder that are looked into: NAME/NAME.000 and ENC_ROOT/NAME/NAME.000.
constexpr int CELL_FOLDER_DEPTH = 2;

/// What of a folder is taken for an OGR source. A file that is named itself may have any extension.
constexpr std::array<std::string_view, 9> LAYER_EXTENSIONS = {".gpkg", ".geojson", ".json", ".shp",   ".fgb",
                                                              ".gml",  ".gdb",     ".tab",  ".sqlite"};

std::string lowerExtension(const fs::path &path)
{
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return extension;
}

bool isCell(const fs::path &path)
{
    return path.extension() == ".000";
}

/// ".001" and on.
bool isUpdate(const fs::path &path)
{
    const std::string extension = path.extension().string();
    return extension.size() == 4 && !isCell(path) &&
           std::all_of(extension.begin() + 1, extension.end(),
                       [](unsigned char letter) { return std::isdigit(letter); });
}

bool isLayerFile(const fs::path &path)
{
    const std::string extension = lowerExtension(path);
    return std::find(LAYER_EXTENSIONS.begin(), LAYER_EXTENSIONS.end(), extension) != LAYER_EXTENSIONS.end();
}

/// Sorted, so that a folder reads the same on every machine.
std::vector<fs::path> entriesOf(const fs::path &folder)
{
    std::error_code error;
    std::vector<fs::path> entries;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        entries.push_back(entry->path());
    if (error)
        throw ChartUnreadable("folder '" + folder.string() + "' can't be listed: " + error.message());
    std::sort(entries.begin(), entries.end());
    return entries;
}

void collectCells(const fs::path &folder, int depth, std::vector<fs::path> &cells)
{
    std::error_code ignored;
    for (const fs::path &entry : entriesOf(folder))
    {
        if (fs::is_directory(entry, ignored))
        {
            if (depth > 0)
                collectCells(entry, depth - 1, cells);
        }
        else if (isCell(entry))
            cells.push_back(entry);
    }
}

void addFolder(const fs::path &folder, SourceFiles &files)
{
    std::vector<fs::path> cells;
    collectCells(folder, CELL_FOLDER_DEPTH, cells);
    std::vector<fs::path> layers = entriesOf(folder);
    layers.erase(std::remove_if(layers.begin(), layers.end(), [](const fs::path &path) { return !isLayerFile(path); }),
                 layers.end());
    if (cells.empty() && layers.empty())
        throw ChartUnreadable("folder '" + folder.string() +
                              "' holds no chart: no S-57 cell (NAME.000) two levels deep, "
                              "and no GeoPackage, GeoJSON or shapefile");
    if (!cells.empty())
    {
        // A plain .json beside cells is rarely a chart.
        for (const fs::path &layer : layers)
            if (lowerExtension(layer) != ".json")
                files.warnings.push_back("'" + layer.string() + "' is not read, because its folder holds S-57 cells");
        layers.clear();
    }
    files.cells.insert(files.cells.end(), cells.begin(), cells.end());
    files.layers.insert(files.layers.end(), layers.begin(), layers.end());
}

void addFile(const fs::path &path, SourceFiles &files)
{
    if (isUpdate(path))
        throw ChartUnreadable("'" + path.string() +
                              "' is an update of an S-57 cell: name the cell itself (.000), its " +
                              "updates are applied with it");
    (isCell(path) ? files.cells : files.layers).push_back(path);
}

void addSource(const std::string &source, SourceFiles &files)
{
    const fs::path path(source);
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    const std::size_t layersBefore = files.layers.size();
    if (!fs::exists(status))
        throw ChartUnreadable("chart source '" + source + "' does not exist");
    if (fs::is_directory(status) && !isLayerFile(path))
        addFolder(path, files);
    else if (fs::is_regular_file(status) || fs::is_directory(status))
        addFile(path, files);
    else
        throw ChartUnreadable("chart source '" + source + "' is neither a file nor a folder");

    if (files.layers.size() == layersBefore)
        return;
    files.layersSource += (files.layersSource.empty() ? "" : ", ") + source;
    if (files.layersName.empty())
        files.layersName = fs::weakly_canonical(path, error).stem().string();
}

void keepEachOnce(std::vector<fs::path> &paths)
{
    std::vector<fs::path> seen;
    const auto isRepeated = [&seen](const fs::path &path)
    {
        std::error_code error;
        fs::path canonical = fs::canonical(path, error);
        if (error)
            canonical = path;
        if (std::find(seen.begin(), seen.end(), canonical) != seen.end())
            return true;
        seen.push_back(std::move(canonical));
        return false;
    };
    std::vector<fs::path> kept;
    for (const fs::path &path : paths)
        if (!isRepeated(path))
            kept.push_back(path);
    paths = std::move(kept);
}

}  // namespace

SourceFiles findSources(const std::vector<std::string> &sources)
{
    if (sources.empty())
        throw ChartUnreadable("no chart source is named");
    SourceFiles files;
    for (const std::string &source : sources)
        addSource(source, files);
    keepEachOnce(files.cells);
    keepEachOnce(files.layers);
    return files;
}

}  // namespace seahex
