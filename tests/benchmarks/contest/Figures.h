#pragma once

#include <map>
#include <string>

namespace seahex::contest
{

/// Figures that another program left: a JSON object of names and numbers. Empty if there is no such file.
/// @throws std::runtime_error if it holds anything else
std::map<std::string, double> readFigures(const std::string &file);

/// Leaves figures for a later run.
/// @throws std::runtime_error if the file can't be written
void writeFigures(const std::map<std::string, double> &figures, const std::string &file);

}  // namespace seahex::contest
