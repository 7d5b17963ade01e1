#pragma once

#include <seahex/chart/Chart.h>
#include <seahex/chart/ChartArena.h>
#include <seahex/geometry/GeoPoint.h>

#include <string>

namespace plan_route
{

/// The cell of a position, if a vessel may be there.
/// @param role  "start" or "goal", for the message
/// @throws demos::Failure (Exit::NotNavigable) that names the object in the way and the nearest navigable position
seahex::HexCoord navigableCell(const seahex::Chart &chart, const seahex::ChartArena &arena,
                               const seahex::GeoPoint &position, const std::string &role);

}  // namespace plan_route
