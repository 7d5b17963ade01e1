#pragma once

#include "RecordedPlanner.h"

#include <ompl/base/SpaceInformation.h>

#include <memory>
#include <string>
#include <vector>

namespace benchmark_planners
{

/// The names of the planners that can be compared, in the order of tables and plots.
std::vector<std::string> rosterNames();

/// A new planner of the roster.
/// @throws std::out_of_range for a name that is not in it
std::shared_ptr<RecordedPlanner> makeFromRoster(const std::string &name, const ompl::base::SpaceInformationPtr &si);

}  // namespace benchmark_planners
