#pragma once

#include "Job.h"
#include "Options.h"

namespace plan_dive
{

/// Draws --profile: the vertical section along the dive as written.
/// @throws demos::Failure (Exit::Usage) if it can't be drawn or written
void drawProfile(const Options &options, const Result &result);

/// Draws --picture3d: the seabed around the dive, obliquely from above.
/// @throws demos::Failure (Exit::Usage) if it can't be drawn or written
void drawSeabed(const Options &options, const Result &result);

}  // namespace plan_dive
