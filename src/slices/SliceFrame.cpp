#include "seahex/slices/SliceFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace seahex
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

Eigen::Vector3d directionOf(SliceAxis axis, const Eigen::Vector3d &way)
{
    switch (axis)
    {
        case SliceAxis::X:
            return {std::copysign(1.0, way.x()), 0.0, 0.0};
        case SliceAxis::Y:
            return {0.0, std::copysign(1.0, way.y()), 0.0};
        case SliceAxis::Course:
            break;
    }
    const double length = std::hypot(way.x(), way.y());
    return {way.x() / length, way.y() / length, 0.0};
}

}  // namespace

std::optional<SliceFrame> SliceFrame::between(const Eigen::Vector3d &start, const Eigen::Vector3d &goal,
                                              const Eigen::AlignedBox3d &bounds, const SliceResolution &resolution,
                                              SliceAxis axis)
{
    const Eigen::Vector3d way = goal - start;
    const double room = axis == SliceAxis::X   ? std::abs(way.x())
                        : axis == SliceAxis::Y ? std::abs(way.y())
                                               : std::hypot(way.x(), way.y());
    if (!(room > 1e-9 * bounds.diagonal().norm()))
        return std::nullopt;
    SliceFrame frame;
    frame.resolution_ = resolution;
    frame.start_ = start;
    frame.goal_ = goal;
    frame.ahead_ = directionOf(axis, way);
    frame.aside_ = {-frame.ahead_.y(), frame.ahead_.x(), 0.0};
    frame.first_ = start.dot(frame.ahead_);
    frame.last_ = goal.dot(frame.ahead_);
    frame.span(bounds);
    return frame;
}

void SliceFrame::span(const Eigen::AlignedBox3d &bounds)
{
    bottom_ = bounds.min().z();
    top_ = bounds.max().z();
    left_ = infinity;
    right_ = -infinity;
    for (int plane = 0; plane < planes(); ++plane)
    {
        const Eigen::Vector3d foot = along(plane) * ahead_;
        double low = -infinity;
        double high = infinity;
        for (int k = 0; k < 2; ++k)
        {
            const double slope = aside_[k];
            if (slope == 0.0)
                continue;
            const double one = (bounds.min()[k] - foot[k]) / slope;
            const double other = (bounds.max()[k] - foot[k]) / slope;
            low = std::max(low, std::min(one, other));
            high = std::min(high, std::max(one, other));
        }
        if (low <= high)
        {
            left_ = std::min(left_, low);
            right_ = std::max(right_, high);
        }
    }
    if (!(left_ <= right_))  // start and goal on the very edge, and rounding
        left_ = right_ = start_.dot(aside_);
}

double SliceFrame::along(int plane) const
{
    return first_ + (last_ - first_) * plane / (planes() - 1);
}

Eigen::Vector3d SliceFrame::position(int plane, SliceCell cell) const
{
    const double offset = left_ + (right_ - left_) * cell.across / (across() - 1);
    Eigen::Vector3d p = along(plane) * ahead_ + offset * aside_;
    p.z() = bottom_ + (top_ - bottom_) * cell.level / (levels() - 1);
    return p;
}

Eigen::Vector3d SliceFrame::crossing(int plane, const Eigen::Vector3d &a, const Eigen::Vector3d &b) const
{
    const double from = a.dot(ahead_);
    const double to = b.dot(ahead_);
    return a + (along(plane) - from) / (to - from) * (b - a);
}

Eigen::Vector2d SliceFrame::gridCoordinates(const Eigen::Vector3d &p) const
{
    const auto steps = [](double distance, double step)
    {
        return step > 0.0 ? distance / step : 0.0;
    };
    return {steps(p.dot(aside_) - left_, acrossStep()), steps(p.z() - bottom_, levelStep())};
}

}  // namespace seahex
