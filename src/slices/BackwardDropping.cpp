#include "seahex/slices/BackwardDropping.h"

namespace seahex
{

BackwardDropping::BackwardDropping(const SliceProblem &problem, const SlicePath &path)
    : problem_(problem), points_(problem.positions(path)), kept_{problem.frame().planes() - 1}, next_(kept_.back() - 2)
{
}

bool BackwardDropping::crossesFreeCells(int from, int to) const
{
    const Eigen::Vector3d &a = points_[static_cast<std::size_t>(from)];
    const Eigen::Vector3d &b = points_[static_cast<std::size_t>(to)];
    for (int plane = from + 1; plane < to; ++plane)
        if (!problem_.stack().isFreeAt(plane, problem_.frame().crossing(plane, a, b)))
            return false;
    return true;
}

bool BackwardDropping::work(LegJudge &judge)
{
    for (; next_ >= 0; --next_)
    {
        const int base = kept_.back();
        LegJudge::Answer answer = LegJudge::Answer::Invalid;
        if (crossesFreeCells(next_, base))
            answer = judge.judge(points_[static_cast<std::size_t>(next_)], points_[static_cast<std::size_t>(base)]);
        if (answer == LegJudge::Answer::Interrupted)
            return false;
        if (answer == LegJudge::Answer::Invalid)
            kept_.push_back(next_ + 1);
    }
    return true;
}

std::vector<int> BackwardDropping::planes() const
{
    std::vector<int> planes(kept_.rbegin(), kept_.rend());
    planes.insert(planes.begin(), 0);
    return planes;
}

}  // namespace seahex
