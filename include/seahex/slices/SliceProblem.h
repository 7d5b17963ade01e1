#pragma once

#include <seahex/slices/SliceStack.h>

#include <vector>

namespace seahex
{

/// What a path through slices is judged by: F = K F1 + (1 - K) F2 ([Xu] eq. 5).
struct SliceCriterion
{
    double lengthWeight = 0.5;   ///< K, from 0 to 1
    double vehicleLength = 1.0;  ///< lengths count in vehicle lengths; in the unit of the space, positive
    int neighbourhood = 3;       ///< r of [Xu] eq. 3: odd, at least 3
};

/// A path through slices by the criterion of [Xu].
struct SliceFigures
{
    double length = 0.0;  ///< F1, in vehicle lengths ([Xu] eq. 2)
    double danger = 0.0;  ///< F2, the sum of D over the points chosen ([Xu] eq. 4)
    double total = 0.0;   ///< F ([Xu] eq. 5)
};

/// A path through slices: one point of every plane but the first and the last, which have start and goal.
using SlicePath = std::vector<SliceCell>;

/// What searches over slices are about: the stack, the criterion, and the danger of each point, counted once.
///
/// Start and goal are given, not chosen: their danger is the same for every path and left out of F2.
class SliceProblem
{
public:
    SliceProblem(const SliceStack &stack, const SliceCriterion &criterion);

    const SliceStack &stack() const { return stack_; }
    const SliceFrame &frame() const { return stack_.frame(); }
    const SliceCriterion &criterion() const { return criterion_; }

    /// True if a path may use the point: it is free, and so is one of its neighbours (D < 1).
    bool isOpen(int plane, std::size_t index) const { return danger_[number(plane, index)] < 1.0; }
    /// D of an open point.
    double danger(int plane, std::size_t index) const { return danger_[number(plane, index)]; }

    /// A point's share of F.
    double pointCost(int plane, std::size_t index) const
    {
        return (1.0 - criterion_.lengthWeight) * danger(plane, index);
    }
    /// A leg's share of F, by its length in the unit of the space.
    double legCost(double length) const { return criterion_.lengthWeight * length / criterion_.vehicleLength; }

    /// Start, the path's points, goal.
    std::vector<Eigen::Vector3d> positions(const SlicePath &path) const;
    SliceFigures figures(const SlicePath &path) const;
    /// Of the straight legs between some of the path's points, named by their planes, the first and the last included.
    SliceFigures figures(const SlicePath &path, const std::vector<int> &planes) const;

private:
    std::size_t number(int plane, std::size_t index) const
    {
        return static_cast<std::size_t>(plane) * frame().cellCount() + index;
    }

    SliceStack stack_;
    SliceCriterion criterion_;
    std::vector<double> danger_;  // 1 for blocked points too
};

}  // namespace seahex
