#include "seahex/slices/GreedySelection.h"

#include <algorithm>

namespace seahex
{

GreedySelection::GreedySelection(const SliceProblem &problem) : SliceSearch(problem), newest_(frame().start())
{
    rank();
}

void GreedySelection::rank()
{
    ranking_.clear();
    next_ = 0;
    if (plane_ == lastPlane())
    {
        ranking_.emplace_back(0.0, 0);  // the goal
        return;
    }
    const Eigen::Vector3d reference = frame().crossing(plane_, newest_, frame().goal());
    for (std::size_t index = 0; index < frame().cellCount(); ++index)
        if (problem().isOpen(plane_, index))
        {
            const Eigen::Vector3d point = frame().position(plane_, frame().cell(index));
            ranking_.emplace_back((point - newest_).norm() + (point - reference).norm(), index);
        }
    std::sort(ranking_.begin(), ranking_.end());
}

SliceSearch::Step GreedySelection::work(LegJudge &judge)
{
    while (!isDone_ && next_ < ranking_.size())
    {
        const bool isGoal = plane_ == lastPlane();
        const SliceCell cell = frame().cell(ranking_[next_].second);
        const Eigen::Vector3d point = isGoal ? frame().goal() : frame().position(plane_, cell);
        const LegJudge::Answer answer = judge.judge(newest_, point);
        if (answer == LegJudge::Answer::Interrupted)
            return Step::Interrupted;
        if (answer == LegJudge::Answer::Invalid)
        {
            ++next_;
            continue;
        }
        farthest_ = plane_;
        if (isGoal)
        {
            isDone_ = true;
            best_ = chosen_;
            return Step::Better;
        }
        chosen_.push_back(cell);
        newest_ = point;
        ++plane_;
        rank();
    }
    return Step::Done;
}

}  // namespace seahex
