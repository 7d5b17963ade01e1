#pragma once

#include <seahex/world/Occupancy.h>

#include <optional>

namespace seahex
{

/// A cell and its distance from a point, in the plane's unit.
struct CellDistance
{
    OffsetCoord cell;
    double distance;
};

/// The blocked cell nearest to a point (distance to the closed cell; 0 inside a blocked cell). The cells just
/// outside the lattice are blocked, so there is always one.
///
/// Looks along rows of bits outwards from the point, 64 cells at a time: about k^2 / 64 word reads where the answer
/// lies k cells away. Const, no cache, thread-safe.
CellDistance nearestBlocked(const Occupancy &occupancy, const Point &p);

/// The free cell nearest to a point; empty if no cell is free.
std::optional<CellDistance> nearestFree(const Occupancy &occupancy, const Point &p);

/// Signed clearance of a point: the distance to the nearest blocked cell where the point's cell is free; where it is
/// blocked, minus the distance to the nearest free cell (minus infinity if there is none). It is a lower bound of the
/// distance to the hazards themselves, which lie inside blocked cells, less the radius they were grown by.
double signedClearance(const Occupancy &occupancy, const Point &p);

}  // namespace seahex
