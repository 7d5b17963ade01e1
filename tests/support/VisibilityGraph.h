#pragma once

#include <seahex/world/Occupancy.h>

#include <vector>

namespace seahex::test
{

/// What the shortest paths among blocked hexagons are held against: every corner of a blocked cell, every pair of them
/// that see each other, and Dijkstra's algorithm. Plain, slow, in the plane's own coordinates; sight is judged cell by
/// cell. Free space is closed: a segment may touch blocked cells, but not enter one, nor slip in between two.
class VisibilityGraph
{
public:
    explicit VisibilityGraph(const HexOccupancy &occupancy);

    /// Length of the shortest path; infinity if there is none. The points must not touch blocked cells.
    double shortest(const Point &start, const Point &goal) const;

    bool sees(const Point &a, const Point &b) const;

    /// Where a path may turn: the corners of just one blocked cell.
    const std::vector<Point> &corners() const { return corners_; }

private:
    double pitch_;
    std::vector<Point> centres_;  // of blocked cells, those around the rectangle included
    std::vector<Point> corners_;
    std::vector<Point> inlets_;  // where two blocked cells meet
    std::vector<std::vector<double>> lengths_;
};

}  // namespace seahex::test
