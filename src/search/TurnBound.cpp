#include "seahex/search/TurnBound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace seahex
{
namespace
{

double cross(const Point &a, const Point &b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// The least area that two jumps span: cross products of sums of jumps are multiples of it.
double leastArea(const std::vector<Point> &jumps)
{
    double largest = 0.0;
    for (const Point &a : jumps)
        for (const Point &b : jumps)
            largest = std::max(largest, std::abs(cross(a, b)));
    double least = largest;
    for (const Point &a : jumps)
        for (const Point &b : jumps)
            if (const double area = std::abs(cross(a, b)); area > 1e-9 * largest)
                least = std::min(least, area);
    return least;
}

}  // namespace

TurnBound::TurnBound(std::vector<Point> jumps, std::vector<double> costs, const TurnCosts &turns)
    : jumps_(std::move(jumps)), costs_(std::move(costs)), costOf_(turns), parallel_(0.25 * leastArea(jumps_))
{
    for (const Point &a : jumps_)
        for (const Point &b : jumps_)
        {
            const bool isTurn = std::abs(cross(a, b)) > parallel_ || a.dot(b) < 0.0;
            angles_.push_back(isTurn ? std::abs(std::atan2(cross(a, b), a.dot(b))) : 0.0);
            turns_.push_back(isTurn ? turns.perTurn + turns.perRadian * angles_.back() : 0.0);
        }
    for (std::size_t k = 0; k < jumps_.size(); ++k)
        if (std::none_of(around_.begin(), around_.end(), [&](std::size_t other) { return angle(k, other) == 0.0; }))
            around_.push_back(k);
    const auto bearing = [this](std::size_t k)
    {
        const double angle = std::atan2(jumps_[k].y(), jumps_[k].x());
        return angle < -1e-9 ? angle + 2.0 * std::acos(-1.0) : angle;
    };
    std::sort(around_.begin(), around_.end(), [&](std::size_t a, std::size_t b) { return bearing(a) < bearing(b); });
}

TurnBound::Approach TurnBound::approach(const Point &difference, double norm) const
{
    Approach result;
    result.difference = difference;
    result.norm = norm;
    result.isNothing = difference.squaredNorm() <= parallel_;
    if (result.isNothing)
        return result;
    const auto side = [this](std::size_t i, const Point &p)
    {
        return cross(jumps_[around_[i]], p);
    };
    // The directions of the second half turn are opposite to those of the first.
    const std::size_t half = around_.size() / 2;
    const double first = side(0, difference);
    const bool isSecondHalf = first < -parallel_ || (first <= parallel_ && jumps_[around_[0]].dot(difference) < 0.0);
    const Point p = isSecondHalf ? Point(-difference) : difference;
    std::size_t right = 0;
    for (std::size_t end = half; end - right > 1;)
    {
        const std::size_t middle = (right + end) / 2;
        (side(middle, p) >= -parallel_ ? right : end) = middle;
    }
    const std::size_t left = side(right, p) <= parallel_ ? right : right + 1;
    const std::size_t turned = isSecondHalf ? half : 0;
    result.right = around_[(right + turned) % around_.size()];
    result.left = around_[(left + turned) % around_.size()];
    return result;
}

double TurnBound::operator()(const Approach &approach, std::size_t heading) const
{
    const double norm = approach.norm;
    if (approach.isNothing)
        return norm;
    const bool isJump = approach.right == approach.left;
    if (heading >= jumps_.size())
        return isJump ? norm : norm + turn(approach.right, approach.left);

    const Point &h = jumps_[heading];
    const double side = cross(h, approach.difference);
    if (std::abs(side) <= parallel_ && h.dot(approach.difference) > 0.0)
        return norm;
    const std::size_t far = side > 0.0 ? approach.left : approach.right;
    const double turned = costOf_.perTurn + costOf_.perRadian * angle(heading, far);
    if (isJump)
        return turned + norm;
    const Point &v = jumps_[far];
    const double area = cross(h, v);
    double once = std::numeric_limits<double>::infinity();
    // not below the norm by rounding: estimates of equal cost have equal keys (LengthAlgebra)
    if (std::abs(area) > parallel_)
        once = std::max(norm, (cross(approach.difference, v) * costs_[heading] + side * costs_[far]) / area);
    return turned + std::min(once, norm + costOf_.perTurn);
}

}  // namespace seahex
