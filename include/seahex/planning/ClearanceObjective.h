#pragma once

#include <seahex/planning/PlanarEmbedding.h>
#include <seahex/world/ClearanceField.h>

#include <ompl/base/OptimizationObjective.h>

namespace seahex
{

/// Length, dearer where blocked cells are nearer than wanted. Unlike OMPL's MaximizeMinClearanceObjective it adds up,
/// so it knows how long a path stays near, and can be part of a sum.
///
/// A metre within a cell costs 1 + strength max(0, 1 - c / wanted), where c is the clearance of the cell's centre
/// (ClearanceField): 1 in water as open as wanted or more, and up to 1 + strength beside a blocked cell. A motion costs
/// the integral of that along its line, exact by the chords of the cells (Chords), in the plane's unit. With
/// strength 0 it is the length.
///
/// Symmetric, bit for bit. Adds up: a motion costs what its parts cost, wherever it is cut (up to rounding, and to a
/// line along an edge of cells, which is shared by the two within the traversal's tolerance).
/// Heuristic: the straight length, less a billionth for rounding, as no metre costs less than one.
/// Motions that begin or end outside the lattice, where none is valid, are charged as if in blocked cells.
/// Const, thread-safe.
class ClearanceObjective : public ompl::base::OptimizationObjective
{
public:
    /// Computes the clearances: keep the objective, not the occupancy.
    /// @param wantedClearance  in the plane's unit; >= 0. From cell centres: half a pitch is the least there is
    /// @param strength  how many times its length a metre beside a blocked cell costs on top; >= 0
    /// @throws ompl::Exception if the space is not planar (PlanarEmbedding), or a number is negative or not finite
    ClearanceObjective(const ompl::base::SpaceInformationPtr &si, const Occupancy &occupancy, double wantedClearance,
                       double strength);

    /// What a metre costs in the state's cell.
    ompl::base::Cost stateCost(const ompl::base::State *state) const override;
    ompl::base::Cost motionCost(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::Cost motionCostHeuristic(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr &problem,
                                                             unsigned int maxNumberCalls) const override;
    bool isSymmetric() const override { return true; }

    double wantedClearance() const { return wanted_; }
    double strength() const { return strength_; }
    const ClearanceField &clearances() const { return clearances_; }

private:
    double pricePerMetre(OffsetCoord cell) const;

    PlanarEmbedding embedding_;
    double wanted_;
    double strength_;
    ClearanceField clearances_;
};

}  // namespace seahex
