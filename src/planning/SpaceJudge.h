#pragma once

#include "planning/SliceProgress.h"
#include "seahex/slices/SliceSearch.h"

#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/base/ScopedState.h>
#include <ompl/base/SpaceInformation.h>

namespace seahex
{

/// Asks a problem's own code about places and legs of R^3, and looks at the termination condition after 16 calls of it
/// at most, or before each motion where one takes more.
class SpaceJudge : public LegJudge
{
public:
    /// Looks at the condition, which must outlive the judge, for the first time.
    SpaceJudge(const ompl::base::SpaceInformationPtr &si, const ompl::base::PlannerTerminationCondition &condition,
               SliceProgress &progress)
        : si_(si), condition_(condition), progress_(progress), from_(si), to_(si), isOver_(condition())
    {
    }

    Answer judge(const Eigen::Vector3d &from, const Eigen::Vector3d &to) override;
    /// Is the place a valid state within the bounds?
    Answer judgePlace(const Eigen::Vector3d &place);
    /// Takes ten thousand additions, which come between two calls, for a few questions.
    bool isOver() override { return !mayAsk(4); }

    static void place(ompl::base::State *state, const Eigen::Vector3d &p);
    static Eigen::Vector3d positionOf(const ompl::base::State *state);

private:
    bool mayAsk(unsigned int calls);

    ompl::base::SpaceInformationPtr si_;
    const ompl::base::PlannerTerminationCondition &condition_;
    SliceProgress &progress_;
    ompl::base::ScopedState<> from_;
    ompl::base::ScopedState<> to_;
    unsigned int sinceLook_ = 0;
    bool isOver_;
};

}  // namespace seahex
