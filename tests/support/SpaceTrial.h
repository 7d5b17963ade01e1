#pragma once

#include "support/ConformanceReport.h"
#include "support/StateSpaceConformance.h"

#include <sstream>

namespace seahex::test
{

/// A state that is freed with its holder.
class HeldState
{
public:
    explicit HeldState(const ompl::base::StateSpacePtr &space) : space_(space.get()), state_(space->allocState()) {}
    HeldState(const ompl::base::StateSpacePtr &space, const Reals &reals) : HeldState(space)
    {
        space_->copyFromReals(state_, reals);
    }
    HeldState(const ompl::base::StateSpacePtr &space, const ompl::base::State *other) : HeldState(space)
    {
        space_->copyState(state_, other);
    }
    HeldState(HeldState &&other) noexcept : space_(other.space_), state_(std::exchange(other.state_, nullptr)) {}
    HeldState(const HeldState &) = delete;
    HeldState &operator=(const HeldState &) = delete;
    HeldState &operator=(HeldState &&) = delete;
    ~HeldState()
    {
        if (state_ != nullptr)
            space_->freeState(state_);
    }

    ompl::base::State *get() const { return state_; }

    Reals reals() const
    {
        Reals values;
        space_->copyToReals(values, state_);
        return values;
    }

private:
    const ompl::base::StateSpace *space_;
    ompl::base::State *state_;
};

/// A space being checked, and what the checks share.
struct SpaceTrial
{
    ompl::base::StateSpacePtr space;
    const SpacePromises &promises;
    ConformanceReport &report;
    Random random;
    std::vector<HeldState> pool;  ///< states within the bounds

    /// Equal for a discrete space, else nearly so.
    bool same(const ompl::base::State *a, const ompl::base::State *b) const
    {
        return space->isDiscrete() ? space->equalStates(a, b) : space->distance(a, b) <= promises.rounding;
    }

    template <class Value>
    const Value &any(const std::vector<Value> &values)
    {
        return values[static_cast<std::size_t>(random.integer(0, static_cast<std::int64_t>(values.size()) - 1))];
    }

    std::string text(const ompl::base::State *state) const
    {
        std::ostringstream text;
        space->printState(state, text);
        std::string line = text.str();
        while (!line.empty() && line.back() == '\n')
            line.pop_back();
        return line;
    }
};

/// The rules about the three distributions of the default sampler.
void checkSamplers(SpaceTrial &trial);

}  // namespace seahex::test
