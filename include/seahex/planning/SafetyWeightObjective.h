#pragma once

#include <seahex/planning/PlanarEmbedding.h>
#include <seahex/world/SafetyWeights.h>

#include <ompl/base/OptimizationObjective.h>

namespace seahex
{

/// Which weight of the cells under a motion it is charged with.
enum class SafetyCharge
{
    /// [Wang2017] eq. 1 as published: the whole motion with the weight of the cell where it ends.
    OnArrival,
    /// Every cell's weight for the length of the motion within that cell.
    AlongLine
};

/// Length, dearer near blocked cells: the safety weight of [Wang2017] on squares, and its counterpart on hexagons
/// (SafetyWeights), in the plane's unit.
///
/// There are two, because the published one is made for steps between neighbours and stands alone there:
/// - **OnArrival** is eq. 1 to the letter, |p'p| w(p'), for a step, a jump over two or three rings, which is charged as
///   a whole with the weight of its last cell, and any other straight motion: what published figures stand for. It is
///   not symmetric, nor does it add up along a line: a long motion past a coast, with its end in open water, costs no
///   more than its length. So it is for steps and short jumps; planners that draw long lines, and anything that
///   straightens a path, find such motions. A roadmap with one cost for both directions (PRM*) chooses by the wrong
///   one.
/// - **AlongLine** is the integral of the weight along the line, exact by the chords of the cells (Chords). It is
///   symmetric, bit for bit, and adds up: a motion costs what its parts cost, wherever it is cut (up to rounding, and
///   to a line along an edge of cells that weigh differently, which is shared by the two within the traversal's
///   tolerance). This is the one for planners of all kinds.
///
/// For steps of one length the two differ by a constant of the path's ends alone: half a step lies in either cell, so
/// AlongLine totals OnArrival plus half a pitch times w(first) - w(last). Both have the same best paths on ring 1 of
/// hexagons and among 4 neighbours of squares; among 8 a diagonal step, being longer, tells them apart.
///
/// Heuristic: the straight length, less a billionth for rounding, as no cell weighs less than 1.
/// Motions that begin or end outside the lattice, where none is valid, are charged with the weight of blocked cells.
/// Const, thread-safe.
class SafetyWeightObjective : public ompl::base::OptimizationObjective
{
public:
    /// Computes the weights: keep the objective, not the occupancy.
    /// @throws ompl::Exception if the space is not planar (PlanarEmbedding)
    SafetyWeightObjective(const ompl::base::SpaceInformationPtr &si, const Occupancy &occupancy,
                          SafetyCharge charge = SafetyCharge::AlongLine);

    /// The weight of the state's cell.
    ompl::base::Cost stateCost(const ompl::base::State *state) const override;
    ompl::base::Cost motionCost(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::Cost motionCostHeuristic(const ompl::base::State *s1, const ompl::base::State *s2) const override;
    ompl::base::InformedSamplerPtr allocInformedStateSampler(const ompl::base::ProblemDefinitionPtr &problem,
                                                             unsigned int maxNumberCalls) const override;
    bool isSymmetric() const override { return charge_ == SafetyCharge::AlongLine; }

    SafetyCharge charge() const { return charge_; }
    const SafetyWeights &weights() const { return weights_; }

private:
    PlanarEmbedding embedding_;
    SafetyWeights weights_;
    SafetyCharge charge_;
};

}  // namespace seahex
