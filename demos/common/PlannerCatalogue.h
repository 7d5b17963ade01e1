#pragma once

#include <ompl/base/Planner.h>

#include <string>

namespace demos
{

/// The planners that --planner knows besides HexAStar, OMPL's and SquareAStar, separated by commas.
std::string plannerNames();

bool isPlannerName(const std::string &name);

/// @throws Failure (Exit::Usage) for an unknown name
ompl::base::PlannerPtr makePlanner(const std::string &name, const ompl::base::SpaceInformationPtr &si);

}  // namespace demos
