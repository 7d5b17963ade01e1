#pragma once

#include <seahex/geometry/Point3.h>

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
    unsigned rings = 2;      ///< of PrismAStar's jumps, 1 to 3
    double cellSizeM = 0.0;  ///< pitch of its hexagons; 0: its own choice
    double layerM = 0.0;     ///< between its layers, at most; 0: its own choice
    double climb = 0.0;      ///< metres that its vehicle climbs or dives in a metre of the plane; 0: not limited
    unsigned seed = 1;       ///< of ants; OMPL's planners have one seed for all
};

/// The distance between slices, which stands for a vehicle's length where none is named.
double sliceDistanceM(const seahex::Point3 &start, const seahex::Point3 &goal, unsigned slices);

/// The planners that know dives (problems in R^3), separated by commas.
std::string divePlannerNames();

bool isDivePlannerName(const std::string &name);

/// Does it know K, a vehicle's length, slices, points across and levels?
bool plansOnSlices(const std::string &name);

/// Does it know rings, a cell size, layers and a climb?
bool plansOnPrisms(const std::string &name);

/// @throws Failure (Exit::Usage) for an unknown name
ompl::base::PlannerPtr makeDivePlanner(const std::string &name, const ompl::base::SpaceInformationPtr &si,
                                       const DivePlannerSettings &settings);

}  // namespace demos
