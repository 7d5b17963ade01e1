#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/Point.h>

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>

namespace seahex
{

/// How the states of a space lie in the plane: the only place that looks at a space's type.
///
/// Spaces: R^2 (RealVectorStateSpace of two dimensions), SE(2) (SE2StateSpace itself; spaces derived from it, such as
/// Dubins and Reeds-Shepp, do not move along straight lines and are refused), and HexStateSpace, whose states lie at
/// the centres of cells. A small value; const functions, thread-safe.
class PlanarEmbedding
{
public:
    /// Does not own the space, which must outlive the embedding.
    /// @throws ompl::Exception if the space is none of the above
    explicit PlanarEmbedding(const ompl::base::StateSpace *space);

    /// x and y of a state; of a cell its centre.
    Point position(const ompl::base::State *state) const;

    /// Yaw of a state in radians; 0 where states have none.
    double heading(const ompl::base::State *state) const;

    /// Sets x and y of a state, and its yaw (radians, mathematical; any multiple of a turn) where the space has one.
    /// Cells: the one that the point lies in, so the state's position is up to pitch / sqrt(3) from it. A point outside
    /// the lattice, or what is no number, gives a cell outside, which is out of the space's bounds.
    void place(ompl::base::State *state, const Point &position, double heading = 0.0) const;

    /// True if states have a yaw.
    bool hasHeading() const { return hasHeading_; }

    /// The bounds of x and y; of cells the box that they fill.
    Box bounds() const;

    /// What the space's distance charges for a unit of length in the plane: 1 for R^2 and cells, the weight of the
    /// first subspace for SE(2).
    double lengthWeight() const;

    /// The lattice whose cells are the states; nullptr unless the space is a HexStateSpace. The space's own.
    const HexLattice *lattice() const { return lattice_; }

private:
    const ompl::base::StateSpace *space_;
    bool hasHeading_;
    const HexLattice *lattice_ = nullptr;
};

}  // namespace seahex
