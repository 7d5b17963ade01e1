#pragma once

#include "planning/SpaceJudge.h"
#include "seahex/planning/SlicePlanner.h"
#include "seahex/slices/BackwardDropping.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace seahex
{

/// How slices are laid and what is made of them.
struct SliceTerms
{
    SliceResolution resolution;
    SliceAxis axis = SliceAxis::Course;
    SliceCriterion criterion;
    bool inflate = true;
    bool optimise = true;
};

/// A start and a goal, both valid; the states are the planner's.
struct SliceEnds
{
    std::size_t startNumber;
    std::size_t goalNumber;
    const ompl::base::State *start;
    const ompl::base::State *goal;
};

/// The work for one pair of start and goal: lay the slices, search them, drop what can be skipped. It may be
/// interrupted at any question.
class SliceQuery
{
public:
    using MakeSearch = std::function<std::unique_ptr<SliceSearch>(const SliceProblem &)>;

    enum class Step
    {
        Path,        ///< path() is new
        Done,        ///< there will be none
        Interrupted  ///< no time: work() again continues
    };

    SliceQuery(const SliceEnds &ends, const Eigen::AlignedBox3d &bounds, const SliceTerms &terms,
               MakeSearch makeSearch);

    Step work(SpaceJudge &judge);
    /// No more work is wanted; lets go of slices and search.
    void finish();
    bool isDone() const { return stage_ == Stage::Done; }

    const SliceEnds &ends() const { return ends_; }
    /// Start, points, goal.
    const std::vector<Eigen::Vector3d> &path() const { return path_; }
    /// What was chosen for the path; empty for a straight motion where there are no slices.
    const std::optional<SliceSelection> &selection() const { return selection_; }
    /// Where the search ended that found no path.
    const std::optional<SliceDeadEnd> &deadEnd() const { return deadEnd_; }

private:
    enum class Stage
    {
        Laying,
        Searching,
        Dropping,
        Straight,
        Done
    };

    bool lay(SpaceJudge &judge);
    Step search(SpaceJudge &judge);
    Step drop(SpaceJudge &judge);
    Step goStraight(SpaceJudge &judge);

    SliceEnds ends_;
    SliceTerms terms_;
    MakeSearch makeSearch_;
    std::optional<SliceFrame> frame_;
    Stage stage_;

    std::unique_ptr<SliceStack> stack_;  // while it is laid
    std::size_t laid_ = 0;               // points of all planes
    std::unique_ptr<SliceProblem> problem_;
    std::unique_ptr<SliceSearch> search_;
    std::unique_ptr<BackwardDropping> dropping_;

    std::vector<Eigen::Vector3d> path_;
    std::optional<SliceSelection> selection_;
    std::optional<SliceDeadEnd> deadEnd_;
};

}  // namespace seahex
