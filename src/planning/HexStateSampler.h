#pragma once

#include "seahex/planning/HexStateSpace.h"

#include <ompl/base/StateSampler.h>

#include <cstdint>

namespace seahex
{

/// The sampler of HexStateSpace, where its distributions are described.
class HexStateSampler : public ompl::base::StateSampler
{
public:
    /// Does not own the space, which must outlive the sampler.
    explicit HexStateSampler(const HexStateSpace *space);

    void sampleUniform(ompl::base::State *state) override;
    void sampleUniformNear(ompl::base::State *state, const ompl::base::State *near, double distance) override;
    void sampleGaussian(ompl::base::State *state, const ompl::base::State *mean, double stdDev) override;

private:
    /// One of first ... last.
    std::int64_t integer(std::int64_t first, std::int64_t last);

    const HexStateSpace &hexagons_;
};

}  // namespace seahex
