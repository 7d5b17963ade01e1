#pragma once

#include "Options.h"
#include "Seabed.h"

#include <seahex/io/GeoRoute.h>

#include <optional>
#include <vector>

namespace plan_dive
{

/// Clearance that is planned with besides what is asked for: what rounding of written positions (a centimetre) may take
/// on a slope of five to one.
constexpr double writingInHandM = 0.05;

/// A dive as it is written: positions rounded, long legs parted as toGeoRoute() does so that it doesn't matter who
/// reads them, depths to the millimetre and never rounded downwards.
/// @throws seahex::PositionError if a position can't be written
seahex::GeoRoute writtenDive(const std::vector<seahex::Point3> &dive, const Seabed &seabed, const DivePosition &from,
                             const DivePosition &to);

/// What a written dive's legs, straight in longitude and latitude, are measured and checked against.
struct WrittenMeasures
{
    double lengthM = 0.0;      ///< on the ellipsoid, with the depths
    double leastWaterM = 0.0;  ///< between the dive and the seabed below
    double leastDepthM = 0.0;
    double greatestDepthM = 0.0;
    double steepest = 0.0;                 ///< most metres up or down in a metre over ground; infinite on the spot
    std::optional<std::size_t> faultyLeg;  ///< the first, from 1, that does not keep the limits
};

/// @param climb  the steepest that the vehicle climbs or dives; 0: not limited. The limit is kept to the rounding of
///               what is written
WrittenMeasures measureWritten(const seahex::GeoRoute &written, const Seabed &seabed, const seahex::DiveArena &arena,
                               double climb);

}  // namespace plan_dive
