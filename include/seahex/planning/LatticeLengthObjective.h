#pragma once

#include <seahex/geometry/HexLattice.h>
#include <seahex/planning/PlanarEmbedding.h>

#include <ompl/base/OptimizationObjective.h>

namespace seahex
{

/// Path length in steps of the lattice: D of [Cheng2020] eq. 4 for jumps between centres, extended to all segments as
/// the norm that D is (hexNorm). Its motion cost, less a billionth for rounding, is its own
/// heuristic.
class LatticeLengthObjective : public ompl::base::OptimizationObjective
{
public:
    /// @throws ompl::Exception if the space is not planar (PlanarEmbedding)
    LatticeLengthObjective(const ompl::base::SpaceInformationPtr &si, const HexLattice &lattice);

    /// Identity: only motions cost.
    ompl::base::Cost stateCost(const ompl::base::State *state) const override;
    ompl::base::Cost motionCost(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::Cost motionCostHeuristic(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr &problem,
                                                             unsigned int maxNumberCalls) const override;

    const HexLattice &lattice() const { return lattice_; }

private:
    PlanarEmbedding embedding_;
    HexLattice lattice_;
};

}  // namespace seahex
