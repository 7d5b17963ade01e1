#pragma once

#include <seahex/geometry/Lattice.h>
#include <seahex/planning/PlanarEmbedding.h>

#include <ompl/base/OptimizationObjective.h>

namespace seahex
{

/// Path length in steps of the lattice: D of [Cheng2020] eq. 4 for jumps between centres, the octile distance on
/// squares, extended to all segments as the norms that they are (latticeNorm). Its motion cost, less a billionth for
/// rounding, is its own heuristic.
class LatticeLengthObjective : public ompl::base::OptimizationObjective
{
public:
    /// @throws ompl::Exception if the space is not planar (PlanarEmbedding)
    LatticeLengthObjective(const ompl::base::SpaceInformationPtr &si, const Lattice &lattice);

    /// Identity: only motions cost.
    ompl::base::Cost stateCost(const ompl::base::State *state) const override;
    ompl::base::Cost motionCost(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::Cost motionCostHeuristic(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr &problem,
                                                             unsigned int maxNumberCalls) const override;

    const Lattice &lattice() const { return lattice_; }

private:
    PlanarEmbedding embedding_;
    Lattice lattice_;
};

}  // namespace seahex
