#pragma once

#include <seahex/geometry/Lattice.h>
#include <seahex/geometry/NodeGrid.h>
#include <seahex/geometry/Point3.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace seahex
{

/// The seabed as depths at the nodes of a regular grid, bilinear between them. Metres below a datum, positive down;
/// land is negative.
///
/// Unknown is dangerous: a node without depth makes the four closed cells around it unknown, and everything outside the
/// nodes' bounds is. Unknown depth is minus infinity, so that it is the least of any set that it belongs to.
///
/// "Least" is exact: nothing is sampled. The surface has no low point inside a cell, it is linear along the grid's
/// lines and quadratic along any other, so that the least depth of a figure is at one of finitely many points. In
/// doubles: up to the rounding of a position (1e-16 of its distance from the first node) and of a depth. Whether an
/// unknown cell is touched is told with gridTouchSteps in hand: rather yes than no.
///
/// Immutable; const functions, thread-safe, without allocation. Holds four bytes a node.
class Bathymetry
{
public:
    static constexpr float unknownDepth = -std::numeric_limits<float>::infinity();

    /// A depth as a node holds it: the nearest float that is not deeper.
    static float notDeeper(double depthM);

    /// @param depthsM  of the nodes, row by row from the south-west; whatever is not finite is unknown
    /// @throws std::length_error if there are not as many as nodes
    Bathymetry(const NodeGrid &grid, std::vector<float> depthsM);

    const NodeGrid &grid() const { return grid_; }

    /// The depth of a node of the grid; unknownDepth if it has none.
    float nodeDepth(std::int64_t column, std::int64_t row) const
    {
        return depthsM_[static_cast<std::size_t>(row * grid_.columns() + column)];
    }

    /// The greatest depth of all nodes; unknownDepth if none has one.
    float greatestDepth() const { return greatestDepthM_; }

    /// Depth below a point: of the bilinear surface, unknown if the point touches an unknown cell.
    double depthAt(const Point &p) const;

    /// Least depth of a closed box.
    double leastDepth(const Box &box) const;

    /// Least depth of a closed convex polygon, its corners in order. Time: linear in its rows and nodes, and the cells
    /// along its edges.
    double leastDepth(const std::vector<Point> &convexPolygon) const;

    /// Least depth of a closed cell of a lattice.
    double leastDepth(const Lattice &lattice, OffsetCoord cell) const { return leastDepth(lattice.corners(cell)); }

    /// Least depth along a closed segment. Time: linear in the cells that it touches.
    double leastDepth(const Point &a, const Point &b) const;

    /// The water below a straight line through it, where it is least: the least of the surface's depth minus z along
    /// the closed segment. The same for (a, b) and (b, a), bit for bit, and not more than at either end (depthAt - z).
    /// @param enough  as soon as a value less than this is found the answer may be that one instead of the least
    double leastWaterBelow(const Point3 &a, const Point3 &b,
                           double enough = -std::numeric_limits<double>::infinity()) const;

    /// Memory held, bytes.
    std::size_t byteCount() const { return sizeof *this + depthsM_.capacity() * sizeof(float); }

private:
    NodeGrid grid_;
    std::vector<float> depthsM_;
    float greatestDepthM_ = unknownDepth;
};

}  // namespace seahex
