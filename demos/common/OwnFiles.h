#pragma once

#include <string>

namespace demos
{

/// A file or folder that belongs to these programs, looked for beside the executable's folder in the build tree, then
/// in the install tree's share/seahex.
/// @return empty if it is in neither
std::string ownFile(const std::string &name);

/// Path of one of the project's own charts.
/// @throws Failure (Exit::Chart) if there is none
std::string ownChart(const std::string &name);

}  // namespace demos
