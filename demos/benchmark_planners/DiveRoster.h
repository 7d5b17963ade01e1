#pragma once

#include "RecordedPlanner.h"
#include "common/DiveCatalogue.h"

#include <ompl/base/SpaceInformation.h>

#include <memory>
#include <string>
#include <vector>

namespace benchmark_planners
{

/// The names of the planners of dives that can be compared, in the order of tables and plots.
std::vector<std::string> diveRosterNames();

/// A new planner of the roster of dives.
/// @throws std::out_of_range for a name that is not in it
std::shared_ptr<RecordedPlanner> makeFromDiveRoster(const std::string &name, const ompl::base::SpaceInformationPtr &si,
                                                    const demos::DivePlannerSettings &settings);

}  // namespace benchmark_planners
