#pragma once

#include <seahex/planning/HexStateSpace.h>

#include <ompl/base/StateSampler.h>
#include <ompl/util/Exception.h>

#include <algorithm>
#include <cmath>
#include <ostream>

namespace seahex::test::defects
{

// Spaces of a lattice with one defect each: what the conformance suite has to find.

using ompl::base::State;
using ompl::base::StateSamplerPtr;

inline HexCoord cellOf(const State *state)
{
    return state->as<HexStateSpace::StateType>()->cell();
}

inline void set(State *state, HexCoord cell)
{
    state->as<HexStateSpace::StateType>()->setCell(cell);
}

struct Sound : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
};

struct CopiesNothing : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void copyState(State *, const State *) const override {}
};

struct EqualInOneRow : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    bool equalStates(const State *a, const State *b) const override { return cellOf(a).s == cellOf(b).s; }
};

struct CountsSteps : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    double distance(const State *a, const State *b) const override
    {
        return lattice().pitch() * static_cast<double>(hexDistance(cellOf(a), cellOf(b)));
    }
};

struct EastIsFarther : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    double distance(const State *a, const State *b) const override
    {
        const double distance = HexStateSpace::distance(a, b);
        return cellOf(b).q > cellOf(a).q ? distance : distance * (1.0 - 1e-12);
    }
};

struct SquaresDistances : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    double distance(const State *a, const State *b) const override
    {
        const double distance = HexStateSpace::distance(a, b);
        return distance * distance / getMaximumExtent();
    }
};

struct ExtentOfTheBounds : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    double getMaximumExtent() const override { return (lattice().bounds().max - lattice().bounds().min).norm(); }
};

struct ExtentOfOneRow : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    double getMaximumExtent() const override { return lattice().pitch() * static_cast<double>(lattice().columns()); }
};

struct MeasureInCells : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    double getMeasure() const override { return static_cast<double>(lattice().cellCount()); }
};

struct Unbounded : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    bool satisfiesBounds(const State *) const override { return true; }
};

struct EnforcesColumnsOnly : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void enforceBounds(State *state) const override
    {
        const std::int64_t row = cellOf(state).s;
        HexStateSpace::enforceBounds(state);
        set(state, toCube({toOffset(cellOf(state)).column, row}));
    }
};

struct EnforcesACorner : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void enforceBounds(State *state) const override { set(state, HexCoord{}); }
};

/// The point of the line by plain arithmetic: the two directions are rounded apart, and the bounds may be left.
struct RoundsPoints : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void interpolate(const State *from, const State *to, double t, State *state) const override
    {
        const Point a = lattice().centre(cellOf(from));
        const Point b = lattice().centre(cellOf(to));
        set(state, lattice().cellAt(a + t * (b - a)));
    }
};

struct LeavesToTheWest : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void interpolate(const State *from, const State *to, double t, State *state) const override
    {
        const Point a = lattice().centre(cellOf(from));
        const Point b = lattice().centre(cellOf(to));
        set(state, lattice().cellAt(a + t * (b - a) - Point(1e-6 * lattice().pitch(), 0.0)));
    }
};

struct NeverArrives : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void interpolate(const State *from, const State *to, double t, State *state) const override
    {
        HexStateSpace::interpolate(from, to, std::min(t, 0.75), state);
    }
};

struct JumpsHalfWay : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void interpolate(const State *from, const State *to, double t, State *state) const override
    {
        if (t == 0.5)
            return HexStateSpace::interpolate(from, to, t, state);
        set(state, t < 0.5 ? cellOf(from) : cellOf(to));
    }
};

struct WritesBeforeItReads : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void interpolate(const State *from, const State *to, double t, State *state) const override
    {
        copyState(state, from);
        HexStateSpace::interpolate(state, to, t, state);
    }
};

struct NoSegmentBetweenNeighbours : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    unsigned int validSegmentCount(const State *a, const State *b) const override
    {
        return getValidSegmentCountFactor() * static_cast<unsigned int>(hexDistance(cellOf(a), cellOf(b)) / 2);
    }
};

struct IgnoresTheFactor : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    unsigned int validSegmentCount(const State *a, const State *b) const override
    {
        return static_cast<unsigned int>(hexDistance(cellOf(a), cellOf(b)));
    }
};

struct NotSerialised : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    unsigned int getSerializationLength() const override { return 0; }
};

struct SerialisesTheRowOnly : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void deserialize(State *state, const void *bytes) const override
    {
        const HexCoord before = cellOf(state);
        HexStateSpace::deserialize(state, bytes);
        set(state, {before.q, cellOf(state).s});
    }
};

struct SerialisesTooMuch : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void serialize(void *bytes, const State *state) const override
    {
        HexStateSpace::serialize(bytes, state);
        static_cast<char *>(bytes)[getSerializationLength()] = 1;
    }
};

struct OneReal : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void copyToReals(std::vector<double> &reals, const State *state) const override
    {
        HexStateSpace::copyToReals(reals, state);
        reals.push_back(0.0);
    }
    void copyFromReals(State *state, const std::vector<double> &reals) const override
    {
        HexStateSpace::copyFromReals(state, {reals[0], reals[1]});
    }
};

struct RealsOfTheNextCell : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void copyToReals(std::vector<double> &reals, const State *state) const override
    {
        HexStateSpace::copyToReals(reals, state);
        reals[0] += lattice().pitch();
    }
};

