#pragma once

#include <seahex/geometry/Shape.h>
#include <seahex/world/Bathymetry.h>

#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

/// Something that lies on a seabed and is passed above: a cable.
struct LyingObject
{
    Shape shape;                        ///< in the seabed's plane
    double radius = 0.0;                ///< >= 0: how far from there it may lie
    std::optional<double> leastDepthM;  ///< of its highest point, if that is known
};

/// A seabed as it is for a vehicle that keeps a height above what lies on it: in each closed cell of the grid that
/// comes within an object's radius of it, every point is at least that height shoaler, and not deeper than the height
/// above the object's own least depth; no point anywhere is deeper than before. Nothing is sampled: all four nodes of
/// such a cell are raised, and between them the surface is bilinear; so cells beside it slope up to them. Where the
/// grid's spacing differs from column to row, the radius counts as so many times longer across the wider. Unknown stays
/// unknown.
///
/// Time is linear in the nodes, times one more than the different least depths.
///
/// @throws std::domain_error for a height that is negative or not finite, or a coordinate that is not a number
std::shared_ptr<const Bathymetry> raisedSeabed(const Bathymetry &seabed, const std::vector<LyingObject> &objects,
                                               double heightM);

}  // namespace seahex
