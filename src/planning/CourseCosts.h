#pragma once

#include "seahex/search/TurnBound.h"

#include <ompl/base/OptimizationObjective.h>

#include <optional>

namespace seahex
{

/// What an objective charges in SE(2), where that is all it charges: so much for a unit of length in the plane, for
/// each turn and for each radian of yaw. A motion's cost then depends on the difference of the two positions and on the
/// yaws alone, and a turn never costs less in two parts.
struct CourseCosts
{
    double perLength = 0.0;
    TurnCosts turns;
};

/// Of OMPL's path length (which charges for yaw too), TurnCountObjective, TurnAngleObjective, and sums of these with
/// weights that are not negative, sums of sums included. Recognised by their exact types: whoever derives from them may
/// charge anything. Empty for other objectives, and in spaces without yaw.
std::optional<CourseCosts> courseCosts(const ompl::base::OptimizationObjective &objective);

}  // namespace seahex
