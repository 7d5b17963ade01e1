#include "planning/SpaceJudge.h"

#include <ompl/base/spaces/RealVectorStateSpace.h>

namespace ob = ompl::base;

namespace seahex
{

void SpaceJudge::place(ob::State *state, const Eigen::Vector3d &p)
{
    for (unsigned int k = 0; k < 3; ++k)
        state->as<ob::RealVectorStateSpace::StateType>()->values[k] = p[k];
}

Eigen::Vector3d SpaceJudge::positionOf(const ob::State *state)
{
    const double *values = state->as<ob::RealVectorStateSpace::StateType>()->values;
    return {values[0], values[1], values[2]};
}

bool SpaceJudge::mayAsk(unsigned int calls)
{
    sinceLook_ += calls;
    if (!isOver_ && sinceLook_ >= 16)
    {
        sinceLook_ = calls;
        isOver_ = condition_();
    }
    return !isOver_;
}

LegJudge::Answer SpaceJudge::judge(const Eigen::Vector3d &from, const Eigen::Vector3d &to)
{
    place(from_.get(), from);
    place(to_.get(), to);
    if (!mayAsk(si_->getStateSpace()->validSegmentCount(from_.get(), to_.get())))
        return Answer::Interrupted;
    ++progress_.legs;
    return si_->checkMotion(from_.get(), to_.get()) ? Answer::Valid : Answer::Invalid;
}

LegJudge::Answer SpaceJudge::judgePlace(const Eigen::Vector3d &place)
{
    if (!mayAsk(1))
        return Answer::Interrupted;
    ++progress_.points;
    SpaceJudge::place(to_.get(), place);
    return si_->satisfiesBounds(to_.get()) && si_->isValid(to_.get()) ? Answer::Valid : Answer::Invalid;
}

}  // namespace seahex
