#pragma once

#include <seahex/geometry/Point.h>

#include <cstddef>
#include <vector>

namespace seahex
{

/// One straight piece of a route in the plane.
struct Leg
{
    Point from;
    Point to;

    double length() const { return (to - from).norm(); }
    /// Radians, mathematical (0 east, counter-clockwise), in (-pi, pi].
    double heading() const;
};

/// A route in the plane (x east, y north): waypoints and the straight legs between them. A value.
class Route
{
public:
    Route() = default;
    explicit Route(std::vector<Point> waypoints);

    const std::vector<Point> &waypoints() const { return waypoints_; }
    bool empty() const { return waypoints_.empty(); }
    std::size_t legCount() const { return waypoints_.size() < 2 ? 0 : waypoints_.size() - 1; }
    Leg leg(std::size_t i) const { return {waypoints_[i], waypoints_[i + 1]}; }

    /// Sum of the legs' lengths, in the plane's unit.
    double length() const;

private:
    std::vector<Point> waypoints_;
};

}  // namespace seahex
