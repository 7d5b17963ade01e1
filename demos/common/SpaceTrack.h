#pragma once

#include <seahex/geometry/Point3.h>

#include <vector>

namespace demos
{

/// What a track through space amounts to.
struct TrackMeasures
{
    double length = 0.0;          ///< in the unit of the points
    int courseChanges = 0;        ///< changes of direction above a millionth of a radian, up and down included
    double courseAngleDeg = 0.0;  ///< their sum
};

/// Points at the same place as the one before don't count.
TrackMeasures measureTrack(const std::vector<seahex::Point3> &points);

}  // namespace demos
