#pragma once

#include "S57Header.h"

#include <filesystem>
#include <string>
#include <vector>

namespace seahex
{

/// An S-57 cell, open with its updates applied, whose own book-keeping has been found right.
struct S57Cell
{
    GdalDataset dataset;
    S57Header header;  ///< after the updates
    std::vector<std::string> warnings;
};

/// @throws ChartUnreadable if it can't be opened; ChartDamaged if records or updates are missing; ChartUnsupported if
/// its
///         depths are not in metres or its positions not in WGS-84 degrees
/// @param messages  must be listening; names what the driver says where it refuses
S57Cell openS57Cell(const std::filesystem::path &path, const DriverMessages &messages);

}  // namespace seahex
