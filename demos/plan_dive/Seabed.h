#pragma once

#include "Options.h"

#include <seahex/chart/ChartArena.h>
#include <seahex/world/DiveArena.h>

#include <memory>
#include <string>
#include <vector>

namespace plan_dive
{

/// The seabed that a dive is planned over, and what stands in the water.
struct Seabed
{
    std::shared_ptr<const seahex::Bathymetry> depths;
    seahex::Projection projection;                     ///< of its plane
    std::string source;                                ///< for people: file or charts
    std::shared_ptr<const seahex::Chart> chart;        ///< null without one
    std::shared_ptr<const seahex::ChartArena> around;  ///< columns to keep out of; null without a chart
    double aboveCablesM = 0.0;                         ///< by which the depths are less at the chart's cables
    double readMs = 0.0;

    std::vector<std::string> warnings() const;
};

/// Reads the waters of the voyage: of a raster a window around start and goal.
/// @throws demos::Failure (Exit::Chart) for what can't be read or is no seabed, (Exit::Usage) for a bad spacing
Seabed readSeabed(const Options &options);

/// The water between the limits.
/// @param inHandM  more clearance than asked for
/// @throws demos::Failure (Exit::Chart) if nowhere is water enough
std::shared_ptr<const seahex::DiveArena> makeDiveArena(const Seabed &seabed, const seahex::DiveLimits &limits,
                                                       double inHandM);

}  // namespace plan_dive
