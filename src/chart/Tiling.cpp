#include "Tiling.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace seahex
{
namespace
{

/// Where a run of a boundary along a straight line begins or ends.
struct RunEnd
{
    std::int64_t dx;  ///< the line's direction, reduced, pointing east or straight north
    std::int64_t dy;
    WideInteger offset;  ///< which of the parallel lines
    std::int64_t at;     ///< how far along it
    int change;          ///< by how much the number of runs that are under way changes

    auto key() const { return std::tie(dx, dy, offset, at); }
};

/// Compares steps along the lines on which they lie.
class Runs
{
public:
    void add(GridPoint from, GridPoint to)
    {
        int sign = 1;
        if (to.x < from.x || (to.x == from.x && to.y < from.y))
        {
            std::swap(from, to);
            sign = -1;
        }
        const std::int64_t steps = std::gcd(to.x - from.x, to.y - from.y);
        const std::int64_t dx = (to.x - from.x) / steps;
        const std::int64_t dy = (to.y - from.y) / steps;
        const WideInteger offset = WideInteger(dx) * from.y - WideInteger(dy) * from.x;
        ends_.push_back({dx, dy, offset, dx != 0 ? from.x : from.y, sign});
        ends_.push_back({dx, dy, offset, dx != 0 ? to.x : to.y, -sign});
    }

    bool cancel()
    {
        std::sort(ends_.begin(), ends_.end(), [](const RunEnd &a, const RunEnd &b) { return a.key() < b.key(); });
        for (std::size_t first = 0, next = 0; first < ends_.size(); first = next)
        {
            int change = 0;
            for (; next < ends_.size() && ends_[next].key() == ends_[first].key(); ++next)
                change += ends_[next].change;
            if (change != 0)
                return false;
        }
        return true;
    }

private:
    std::vector<RunEnd> ends_;
};

}  // namespace

void Tiling::add(const Polygon &area, int sign)
{
    addRing(area.outer(), sign);
    for (const Ring &hole : area.inners())
        addRing(hole, -sign);
}

void Tiling::addRing(const Ring &ring, int sign)
{
    ring_.clear();
    for (const Point &corner : ring)
        ring_.push_back(onGrid(corner, gridUnitsPerDegree_));
    const WideInteger twiceArea = twiceSignedArea(ring_);
    twiceAreaDifference_ += sign * (twiceArea < 0 ? -twiceArea : twiceArea);

    if ((twiceArea < 0) != (sign < 0))
        std::reverse(ring_.begin(), ring_.end());
    for (std::size_t i = 1; i < ring_.size(); ++i)
        if (ring_[i - 1].x != ring_[i].x || ring_[i - 1].y != ring_[i].y)
            steps_.add({ring_[i - 1], ring_[i]});
}

bool Tiling::boundariesAddUp() const
{
    Runs runs;
    for (const OppositeSteps::Step &step : steps_.left())
        runs.add(step.from, step.to);
    return runs.cancel();
}

}  // namespace seahex
