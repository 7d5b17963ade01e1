#include "CellOutline.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace seahex
{

namespace
{

// A piece of the boundary, the cell on its right.
struct Edge
{
    CellCorner from;
    CellCorner to;
    OffsetCoord cell;
};

std::uint64_t key(CellCorner c)
{
    return (static_cast<std::uint64_t>(c.x) << 32) ^ static_cast<std::uint32_t>(c.y);
}

std::int64_t clampedFloor(double value, std::int64_t least, std::int64_t most)
{
    return static_cast<std::int64_t>(
        std::clamp(std::floor(value), static_cast<double>(least), static_cast<double>(most)));
}

std::vector<Edge> boundaryOf(const Lattice &lattice, const CellWindow &window,
                             const std::function<bool(OffsetCoord)> &inside)
{
    std::vector<Edge> edges;
    for (std::int64_t row = window.firstRow; row <= window.lastRow; ++row)
        for (std::int64_t column = window.firstColumn; column <= window.lastColumn; ++column)
        {
            const OffsetCoord cell{column, row};
            if (!inside(cell))
                continue;
            const CellCorners corners = cornersOf(lattice, cell);
            for (std::size_t i = 0; i < corners.size(); ++i)
            {
                const OffsetCoord neighbour = cellBeyond(lattice, cell, i);
                if (!window.contains(neighbour) || !inside(neighbour))
                    edges.push_back({corners[i], corners[(i + 1) % corners.size()], cell});
            }
        }
    return edges;
}

}  // namespace

CellWindow windowOver(const Lattice &lattice, const Box &box)
{
    const Box bounds = lattice.bounds();
    if ((box.min.array() > bounds.max.array()).any() || (box.max.array() < bounds.min.array()).any())
        return {};
    const Point &origin = lattice.northWest();
    const auto column = [&](double x, double slack)
    {
        return clampedFloor((x - origin.x()) / lattice.pitch() + slack, -1, lattice.columns());
    };
    const auto row = [&](double y, double slack)
    {
        return clampedFloor((origin.y() - y) / lattice.rowStep() + slack, -1, lattice.rows());
    };
    return {column(box.min.x(), -1.0), column(box.max.x(), 1.0), row(box.max.y(), -1.0), row(box.min.y(), 1.0)};
}

std::vector<std::vector<CellCorner>> outlineOf(const Lattice &lattice, const CellWindow &window,
                                               const std::function<bool(OffsetCoord)> &inside)
{
    const std::vector<Edge> edges = boundaryOf(lattice, window, inside);
    std::unordered_multimap<std::uint64_t, std::size_t> edgesFrom;
    edgesFrom.reserve(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
        edgesFrom.emplace(key(edges[i].from), i);

    // Where three cells meet there is one way on. Where four squares meet there may be two: the one along the same cell
    // turns right, and so never across the other.
    const auto next = [&](const Edge &edge)
    {
        const auto [first, last] = edgesFrom.equal_range(key(edge.to));
        const auto along =
            std::find_if(first, last, [&](const auto &way) { return edges[way.second].cell == edge.cell; });
        return (along != last ? along : first)->second;
    };

    std::vector<std::vector<CellCorner>> loops;
    std::vector<bool> walked(edges.size(), false);
    for (std::size_t first = 0; first < edges.size(); ++first)
    {
        if (walked[first])
            continue;
        std::vector<CellCorner> loop;
        for (std::size_t edge = first; !walked[edge]; edge = next(edges[edge]))
        {
            walked[edge] = true;
            loop.push_back(edges[edge].from);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace seahex
