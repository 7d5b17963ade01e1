#include "planning/SliceQuery.h"

#include <utility>

namespace seahex
{

SliceQuery::SliceQuery(const SliceEnds &ends, const Eigen::AlignedBox3d &bounds, const SliceTerms &terms,
                       MakeSearch makeSearch)
    : ends_(ends), terms_(terms), makeSearch_(std::move(makeSearch)),
      frame_(SliceFrame::between(SpaceJudge::positionOf(ends.start), SpaceJudge::positionOf(ends.goal), bounds,
                                 terms.resolution, terms.axis)),
      stage_(frame_ ? Stage::Laying : Stage::Straight)
{
}

void SliceQuery::finish()
{
    stage_ = Stage::Done;
    dropping_.reset();
    search_.reset();
    problem_.reset();
    stack_.reset();
}

SliceQuery::Step SliceQuery::work(SpaceJudge &judge)
{
    if (stage_ == Stage::Laying && !lay(judge))
        return Step::Interrupted;
    switch (stage_)
    {
        case Stage::Searching:
            return search(judge);
        case Stage::Dropping:
            return drop(judge);
        case Stage::Straight:
            return goStraight(judge);
        case Stage::Laying:
        case Stage::Done:
            break;
    }
    return Step::Done;
}

bool SliceQuery::lay(SpaceJudge &judge)
{
    if (!stack_)
        stack_ = std::make_unique<SliceStack>(*frame_);
    const std::size_t points = static_cast<std::size_t>(frame_->planes()) * frame_->cellCount();
    for (; laid_ < points; ++laid_)
    {
        const auto plane = static_cast<int>(laid_ / frame_->cellCount());
        const SliceCell cell = frame_->cell(laid_ % frame_->cellCount());
        const LegJudge::Answer answer = judge.judgePlace(frame_->position(plane, cell));
        if (answer == LegJudge::Answer::Interrupted)
            return false;
        if (answer == LegJudge::Answer::Invalid)
            stack_->block(plane, cell);
    }
    if (terms_.inflate)
        stack_->inflate();
    problem_ = std::make_unique<SliceProblem>(*stack_, terms_.criterion);
    stack_.reset();
    search_ = makeSearch_(*problem_);
    stage_ = Stage::Searching;
    return true;
}

SliceQuery::Step SliceQuery::search(SpaceJudge &judge)
{
    switch (search_->work(judge))
    {
        case SliceSearch::Step::Interrupted:
            return Step::Interrupted;
        case SliceSearch::Step::Done:
            if (!search_->best())
                deadEnd_ = {ends_.startNumber, ends_.goalNumber, search_->farthestPlane() + 1, frame_->planes()};
            finish();
            return Step::Done;
        case SliceSearch::Step::Better:
            break;
    }
    path_ = problem_->positions(*search_->best());
    const SliceFigures figures = problem_->figures(*search_->best());
    selection_ = {path_, figures, path_, figures};
    if (terms_.optimise)
    {
        dropping_ = std::make_unique<BackwardDropping>(*problem_, *search_->best());
        stage_ = Stage::Dropping;
    }
    return Step::Path;
}

SliceQuery::Step SliceQuery::drop(SpaceJudge &judge)
{
    if (!dropping_->work(judge))
        return Step::Interrupted;
    const std::vector<int> planes = dropping_->planes();
    std::vector<Eigen::Vector3d> kept;
    for (const int plane : planes)
        kept.push_back(selection_->points[static_cast<std::size_t>(plane)]);
    path_ = kept;
    selection_->kept = kept;
    selection_->keptFigures = problem_->figures(*search_->best(), planes);
    dropping_.reset();
    stage_ = Stage::Searching;
    return Step::Path;
}

SliceQuery::Step SliceQuery::goStraight(SpaceJudge &judge)
{
    const Eigen::Vector3d start = SpaceJudge::positionOf(ends_.start);
    const Eigen::Vector3d goal = SpaceJudge::positionOf(ends_.goal);
    const LegJudge::Answer answer = judge.judge(start, goal);
    if (answer == LegJudge::Answer::Interrupted)
        return Step::Interrupted;
    finish();
    if (answer == LegJudge::Answer::Invalid)
    {
        deadEnd_ = {ends_.startNumber, ends_.goalNumber, 1, 2};
        return Step::Done;
    }
    path_ = {start, goal};
    return Step::Path;
}

}  // namespace seahex
