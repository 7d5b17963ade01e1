#include "seahex/slices/ExactSelection.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace seahex
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

ExactSelection::ExactSelection(const SliceProblem &problem) : SliceSearch(problem)
{
    for (int across = 0; across < frame().across(); ++across)
        for (int level = 0; level < frame().levels(); ++level)
        {
            const Eigen::Vector3d step(frame().spacing(), across * frame().acrossStep(), level * frame().levelStep());
            gridLegCosts_.push_back(problem.legCost(step.norm()));
        }
    const std::size_t points = point(frame().planes(), 0);
    toCome_.assign(points, infinity);
    isReached_.assign(points, false);
    soFar_.assign(points, infinity);
    parents_.assign(points, points);
    toCome_[point(lastPlane(), 0)] = 0.0;
    looked_ = point(lastPlane(), 0);
}

Eigen::Vector3d ExactSelection::positionOf(std::size_t point) const
{
    const int plane = planeOf(point);
    return plane == 0             ? frame().start()
           : plane == lastPlane() ? frame().goal()
                                  : frame().position(plane, cellOf(point));
}

double ExactSelection::legCost(std::size_t from, std::size_t to) const
{
    if (planeOf(from) == 0 || planeOf(to) == lastPlane())
        return problem().legCost((positionOf(to) - positionOf(from)).norm());
    const SliceCell a = cellOf(from);
    const SliceCell b = cellOf(to);
    return gridLegCosts_[frame().index({std::abs(a.across - b.across), std::abs(a.level - b.level)})];
}

double ExactSelection::leastToCome(int plane, std::size_t index) const
{
    const double own = problem().pointCost(plane, index);
    if (plane + 1 == lastPlane())
        return own + legCost(point(plane, index), point(lastPlane(), 0));
    const SliceCell from = frame().cell(index);
    double least = infinity;
    std::size_t to = point(plane + 1, 0);
    for (int across = 0; across < frame().across(); ++across)
        for (int level = 0; level < frame().levels(); ++level)
        {
            const SliceCell apart = {std::abs(across - from.across), std::abs(level - from.level)};
            least = std::min(least, gridLegCosts_[frame().index(apart)] + toCome_[to++]);
        }
    return own + least;
}

int ExactSelection::firstClosedPlane() const
{
    const auto isClosed = [&](int plane)
    {
        for (std::size_t index = 0; index < frame().cellCount(); ++index)
            if (problem().isOpen(plane, index))
                return false;
        return true;
    };
    int plane = 1;
    while (plane < lastPlane() && !isClosed(plane))
        ++plane;
    return plane;
}

bool ExactSelection::lookBack(LegJudge &judge)
{
    const std::size_t pointsBetweenLooks = std::max<std::size_t>(1, 10000 / frame().cellCount());
    while (looked_ > point(1, 0))
    {
        if (looked_ % pointsBetweenLooks == 0 && judge.isOver())
            return false;
        --looked_;
        const std::size_t index = looked_ % frame().cellCount();
        if (problem().isOpen(planeOf(looked_), index))
            toCome_[looked_] = leastToCome(planeOf(looked_), index);
    }
    return true;
}

void ExactSelection::reach(std::size_t point, double soFar)
{
    isReached_[point] = true;
    soFar_[point] = soFar;
    farthest_ = std::max(farthest_, planeOf(point));
    offerNextLeg({-infinity, point, 0});
}

/// Offers the best leg from the same point that comes after the last one. Found anew each time: kept in order, the legs
/// of all points would take the square of a plane's points of memory.
void ExactSelection::offerNextLeg(const Leg &last)
{
    const int plane = planeOf(last.from) + 1;
    const std::size_t points = plane == lastPlane() ? 1 : frame().cellCount();
    Leg best{infinity, last.from, 0};
    for (std::size_t index = 0; index < points; ++index)
    {
        const std::size_t to = point(plane, index);
        if (isReached_[to] || toCome_[to] == infinity)
            continue;
        const Leg leg{soFar_[last.from] + legCost(last.from, to) + toCome_[to], last.from, to};
        if (leg > last && best > leg)
            best = leg;
    }
    if (best.total < infinity)
        legs_.push(best);
}

SliceSearch::Step ExactSelection::work(LegJudge &judge)
{
    if (isDone_)
        return Step::Done;
    if (const int closed = firstClosedPlane(); closed < lastPlane())
    {
        farthest_ = closed - 1;
        return Step::Done;
    }
    if (!lookBack(judge))
        return Step::Interrupted;
    if (!isReached_[0])
        reach(0, 0.0);
    while (!legs_.empty())
    {
        if (judge.isOver())
            return Step::Interrupted;
        const Leg leg = legs_.top();
        const LegJudge::Answer answer =
            isReached_[leg.to] ? LegJudge::Answer::Invalid : judge.judge(positionOf(leg.from), positionOf(leg.to));
        if (answer == LegJudge::Answer::Interrupted)
            return Step::Interrupted;
        legs_.pop();
        if (answer == LegJudge::Answer::Valid && planeOf(leg.to) == lastPlane())
        {
            farthest_ = lastPlane();
            isDone_ = true;
            best_ = pathTo(leg.from);
            return Step::Better;
        }
        if (answer == LegJudge::Answer::Valid)
        {
            parents_[leg.to] = leg.from;
            const double ownCost = problem().pointCost(planeOf(leg.to), leg.to % frame().cellCount());
            reach(leg.to, soFar_[leg.from] + legCost(leg.from, leg.to) + ownCost);
        }
        offerNextLeg(leg);
    }
    isDone_ = true;
    return Step::Done;
}

SlicePath ExactSelection::pathTo(std::size_t point) const
{
    SlicePath path;
    for (; planeOf(point) > 0; point = parents_[point])
        path.push_back(cellOf(point));
    std::reverse(path.begin(), path.end());
    return path;
}

}  // namespace seahex
