#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace seahex
{

/// The files behind the sources that a user named.
struct SourceFiles
{
    std::vector<std::filesystem::path> cells;   ///< S-57 base cells, each once
    std::vector<std::filesystem::path> layers;  ///< other sources, for OGR
    std::vector<std::string> warnings;          ///< files that were passed over
    std::string layersName;                     ///< what the other sources are called as one cell
    std::string layersSource;                   ///< their paths as given
};

/// Looks into folders: for cells two levels deep, and where there are none for OGR files in the folder itself.
/// @throws ChartUnreadable if a source does not exist, is an update without being asked for, or is a folder without
/// charts
SourceFiles findSources(const std::vector<std::string> &sources);

}  // namespace seahex
