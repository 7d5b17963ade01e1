#pragma once

#include <seahex/geometry/Point3.h>
#include <seahex/world/Bathymetry.h>
#include <seahex/world/Occupancy.h>

#include <limits>
#include <memory>

namespace seahex
{

/// Where in the water a vehicle may be, metres. Depths count from the seabed's datum.
struct DiveLimits
{
    double clearanceM = 5.0;  ///< least water between the vehicle and the seabed, straight down
    double ceilingM = 0.0;    ///< least depth of the vehicle; 0: it may surface
    double deepestM = std::numeric_limits<double>::infinity();  ///< greatest depth that it bears
};

/// The water over a seabed as one vehicle sees it: between a ceiling and a clearance above the bottom, and beside
/// columns that are kept out of from the surface to the seabed (wrecks, piles, cables: the blocked cells of an
/// occupancy; outside its lattice is blocked, too).
///
/// A straight line is free if all its points are: exact (Bathymetry, SegmentValidity), nothing is sampled. Unknown
/// seabed is not free. Immutable; const functions, thread-safe.
class DiveArena
{
public:
    /// Kept in hand above the clearance, so that whoever checks with other arithmetic finds it kept.
    static constexpr double roundingM = 1e-4;

    /// @param keepOut  in the seabed's plane; null for none
    /// @throws std::domain_error for limits that are negative or not numbers
    /// @throws std::runtime_error if nowhere is water enough for the clearance below the ceiling
    DiveArena(std::shared_ptr<const Bathymetry> seabed, const DiveLimits &limits,
              std::shared_ptr<const Occupancy> keepOut = nullptr);

    const std::shared_ptr<const Bathymetry> &seabed() const { return seabed_; }
    const std::shared_ptr<const Occupancy> &keepOut() const { return keepOut_; }
    const DiveLimits &limits() const { return limits_; }

    /// The least box that holds all free positions: the seabed's bounds, from the ceiling to the greatest depth at
    /// which the vehicle can be.
    const Point3 &lowest() const { return lowest_; }    ///< west, south, ceiling
    const Point3 &highest() const { return highest_; }  ///< east, north, greatest depth

    bool isFree(const Point3 &p) const;

    /// True if every point of the closed segment is free. The same for (b, a); both ends are free where it is.
    bool isFree(const Point3 &a, const Point3 &b) const;

    /// Metres to go straight up or down before a limit is reached, negative beyond it: how well a position lies, but no
    /// distance to a slope or a column beside it.
    double room(const Point3 &p) const;

private:
    bool isWithinDepths(const Point3 &p) const { return p.z() >= limits_.ceilingM && p.z() <= limits_.deepestM; }

    std::shared_ptr<const Bathymetry> seabed_;
    std::shared_ptr<const Occupancy> keepOut_;
    DiveLimits limits_;
    Point3 lowest_;
    Point3 highest_;
};

}  // namespace seahex
