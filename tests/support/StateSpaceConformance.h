#pragma once

#include "support/Random.h"

#include <ompl/base/StateSpace.h>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace seahex::test
{

using Reals = std::vector<double>;

/// What a space promises beyond what every space must keep, and what is known about it without asking it. Distances are
/// in the space's own unit, states are given by their reals.
struct SpacePromises
{
    double measure = 0.0;
    double extent = 0.0;
    std::function<double(const Reals &, const Reals &)> distance;

    /// A state within the bounds.
    std::function<Reals(Random &)> state;
    /// All states, if they are finite in number; samplers are then held to uniform distributions.
    std::vector<Reals> everyState;
    /// States out of bounds.
    std::vector<Reals> outside;

    /// How far two computations of one distance may be apart.
    double rounding = 1e-9;
    /// How far an interpolated state may be from the point of the line that is meant.
    double interpolationError = 0.0;
    /// sampleUniformNear() keeps within so many times the distance given: 1 is a ball.
    double nearReach = 1.0;
    /// A mean and a standard deviation, six times which fits into the bounds around the mean.
    std::optional<std::pair<Reals, double>> gaussian;

    /// That validSegmentCount() is multiplied by the factor.
    bool countsFactor = true;
    /// That its default projection can be asked.
    bool projects = true;
    /// The flags of StateSpace::sanityChecks() that hold.
    unsigned int sanityFlags = ~0U;
    /// Other spaces, the stored states of which are not to be taken for this one's.
    std::vector<ompl::base::StateSpacePtr> others;
};

/// How many states of a space are alive.
class StateCount
{
public:
    virtual ~StateCount() = default;
    int alive() const { return alive_; }

protected:
    mutable std::atomic<int> alive_{0};
};

/// A space that counts its states.
template <class Space>
class CountedStates : public Space, public StateCount
{
public:
    using Space::Space;

    ompl::base::State *allocState() const override
    {
        ++alive_;
        return Space::allocState();
    }

    void freeState(ompl::base::State *state) const override
    {
        --alive_;
        Space::freeState(state);
    }
};

/// Makes a new space each time, always the same one; a CountedStates, not set up.
using SpaceFactory = std::function<ompl::base::StateSpacePtr()>;

/// The contract of OMPL's state spaces, checked on pseudo-random states of the seed given. Goes beyond
/// StateSpace::sanityChecks(), which knows of no sampler but the uniform one, of no signature, projection or measure,
/// and leaves interpolation out where a space is discrete. Discrete spaces are held to exact equality, others to
/// `rounding`.
/// @return one line for each rule that the space breaks, beginning with the rule's name; none if it conforms
std::vector<std::string> conformanceFailures(const SpaceFactory &makeSpace, const SpacePromises &promises,
                                             std::uint64_t seed);

}  // namespace seahex::test
