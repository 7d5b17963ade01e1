#include "Measured.h"

#include <seahex/geometry/SegmentSpans.h>
#include <seahex/route/RedundantNodes.h>
#include <seahex/world/SegmentValidity.h>

namespace reproduce_papers
{
namespace
{

using seahex::Point;

Measured measure(const Sea &sea, Cells cells, const seahex::Route &route, seahex::CountedLegs counted)
{
    const seahex::Occupancy &occupancy = sea.occupancy(cells);
    const double width = sea.occupancy(Cells::Hexagons).lattice().pitch();
    Measured measured;
    measured.metrics = seahex::measureRoute(route, occupancy, counted);
    measured.lengthW = route.length() / width;
    measured.stepsW = measured.metrics.lengthLattice * occupancy.lattice().pitch() / width;
    measured.nodes = route.waypoints().size();
    return measured;
}

bool isCentre(const seahex::Lattice &lattice, const Point &p)
{
    return (lattice.centre(lattice.cellAt(p)) - p).norm() < 1e-6 * lattice.pitch();
}

/// No cell within `margin` of the line is blocked; the edge of the chart blocks nothing, as it is no hazard.
bool hasMargin(const seahex::Occupancy &occupancy, const Point &a, const Point &b, double margin)
{
    const seahex::Lattice &lattice = occupancy.lattice();
    const seahex::SegmentSpans spans(lattice, a, b, margin);
    for (std::int64_t row = spans.firstRow(); row <= spans.lastRow(); ++row)
    {
        const seahex::RowSpan span = spans.span(row);
        for (std::int64_t column = span.firstColumn; column <= span.lastColumn; ++column)
            if (lattice.contains({column, row}) && occupancy.isBlocked({column, row}))
                return false;
    }
    return true;
}

}  // namespace

Measured measurePath(const Sea &sea, Cells cells, const seahex::Route &path)
{
    const seahex::Lattice &lattice = sea.occupancy(cells).lattice();
    const bool isOnCentres = isCentre(lattice, path.waypoints().front()) && isCentre(lattice, path.waypoints().back());
    return measure(sea, cells, path, isOnCentres ? seahex::CountedLegs::All : seahex::CountedLegs::BetweenCentres);
}

Measured measureSmoothed(const Sea &sea, Cells cells, const seahex::Route &route)
{
    return measure(sea, cells, route, seahex::CountedLegs::All);
}

seahex::Route smoothedAsPublished(const Sea &sea, Cells cells, const seahex::Route &path)
{
    const seahex::Occupancy &occupancy = sea.occupancy(cells);
    return seahex::dropRedundantNodes(path, [&occupancy](const Point &a, const Point &b)
                                      { return seahex::isFree(occupancy, a, b); });
}

seahex::Route smoothedWithMargin(const Sea &sea, Cells cells, const seahex::Route &path)
{
    const seahex::Occupancy &occupancy = sea.occupancy(cells);
    const double margin = occupancy.lattice().pitch();
    return seahex::dropRedundantNodes(path,
                                      [&occupancy, margin](const Point &a, const Point &b) {
                                          return seahex::isFree(occupancy, a, b) && hasMargin(occupancy, a, b, margin);
                                      });
}

}  // namespace reproduce_papers
