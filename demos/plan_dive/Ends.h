#pragma once

#include "Options.h"
#include "Seabed.h"

namespace plan_dive
{

/// A position in the arena's plane, if the vehicle may be there.
/// @param role  "start" or "goal", for the message
/// @throws demos::Failure (Exit::NotNavigable) that says what is in the way and, where only the depth is, what depth
///         would do
seahex::Point3 endInWater(const Seabed &seabed, const seahex::DiveArena &arena, const DivePosition &position,
                          const std::string &role);

}  // namespace plan_dive
