#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/Point.h>

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>

namespace seahex
{

/// How the states of a space lie in the plane: the only place that looks at a space's type.
///
/// Spaces: R^2 (RealVectorStateSpace of two dimensions) and SE(2) (SE2StateSpace itself; spaces derived from it, such
/// as Dubins and Reeds-Shepp, do not move along straight lines and are refused). A small value; const functions,
/// thread-safe.
class PlanarEmbedding
{
public:
    /// Does not own the space, which must outlive the embedding.
    /// @throws ompl::Exception if the space is none of the above
    explicit PlanarEmbedding(const ompl::base::StateSpace *space);

    /// x and y of a state.
    Point position(const ompl::base::State *state) const;

    /// Yaw of a state in radians; 0 where states have none.
    double heading(const ompl::base::State *state) const;

    /// Sets x and y of a state, and its yaw (radians, mathematical; any multiple of a turn) where the space has
    /// one.
    void place(ompl::base::State *state, const Point &position, double heading = 0.0) const;

    /// True if states have a yaw.
    bool hasHeading() const { return hasHeading_; }

    /// The bounds of x and y.
    Box bounds() const;

    /// What the space's distance charges for a unit of length in the plane: 1 for R^2, the weight of the first subspace
    /// for SE(2).
    double lengthWeight() const;

private:
    const ompl::base::StateSpace *space_;
    bool hasHeading_;
};

}  // namespace seahex
