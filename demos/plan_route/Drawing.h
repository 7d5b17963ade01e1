#pragma once

#include "Job.h"
#include "Options.h"

namespace plan_route
{

/// Draws the picture of --picture.
/// @throws demos::Failure (Exit::Usage) if it can't be written
void drawPicture(const Options &options, const Result &result);

}  // namespace plan_route
