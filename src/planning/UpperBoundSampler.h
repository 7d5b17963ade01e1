#pragma once

#include <ompl/base/samplers/informed/RejectionInfSampler.h>

namespace seahex
{

/// Informed sampling by rejection that heeds the upper bound of the cost alone. For objectives with a heuristic between
/// states and none to the goal.
///
/// BIT* asks for states whose solutions may cost at least what start and goal cost by motionCostHeuristic(), which is
/// meant to cut off nothing. But the sampler's own estimate takes the cost to go for nothing where the objective does
/// not say it, so only states farther from the start than the goal would be sampled. A heuristic to go would mend that,
/// and make a trap of its own: where the straight way is free, next to no state can better it, and OMPL's sampler tries
/// on and on without a look at the time.
class UpperBoundSampler : public ompl::base::RejectionInfSampler
{
public:
    using RejectionInfSampler::RejectionInfSampler;

    bool sampleUniform(ompl::base::State *state, const ompl::base::Cost &maxCost) override
    {
        return RejectionInfSampler::sampleUniform(state, maxCost);
    }
    bool sampleUniform(ompl::base::State *state, const ompl::base::Cost &, const ompl::base::Cost &maxCost) override
    {
        return RejectionInfSampler::sampleUniform(state, maxCost);
    }
};

}  // namespace seahex
