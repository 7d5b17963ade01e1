#pragma once

#include <seahex/planning/LatticeAStar.h>

namespace seahex
{

/// A* on a lattice of squares, for problems in R^2 and SE(2): the baseline of the comparison with hexagons, and the
/// planner of [Wang2017] together with guidance "wang" and SafetyWeightObjective. See LatticeAStar for all that it
/// does; on a SquareOccupancy it reads the bits.
class SquareAStar : public LatticeAStar
{
public:
    /// @throws ompl::Exception if the space is neither R^2 nor SE(2): states of a HexStateSpace lie in hexagons
    explicit SquareAStar(const ompl::base::SpaceInformationPtr &si);

    /// 4 (those that share an edge) or 8, the default. @throws ompl::Exception otherwise
    void setNeighbours(int neighbours);
    int getNeighbours() const { return neighbours_; }

    /// May a diagonal step pass the corner of a blocked cell? Off by default: both cells beside it must be free. On is
    /// setJumps(JumpRule::Hopping): the path then touches blocked cells.
    void setCornerCutting(bool isAllowed) { setJumps(isAllowed ? JumpRule::Hopping : JumpRule::Safe); }
    bool getCornerCutting() const { return jumpRule() == JumpRule::Hopping; }

protected:
    bool isOwn(const Lattice &lattice) const override;
    Lattice layLattice(const PlanarEmbedding &embedding, double requestedCellSize) const override;
    JumpChoice jumpChoice() const override;

private:
    int neighbours_ = 8;
};

}  // namespace seahex
