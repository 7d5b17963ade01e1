#include "seahex/world/SegmentValidity.h"

#include "seahex/geometry/SegmentSpans.h"

namespace seahex
{

bool isFree(const Occupancy &occupancy, const Point &a, const Point &b)
{
    if (!a.allFinite() || !b.allFinite())
        return false;
    // A long segment that begins or ends outside would otherwise be walked over an unbounded lattice.
    const Lattice &lattice = occupancy.lattice();
    if (!lattice.contains(lattice.cellAt(a)) || !lattice.contains(lattice.cellAt(b)))
        return false;
    return forEachTouchedCell(lattice, a, b, [&occupancy](OffsetCoord cell) { return occupancy.isFree(cell); });
}

std::optional<double> lastFree(const Occupancy &occupancy, const Point &a, const Point &b)
{
    if (!isFree(occupancy, a, a))
        return std::nullopt;
    if (isFree(occupancy, a, b))
        return 1.0;
    // A prefix of a free segment is free, so the answer can be bisected for.
    double free = 0.0;
    double blocked = 1.0;
    for (int i = 0; i < 40; ++i)
    {
        const double middle = 0.5 * (free + blocked);
        (isFree(occupancy, a, a + middle * (b - a)) ? free : blocked) = middle;
    }
    return free;
}

}  // namespace seahex
