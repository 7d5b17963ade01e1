#pragma once

#include "S57Header.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace seahex
{

/// The update files of a cell by their numbers.
using S57UpdateFiles = std::map<int, std::filesystem::path>;

/// Updates lie beside the cell, or in folders of their own: NAME/0/NAME.000, NAME/1/NAME.001. The driver knows both.
S57UpdateFiles findS57Updates(const std::filesystem::path &cell);

/// Which updates of a cell lie beside it and what is to be done with them.
struct S57UpdatePlan
{
    int lastToApply = 0;  ///< number of the last update that must be applied; 0 if none
    std::vector<std::string> warnings;
};

/// Looks at every update file of the cell, because the driver passes over those that it can't read without a word.
///
/// Updates are applied in sequence from the one after the base cell's own number. Those of an earlier edition, or that
/// a re-issued base cell already contains, are left with a warning; so are those behind a gap in the sequence.
/// @throws ChartDamaged if an update that is due can't be read, is cut, or belongs to a later edition;
///         ChartUnsupported if it cancels the cell
S57UpdatePlan planS57Updates(const std::filesystem::path &cell, const S57Header &base, const S57UpdateFiles &updates);

}  // namespace seahex
