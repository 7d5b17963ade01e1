#pragma once

#include <seahex/geometry/Lattice.h>
#include <seahex/geometry/Shape.h>
#include <seahex/world/CellBits.h>

#include <cstdint>
#include <vector>

namespace seahex
{

/// Sets the bits of all cells whose centre lies inside a polygon, row by row.
///
/// Inside means a winding number other than 0, holes counted against the outer ring whatever their stored orientation:
/// a ring that crosses itself therefore fills too much rather than too little. Centres within rounding of an edge may
/// fall either way; whoever needs any-touch sets the cells along the edges besides. Time is linear in the edges plus
/// the crossings of edges with rows (sorted within their row) plus the words written. Keeps its buffers from polygon to
/// polygon.
class ScanlineFill
{
public:
    explicit ScanlineFill(const Lattice &lattice) : lattice_(lattice) {}

    void fill(const Polygon &polygon, CellBits &bits);

private:
    struct Crossing
    {
        double x;     // relative to the lattice's origin
        int winding;  // +1 where the edge runs south, -1 where it runs north
    };

    void countRing(const Ring &ring);
    void placeRing(const Ring &ring, int orientation);
    template <class Visit>
    void forEachCrossing(const Ring &ring, Visit &&visit) const;

    Lattice lattice_;
    std::vector<std::uint32_t> rowStart_;  // where the crossings of each row begin
    std::vector<Crossing> crossings_;
};

}  // namespace seahex
