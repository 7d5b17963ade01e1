#pragma once

#include <ompl/base/Planner.h>

#include <string>

namespace demos
{

/// What the planners of dives are told; each takes what it knows.
struct DivePlannerSettings
{
    double lengthWeight = 0.5;    ///< K of [Xu]: length against danger
    double vehicleLengthM = 1.0;  ///< by which lengths are divided in F of [Xu]
    unsigned slices = 25;         ///< planes across the course, points across and levels of each
    unsigned across = 25;
    unsigned levels = 25;
    unsigned seed = 1;  ///< of ants; OMPL's planners have one seed for all
};

/// The planners that know dives (problems in R^3), separated by commas.
std::string divePlannerNames();

bool isDivePlannerName(const std::string &name);

/// @throws Failure (Exit::Usage) for an unknown name
ompl::base::PlannerPtr makeDivePlanner(const std::string &name, const ompl::base::SpaceInformationPtr &si,
                                       const DivePlannerSettings &settings);

}  // namespace demos
