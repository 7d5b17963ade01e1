#pragma once

#include "S57Header.h"

#include <filesystem>
#include <string>
#include <vector>

namespace seahex
{

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
S57UpdatePlan planS57Updates(const std::filesystem::path &cell, const S57Header &base);

}  // namespace seahex
