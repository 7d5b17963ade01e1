#include "CellOutline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace seahex
{

namespace
{

std::uint64_t key(CellCorner c)
{
    return (static_cast<std::uint64_t>(c.x) << 32) ^ static_cast<std::uint32_t>(c.y);
}

// The neighbour beyond the edge from corner i to corner i + 1 of cornersOf: north-east first, then clockwise.
constexpr std::array<HexCoord, 6> beyondEdge{{{1, -1}, {1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}}};

std::int64_t clampedFloor(double value, std::int64_t least, std::int64_t most)
{
    return static_cast<std::int64_t>(
        std::clamp(std::floor(value), static_cast<double>(least), static_cast<double>(most)));
}

}  // namespace

CellWindow windowOver(const HexLattice &lattice, const Box &box)
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
        return clampedFloor((origin.y() - y) / (1.5 * lattice.side()) + slack, -1, lattice.rows());
    };
    return {column(box.min.x(), -1.0), column(box.max.x(), 1.0), row(box.max.y(), -1.0), row(box.min.y(), 1.0)};
}

Point toPlane(const HexLattice &lattice, CellCorner corner)
{
    return {lattice.northWest().x() + 0.5 * lattice.pitch() * static_cast<double>(corner.x),
            lattice.northWest().y() - 0.5 * lattice.side() * static_cast<double>(corner.y)};
}

std::array<CellCorner, 6> cornersOf(OffsetCoord cell)
{
    const std::int64_t x = 2 * cell.column + ((cell.row & 1) != 0 ? 1 : 2);
    const std::int64_t y = 3 * cell.row;
    return {{{x, y}, {x + 1, y + 1}, {x + 1, y + 3}, {x, y + 4}, {x - 1, y + 3}, {x - 1, y + 1}}};
}

std::vector<std::vector<CellCorner>> outlineOf(const CellWindow &window, const std::function<bool(OffsetCoord)> &inside)
{
    // Three cells meet at every corner, so a boundary passes each corner at most once: from a corner there is one way
    // on.
    std::vector<std::pair<CellCorner, CellCorner>> edges;
    std::unordered_map<std::uint64_t, std::size_t> edgeFrom;
    for (std::int64_t row = window.firstRow; row <= window.lastRow; ++row)
        for (std::int64_t column = window.firstColumn; column <= window.lastColumn; ++column)
        {
            const OffsetCoord cell{column, row};
            if (!inside(cell))
                continue;
            const std::array<CellCorner, 6> corners = cornersOf(cell);
            for (std::size_t i = 0; i < 6; ++i)
            {
                const OffsetCoord neighbour = toOffset(toCube(cell) + beyondEdge[i]);
                if (window.contains(neighbour) && inside(neighbour))
                    continue;
                edgeFrom.emplace(key(corners[i]), edges.size());
                edges.emplace_back(corners[i], corners[(i + 1) % 6]);
            }
        }

    std::vector<std::vector<CellCorner>> loops;
    std::vector<bool> walked(edges.size(), false);
    for (std::size_t first = 0; first < edges.size(); ++first)
    {
        if (walked[first])
            continue;
        std::vector<CellCorner> loop;
        for (std::size_t edge = first; !walked[edge]; edge = edgeFrom.at(key(edges[edge].second)))
        {
            walked[edge] = true;
            loop.push_back(edges[edge].first);
        }
        loops.push_back(std::move(loop));
    }
    return loops;
}

}  // namespace seahex
