#pragma once

#include <seahex/geometry/HexLattice.h>

#include <ompl/base/StateSpace.h>

#include <cstdint>
#include <iosfwd>
#include <vector>

namespace seahex
{

/// The cells of a finite lattice as a discrete state space: a state is a cell, and stands at the cell's centre.
///
/// **Metric.** The distance of two states is the Euclidean one of their centres, in the plane's unit. A motion is the
/// straight line between two centres, not a chain of neighbours. (For steps between neighbours as a cost see
/// LatticeLengthObjective.) To the last digits, the distance is a 2^-30th less and then rounded up to a multiple of a
/// power of two, 2^-32 to 2^-33 pitches. So distances add without rounding, up to sums of 2^20 pitches, and the
/// triangle inequality holds exactly. On a lattice many states lie on one line, and where rounding makes such a line
/// longer than its parts, or puts its cells beside it, BIT* loses its tree or never samples them.
///
/// **Interpolation** gives the cell whose centre is nearest to the point of that line, computed in integers: without
/// rounding, the same from both ends, and within the bounds if both ends are. Of centres equally near it is one of the
/// lattice's, then the smallest cell (HexCoord's order).
///
/// **What does not hold**, because states can't lie between centres:
/// - interpolate(a, b, t) is not t distance(a, b) away from a but up to pitch / sqrt(3) off the line's point; the
///   distances to both ends may add up to more than distance(a, b), and going on from there (t = 0.5, then again 0.5 of
///   the rest) is not the same as 0.75 of the whole. OMPL's sanity checks leave that out for discrete spaces
///   (STATESPACE_INTERPOLATION, STATESPACE_TRIANGLE_INEQUALITY).
/// - The line from a to an interpolated cell is no part of the line from a to b: the halves of a valid motion may be
///   invalid. After what splits motions, such as PathSimplifier::shortcutPath(), PDST, or RRTConnect with intermediate
///   states, check the path again. PRM and PRM* go on unchecked from the last valid state of an invalid motion, so a
///   motion validator has to name one with a valid motion to it: OccupancyMotionValidator does, OMPL's
///   DiscreteMotionValidator does not.
/// - Samples repeat. Where cells are few, the k nearest states are soon copies of one; RRT* and BIT* do better there
///   with all states within a radius (setKNearest(false), setUseKNearest(false)).
/// - States hold no doubles: getValueAddressAtIndex() is nullptr, and ScopedState's operator[] throws. Set a cell with
///   StateType::setCell(), a position with copyFromReals() or PlanarEmbedding::place().
/// - A motion is looked at once a step of the lattice; setLongestValidSegmentFraction() does not change that,
///   setValidSegmentCountFactor() does.
///
/// **Type.** getType() is STATE_SPACE_UNKNOWN on purpose: OMPL's informed sampler for path length, behind InformedRRT*,
/// BIT* and their kin, then works through copyToReals() and copyFromReals(), as on R^2 (and says so in a warning). Any
/// type of its own it refuses with an exception.
///
/// Const functions may be called by several threads. Cells may have coordinates up to 2^60 in size.
class HexStateSpace : public ompl::base::StateSpace
{
public:
    /// A cell, by default the north-western one.
    class StateType : public ompl::base::State
    {
    public:
        HexCoord cell() const { return cell_; }
        void setCell(HexCoord cell) { cell_ = cell; }

    private:
        HexCoord cell_;
    };

    /// @throws ompl::Exception if coordinates of the lattice exceed 2^40 pitches: centres would be told apart no more
    explicit HexStateSpace(const HexLattice &lattice);

    const HexLattice &lattice() const { return lattice_; }

    bool isDiscrete() const override { return true; }
    /// 2.
    unsigned int getDimension() const override { return 2; }
    /// The distance of the two cells farthest apart; one step if there is one cell only, since OMPL refuses 0.
    double getMaximumExtent() const override { return extent_; }
    /// Number of cells times the area of one.
    double getMeasure() const override;

    /// Clamps row and column, each by itself.
    void enforceBounds(ompl::base::State *state) const override;
    /// True if the cell belongs to the lattice.
    bool satisfiesBounds(const ompl::base::State *state) const override;

    void copyState(ompl::base::State *destination, const ompl::base::State *source) const override;
    bool equalStates(const ompl::base::State *state1, const ompl::base::State *state2) const override;
    double distance(const ompl::base::State *state1, const ompl::base::State *state2) const override;

    /// See above; `from` for t <= 0, `to` for t >= 1. The states may be one and the same.
    void interpolate(const ompl::base::State *from, const ompl::base::State *to, double t,
                     ompl::base::State *state) const override;

    /// Steps between neighbours from one cell to the other, times the factor; at least 1, because OMPL's
    /// DiscreteMotionValidator divides by it, and at most what an int holds.
    unsigned int validSegmentCount(const ompl::base::State *state1, const ompl::base::State *state2) const override;

    /// All samples are cells of the lattice. Uniform: each of them equally likely. Near: each of those whose distance
    /// is at most the one given equally likely. Gaussian: the cell of a point about the mean's centre with this
    /// standard deviation in x and in y; what falls outside comes back by enforceBounds(), as in OMPL's R^n. A state to
    /// sample about that is out of bounds is brought back first.
    ompl::base::StateSamplerPtr allocDefaultStateSampler() const override;

    ompl::base::State *allocState() const override;
    void freeState(ompl::base::State *state) const override;

    unsigned int getSerializationLength() const override;
    void serialize(void *serialization, const ompl::base::State *state) const override;
    void deserialize(ompl::base::State *state, const void *serialization) const override;
    /// Also tells lattices of different size, pitch or origin apart, so that stored states of one are refused by
    /// another.
    void computeSignature(std::vector<int> &signature) const override;

    /// x and y of the cell's centre.
    void copyToReals(std::vector<double> &reals, const ompl::base::State *source) const override;
    /// The cell that x and y lie in, of the lattice or not. Gives back exactly the cell that copyToReals() was asked
    /// for.
    /// @throws ompl::Exception if there are not two reals
    void copyFromReals(ompl::base::State *destination, const std::vector<double> &reals) const override;

    /// The default projection is the centre, on a grid of a 20th of the bounds, but not finer than the lattice.
    void registerProjections() override;

    void printState(const ompl::base::State *state, std::ostream &out) const override;
    void printSettings(std::ostream &out) const override;

    using ompl::base::StateSpace::sanityChecks;
    /// OMPL's checks, as far as a discrete space can promise them.
    void sanityChecks() const override;

private:
    double norm(HexCoord difference) const;

    HexLattice lattice_;
    double unit_;  // of distances, a power of two
    std::int64_t unitsPerPitch_;
    double extent_;
};

}  // namespace seahex
