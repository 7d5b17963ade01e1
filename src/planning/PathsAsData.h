#pragma once

#include "planning/EndStates.h"

#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/PlannerData.h>
#include <ompl/geometric/PathGeometric.h>

#include <memory>
#include <vector>

namespace seahex
{

/// Writes the starts of a problem and paths from them to its goals: each leg an edge, weighted by the objective. States
/// of two paths are two vertices, but starts and goals are the problem's own.
void writePaths(const std::vector<std::shared_ptr<ompl::geometric::PathGeometric>> &paths, const EndStates &ends,
                const ompl::base::OptimizationObjective &objective, ompl::base::PlannerData &data);

}  // namespace seahex
