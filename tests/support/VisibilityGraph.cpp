#include "support/VisibilityGraph.h"

#include "support/CellOracle.h"

#include <seahex/geometry/SegmentDistance.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace seahex::test
{
namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Of the pitch: what is nearer is the same place. Corners of small worlds that are not in line miss it by far more.
constexpr double tolerance = 1e-7;

/// Does the segment enter a hexagon of this width, upright, about a centre?
bool enters(const Point &a, const Point &b, const Point &centre, double width)
{
    double from = 0.0;
    double to = 1.0;
    for (int side = 0; side < 6; ++side)
    {
        const double angle = side * M_PI / 3.0;
        const Point normal(std::cos(angle), std::sin(angle));
        const double room = 0.5 * width - normal.dot(a - centre);
        const double slope = normal.dot(b - a);
        if (std::abs(slope) < 1e-15 * width)
        {
            if (room <= 0.0)
                return false;
        }
        else if (slope > 0.0)
            to = std::min(to, room / slope);
        else
            from = std::max(from, room / slope);
    }
    return from < to;
}

}  // namespace

VisibilityGraph::VisibilityGraph(const HexOccupancy &occupancy) : pitch_(occupancy.lattice().pitch())
{
    const HexLattice &lattice = occupancy.lattice();
    std::map<std::pair<long, long>, std::pair<Point, int>> meeting;
    forEachCell(lattice, 2,
                [&](HexCoord cell)
                {
                    if (occupancy.isFree(cell))
                        return;
                    centres_.push_back(lattice.centre(cell));
                    for (const Point &corner : lattice.corners(cell))
                    {
                        const Point scaled = (corner - lattice.northWest()) / (0.01 * pitch_);
                        auto &entry = meeting[{std::lround(scaled.x()), std::lround(scaled.y())}];
                        entry.first = corner;
                        ++entry.second;
                    }
                });
    const Box bounds = lattice.bounds();
    for (const auto &[key, entry] : meeting)
    {
        const Point &p = entry.first;
        // not the outer corners of the cells around the rectangle
        const bool within = p.x() > bounds.min.x() - 0.1 * pitch_ && p.x() < bounds.max.x() + 0.1 * pitch_ &&
                            p.y() > bounds.min.y() - 0.1 * pitch_ && p.y() < bounds.max.y() + 0.1 * pitch_;
        if (entry.second == 1 && within)
            corners_.push_back(p);
        else if (entry.second == 2)
            inlets_.push_back(p);
    }
    lengths_.assign(corners_.size(), std::vector<double>(corners_.size(), infinite));
    for (std::size_t i = 0; i < corners_.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (sees(corners_[i], corners_[j]))
                lengths_[i][j] = lengths_[j][i] = (corners_[i] - corners_[j]).norm();
}

bool VisibilityGraph::sees(const Point &a, const Point &b) const
{
    for (const Point &centre : centres_)
        if (enters(a, b, centre, pitch_ * (1.0 - tolerance)))
            return false;
    for (const Point &inlet : inlets_)
        if (distanceToSegment(inlet, a, b) < tolerance * pitch_ && (inlet - a).norm() > tolerance * pitch_ &&
            (inlet - b).norm() > tolerance * pitch_)
            return false;
    return true;
}

double VisibilityGraph::shortest(const Point &start, const Point &goal) const
{
    double best = sees(start, goal) ? (goal - start).norm() : infinite;
    std::vector<double> lengths(corners_.size());
    std::vector<bool> done(corners_.size(), false);
    for (std::size_t i = 0; i < corners_.size(); ++i)
        lengths[i] = sees(start, corners_[i]) ? (corners_[i] - start).norm() : infinite;
    while (true)
    {
        std::size_t next = corners_.size();
        for (std::size_t i = 0; i < corners_.size(); ++i)
            if (!done[i] && lengths[i] < best && (next == corners_.size() || lengths[i] < lengths[next]))
                next = i;
        if (next == corners_.size())
            return best;
        done[next] = true;
        if (sees(corners_[next], goal))
            best = std::min(best, lengths[next] + (goal - corners_[next]).norm());
        for (std::size_t i = 0; i < corners_.size(); ++i)
            lengths[i] = std::min(lengths[i], lengths[next] + lengths_[next][i]);
    }
}

}  // namespace seahex::test
