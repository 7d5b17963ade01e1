#pragma once

#include "planning/SliceProgress.h"
#include "planning/SpaceJudge.h"
#include "seahex/search/PrismMoves.h"
#include "seahex/world/DiveArena.h"

#include <ompl/base/SpaceInformation.h>

#include <Eigen/Geometry>

#include <memory>

namespace seahex
{

/// On what a search on prisms works.
struct PrismGround
{
    ompl::base::SpaceInformationPtr si;
    std::shared_ptr<const DiveArena> arena;  ///< where the problem is one that may be read; else nullptr
    Eigen::AlignedBox3d bounds;              ///< of the space
    double climb;                            ///< of the vehicle, as for isClimbable()

    /// Is the straight motion valid, and none too steep?
    LegJudge::Answer judge(SpaceJudge &judge, const Point3 &from, const Point3 &to) const
    {
        if (!isClimbable(to - from, climb))
            return LegJudge::Answer::Invalid;
        if (!arena)
            return judge.judge(from, to);
        if (judge.isOver())
            return LegJudge::Answer::Interrupted;
        // the bounds are convex, so that the ends stand for the whole
        return bounds.contains(from) && bounds.contains(to) && arena->isFree(from, to) ? LegJudge::Answer::Valid
                                                                                       : LegJudge::Answer::Invalid;
    }
};

/// Questions about motions, put by work that can be done once more from its beginning: the answers given before an
/// interruption are played back, so that nothing is asked twice and the work comes further each time.
class PrismQuestions
{
public:
    /// @param answers  those of earlier times, to which the new ones are added
    PrismQuestions(const PrismGround &ground, SpaceJudge &judge, std::vector<bool> &answers)
        : ground_(ground), judge_(judge), answers_(answers)
    {
    }

    /// @return false, too, if there is no time to say
    bool isValid(const Point3 &from, const Point3 &to)
    {
        if (next_ == answers_.size())
        {
            const LegJudge::Answer answer = isOver_ ? LegJudge::Answer::Interrupted : ground_.judge(judge_, from, to);
            isOver_ = answer == LegJudge::Answer::Interrupted;
            if (isOver_)
                return false;
            answers_.push_back(answer == LegJudge::Answer::Valid);
        }
        return answers_[next_++];
    }

    /// Are answers missing?
    bool isOver() const { return isOver_; }

private:
    const PrismGround &ground_;
    SpaceJudge &judge_;
    std::vector<bool> &answers_;
    std::size_t next_ = 0;
    bool isOver_ = false;
};

}  // namespace seahex
