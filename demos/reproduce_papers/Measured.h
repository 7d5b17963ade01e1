#pragma once

#include "Sea.h"

#include <seahex/route/RouteMetrics.h>

namespace reproduce_papers
{

/// A route's numbers in one unit for all cells.
struct Measured
{
    seahex::RouteMetrics metrics;
    double lengthW = 0.0;  ///< straight, in widths of the hexagons compared
    double stepsW = 0.0;   ///< in the metric of the cells, in the same unit
    std::size_t nodes = 0;
};

/// A planner's path, from centre to centre, without the legs that join start and goal; of one whose start and goal are
/// centres, all of it.
Measured measurePath(const Sea &sea, Cells cells, const seahex::Route &path);

/// A route that was smoothed, all of it.
Measured measureSmoothed(const Sea &sea, Cells cells, const seahex::Route &route);

/// Leaves redundant nodes out as [Wang2017] says, lines through free cells only.
seahex::Route smoothedAsPublished(const Sea &sea, Cells cells, const seahex::Route &path);

/// The same with a margin, as the authors' program has it: a line with a blocked cell within one cell of it is met by
/// an obstacle.
seahex::Route smoothedWithMargin(const Sea &sea, Cells cells, const seahex::Route &path);

}  // namespace reproduce_papers
