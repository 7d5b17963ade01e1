#include "Tiling.h"

#include "GridCoordinates.h"

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

class Boundaries
{
public:
    explicit Boundaries(double gridUnitsPerDegree) : gridUnitsPerDegree_(gridUnitsPerDegree) {}

    void add(const std::vector<Polygon> &areas, int sign)
    {
        for (const Polygon &area : areas)
        {
            add(area.outer(), sign);
            for (const Ring &hole : area.inners())
                add(hole, -sign);
        }
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
    void add(const Ring &ring, int sign)
    {
        const int orientation = twiceSignedArea(ring, gridUnitsPerDegree_) < 0 ? -sign : sign;
        for (std::size_t i = 1; i < ring.size(); ++i)
            add(onGrid(ring[i - 1], gridUnitsPerDegree_), onGrid(ring[i], gridUnitsPerDegree_), orientation);
    }

    void add(GridPoint from, GridPoint to, int sign)
    {
        if (from.x == to.x && from.y == to.y)
            return;
        if (to.x < from.x || (to.x == from.x && to.y < from.y))
        {
            std::swap(from, to);
            sign = -sign;
        }
        const std::int64_t steps = std::gcd(to.x - from.x, to.y - from.y);
        const std::int64_t dx = (to.x - from.x) / steps;
        const std::int64_t dy = (to.y - from.y) / steps;
        const WideInteger offset = WideInteger(dx) * from.y - WideInteger(dy) * from.x;
        ends_.push_back({dx, dy, offset, dx != 0 ? from.x : from.y, sign});
        ends_.push_back({dx, dy, offset, dx != 0 ? to.x : to.y, -sign});
    }

    double gridUnitsPerDegree_;
    std::vector<RunEnd> ends_;
};

}  // namespace

bool boundariesAddUp(const std::vector<Polygon> &whole, const std::vector<Polygon> &parts, double gridUnitsPerDegree)
{
    Boundaries boundaries(gridUnitsPerDegree);
    boundaries.add(whole, 1);
    boundaries.add(parts, -1);
    return boundaries.cancel();
}

}  // namespace seahex
