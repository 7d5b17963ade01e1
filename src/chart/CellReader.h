#pragma once

#include "CellContents.h"

#include <filesystem>
#include <string>
#include <vector>

namespace seahex
{

/// Reads one S-57 cell with its updates.
/// @throws ChartUnreadable, ChartDamaged, ChartUnsupported, ChartEmpty
CellContents readS57Cell(const std::filesystem::path &path);

/// Reads OGR sources as one cell. Layers that bear no S-57 name are skipped.
/// @param name    what the cell is called
/// @param source  the sources as the user named them
/// @throws ChartUnreadable, ChartDamaged, ChartUnsupported, ChartEmpty
CellContents readLayerCell(const std::vector<std::filesystem::path> &files, const std::string &name,
                           const std::string &source);

}  // namespace seahex
