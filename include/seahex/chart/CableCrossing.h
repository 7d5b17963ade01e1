#pragma once

#include <seahex/chart/Chart.h>
#include <seahex/chart/Projection.h>
#include <seahex/world/Bathymetry.h>

#include <memory>

namespace seahex
{

/// The seabed for a vehicle that crosses a chart's submarine cables above them, as raisedSeabed(): higher by a height
/// in every cell of its grid that a cable (CBLSUB) or a cable area (CBLARE, somewhere in which cables lie) touches, and
/// by DRVAL1 of a cable that is known to lie above the seabed. A cable may lie its class's radius or the margin to
/// either side of its charted line, whichever is more, an area by the margin; the frame's tolerance is added.
///
/// To be used with the columns of HazardScope::WaterColumnAboveCables: in those of HazardScope::WaterColumn cables are
/// walls from the seabed to the surface.
///
/// @param projection  the frame of the seabed's plane
/// @param heightM     between the vehicle's limit above bare seabed and that above cables, >= 0
/// @param marginM     metres, >= 0
/// @throws std::domain_error for a frame of degrees, or a height or margin that is negative or not finite
std::shared_ptr<const Bathymetry> raiseCables(const Bathymetry &seabed, const Chart &chart,
                                              const Projection &projection, double heightM, double marginM = 0.0);

}  // namespace seahex
