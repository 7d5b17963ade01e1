#pragma once

#include <ompl/base/Planner.h>

#include <string>

namespace demos
{

/// OMPL's planners that --planner knows, separated by commas; HexAStar is known besides.
std::string plannerNames();

bool isPlannerName(const std::string &name);

/// @throws Failure (Exit::Usage) for an unknown name
ompl::base::PlannerPtr makePlanner(const std::string &name, const ompl::base::SpaceInformationPtr &si);

}  // namespace demos
