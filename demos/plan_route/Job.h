#pragma once

#include "Options.h"
#include "common/Progress.h"

#include <seahex/chart/Chart.h>
#include <seahex/chart/ChartArena.h>
#include <seahex/io/GeoRoute.h>
#include <seahex/route/Route.h>
#include <seahex/route/RouteMetrics.h>

#include <memory>
#include <optional>
#include <vector>

namespace plan_route
{

/// A route with its numbers, and as it is written.
struct MeasuredRoute
{
    seahex::Route plane;
    seahex::GeoRoute written;
    seahex::RouteMetrics metrics;
    /// Objects that the line crosses and whose rules are not judged yet: bridges, overhead cables, regulated areas.
    std::vector<const seahex::HazardObject *> crosses;
};

/// Everything that a successful run knows; the report and the picture are made of it.
struct Result
{
    std::shared_ptr<const seahex::Chart> chart;
    std::shared_ptr<const seahex::ChartArena> arena;
    seahex::HexCoord startCell;
    seahex::HexCoord goalCell;
    MeasuredRoute raw;
    std::optional<MeasuredRoute> smoothed;
    std::uint64_t expanded = 0;  ///< cells; 0 for planners that have none
    double searchMs = 0.0;
    bool isProvenShortest = false;         ///< no route in the plane of the cells is shorter than the smoothed one
    bool isImprovable = false;             ///< the time was over before the search was; HexAStar only
    std::vector<seahex::CellIndex> trace;  ///< expanded cells in order, if a picture is wanted

    const MeasuredRoute &best() const { return smoothed ? *smoothed : raw; }
};

/// Reads the chart, builds the arena, plans, smooths, measures and checks.
/// @throws demos::Failure
Result planRoute(const Options &options, demos::Progress &progress);

}  // namespace plan_route
