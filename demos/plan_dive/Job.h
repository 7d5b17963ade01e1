#pragma once

#include "Options.h"
#include "Seabed.h"
#include "WrittenDive.h"
#include "common/Progress.h"
#include "common/SpaceTrack.h"

#include <seahex/slices/SliceProblem.h>

#include <optional>
#include <vector>

namespace plan_dive
{

/// Everything that a successful run knows; the report and the pictures are made of it.
struct Result
{
    Seabed seabed;
    std::shared_ptr<const seahex::DiveArena> arena;  ///< with the limits asked for
    std::vector<seahex::Point3> dive;                ///< in the seabed's plane
    demos::TrackMeasures track;                      ///< of these points
    seahex::GeoRoute written;
    WrittenMeasures measures;                     ///< of the dive as written
    std::optional<seahex::SliceFigures> figures;  ///< by the criterion of [Xu]; planners on slices only
    double searchMs = 0.0;
    bool isImprovable = false;  ///< the time was over before the search was; this project's planners only
};

/// Reads the seabed, plans, writes down, measures and checks.
/// @throws demos::Failure
Result planDive(const Options &options, demos::Progress &progress);

}  // namespace plan_dive