struct SignatureOfAnyLattice : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void computeSignature(std::vector<int> &signature) const override { StateSpace::computeSignature(signature); }
};

struct SignatureWithoutLength : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void computeSignature(std::vector<int> &signature) const override
    {
        HexStateSpace::computeSignature(signature);
        signature.push_back(1);
    }
};

struct NoProjection : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void registerProjections() override {}
};

struct ProjectionForgetsTheUser : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void registerProjections() override
    {
        HexStateSpace::registerProjections();
        getDefaultProjection()->setCellSizes({1.0, 1.0});
    }
};

struct MoreWithEverySetup : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void registerProjections() override
    {
        HexStateSpace::registerProjections();
        registerProjection("projection " + std::to_string(++setups_), getDefaultProjection());
    }
    int setups_ = 0;
};

struct InsaneByItsOwnAccount : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void sanityChecks() const override { throw ompl::Exception("not sane"); }
};

struct PrintsNothing : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    void printState(const State *, std::ostream &) const override {}
};

struct OneNameForAll : HexStateSpace
{
    explicit OneNameForAll(const HexLattice &lattice) : HexStateSpace(lattice) { setName("lattice"); }
};

struct Throws : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    double getMeasure() const override { throw ompl::Exception("no measure"); }
};

/// Keeps a state for itself from the first sampler on.
struct KeepsAState : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    ~KeepsAState() override
    {
        if (kept_ != nullptr)
            HexStateSpace::freeState(kept_);
    }
    StateSamplerPtr allocDefaultStateSampler() const override
    {
        if (kept_ == nullptr)
            kept_ = allocState();
        return HexStateSpace::allocDefaultStateSampler();
    }
    mutable State *kept_ = nullptr;
};

/// A sampler that passes everything on to the sound one.
class PassingSampler : public ompl::base::StateSampler
{
public:
    explicit PassingSampler(const HexStateSpace *space)
        : StateSampler(space), sound_(space->HexStateSpace::allocDefaultStateSampler())
    {
    }
    void sampleUniform(State *state) override { sound_->sampleUniform(state); }
    void sampleUniformNear(State *state, const State *near, double distance) override
    {
        sound_->sampleUniformNear(state, near, distance);
    }
    void sampleGaussian(State *state, const State *mean, double deviation) override
    {
        sound_->sampleGaussian(state, mean, deviation);
    }

protected:
    const HexLattice &lattice() const { return space_->as<HexStateSpace>()->lattice(); }

    StateSamplerPtr sound_;
};

template <class Sampler>
struct SampledBy : HexStateSpace
{
    using HexStateSpace::HexStateSpace;
    StateSamplerPtr allocDefaultStateSampler() const override { return std::make_shared<Sampler>(this); }
};

struct NeverTheLastColumn : PassingSampler
{
    using PassingSampler::PassingSampler;
    void sampleUniform(State *state) override
    {
        do
            sound_->sampleUniform(state);
        while (toOffset(cellOf(state)).column == lattice().columns() - 1);
    }
};

struct LikesTheFirstCell : PassingSampler
{
    using PassingSampler::PassingSampler;
    void sampleUniform(State *state) override
    {
        sound_->sampleUniform(state);
        if (rng_.uniform01() < 0.1)
            set(state, HexCoord{});
    }
};

struct NearOutOfBounds : PassingSampler
{
    using PassingSampler::PassingSampler;
    void sampleUniformNear(State *state, const State *near, double distance) override
    {
        const Point p = lattice().centre(cellOf(near));
        const double angle = rng_.uniformReal(-3.2, 3.2);
        const double radius = 0.5 * distance * rng_.uniform01();
        set(state, lattice().cellAt(p + radius * Point(std::cos(angle), std::sin(angle))));
    }
};

struct NearInASquare : PassingSampler
{
    using PassingSampler::PassingSampler;
    void sampleUniformNear(State *state, const State *near, double distance) override
    {
        const Point p = lattice().centre(cellOf(near));
        const double x = rng_.uniformReal(-distance, distance);
        set(state, lattice().cellAt(p + Point(x, rng_.uniformReal(-distance, distance))));
        space_->enforceBounds(state);
    }
};

struct NearIsTheCentre : PassingSampler
{
    using PassingSampler::PassingSampler;
    void sampleUniformNear(State *state, const State *near, double distance) override
    {
        sound_->sampleUniformNear(state, near, rng_.uniform01() * distance);
    }
};

struct GaussianOutOfBounds : PassingSampler
{
    using PassingSampler::PassingSampler;
    void sampleGaussian(State *state, const State *mean, double deviation) override
    {
        const Point p = lattice().centre(cellOf(mean));
        const double x = rng_.gaussian(p.x(), deviation);
        set(state, lattice().cellAt({x, rng_.gaussian(p.y(), deviation)}));
    }
};

struct GaussianTooNarrow : PassingSampler
{
    using PassingSampler::PassingSampler;
    void sampleGaussian(State *state, const State *mean, double deviation) override
    {
        sound_->sampleGaussian(state, mean, 0.8 * deviation);
    }
};

struct GaussianDrifts : PassingSampler
{
    using PassingSampler::PassingSampler;
    void sampleGaussian(State *state, const State *mean, double deviation) override
    {
        sound_->sampleGaussian(state, mean, deviation);
        if (deviation > 0.0 && rng_.uniform01() < 0.5)
        {
            set(state, cellOf(state) + HexCoord{1, 0});
            space_->enforceBounds(state);
        }
    }
};

}  // namespace seahex::test::defects
