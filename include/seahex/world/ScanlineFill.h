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
/// the rows that the polygon spans, the crossings of edges with rows (sorted within their row) and the words written.
/// Keeps its buffers from polygon to polygon.
class ScanlineFill
{
public:
    explicit ScanlineFill(const Lattice &lattice);

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

    double rowOf(const Point &p) const;
    void limitRows(const Polygon &polygon);

    Lattice lattice_;
    Point firstCentre_;  // x of the lattice's origin, y of the centres of row 0
    double rowsPerUnit_;
    std::int64_t begin_ = 0;  // rows of the lattice that the polygon spans
    std::int64_t end_ = 0;
    std::vector<std::uint32_t> rowStart_;  // where the crossings of each row from begin_ on start
    std::vector<Crossing> crossings_;
};

}  // namespace seahex
