#pragma once

#include <seahex/slices/SliceSearch.h>

#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace seahex
{

/// The path of least F over all that have one open point in every plane and valid legs; if it finds none, there is
/// none.
///
/// Dynamic programming from the goal back, as though all legs were valid, tells the least F that is still to come from
/// each point. With that for its estimate a best-first search from the start asks for legs in the order in which they
/// matter: only for those that may belong to a path better than the one found, and each at most once. Time of the
/// former: planes times the square of a plane's points; F is least but for rounding. Where a plane has no open
/// point, no leg is asked for, and farthestPlane() is the plane before.
class ExactSelection : public SliceSearch
{
public:
    explicit ExactSelection(const SliceProblem &problem);
    Step work(LegJudge &judge) override;

private:
    struct Leg
    {
        double total;  // F of the best path with this leg, as far as is known
        std::size_t from;
        std::size_t to;
        // of equal legs the first in the order of the grid is the better one
        friend bool operator>(const Leg &a, const Leg &b)
        {
            return std::make_pair(a.total, a.to) > std::make_pair(b.total, b.to);
        }
    };
    // Points are numbered through all planes; start and goal stand for the first points of their planes.
    std::size_t point(int plane, std::size_t index) const
    {
        return static_cast<std::size_t>(plane) * frame().cellCount() + index;
    }
    int planeOf(std::size_t point) const { return static_cast<int>(point / frame().cellCount()); }
    SliceCell cellOf(std::size_t point) const { return frame().cell(point % frame().cellCount()); }
    Eigen::Vector3d positionOf(std::size_t point) const;
    double legCost(std::size_t from, std::size_t to) const;
    double leastToCome(int plane, std::size_t index) const;
    int firstClosedPlane() const;
    bool lookBack(LegJudge &judge);
    void reach(std::size_t point, double soFar);
    void offerNextLeg(const Leg &last);
    SlicePath pathTo(std::size_t point) const;

    std::vector<double> gridLegCosts_;  // between points of neighbouring planes, by steps across and levels apart
    // Least F of an open point and all that comes after it, as though all legs were valid; infinity elsewhere.
    std::vector<double> toCome_;
    std::size_t looked_;  // points from this one on have theirs

    std::vector<bool> isReached_;
    std::vector<double> soFar_;  // least F from the start to a point that is reached, with its own share
    std::vector<std::size_t> parents_;
    // Of each point that is reached the best leg that was not judged yet, the best of all on top.
    std::priority_queue<Leg, std::vector<Leg>, std::greater<>> legs_;
    bool isDone_ = false;
};

}  // namespace seahex
