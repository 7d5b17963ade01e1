#include "seahex/geometry/Lattice.h"

#include "seahex/geometry/HexRing.h"

namespace seahex
{

std::vector<Point> Lattice::corners(OffsetCoord cell) const
{
    return std::visit(
        [cell](const auto &lattice)
        {
            const auto corners = lattice.corners(lattice.cell(cell));
            return std::vector<Point>(corners.begin(), corners.end());
        },
        lattice_);
}

std::vector<OffsetCoord> Lattice::neighbours(OffsetCoord cell) const
{
    static const std::vector<RingOffset> ring = ringOffsets(1);
    std::vector<OffsetCoord> cells;
    if (hexagons() != nullptr)
        for (const RingOffset &neighbour : ring)
            cells.push_back(toOffset(toCube(cell) + neighbour.offset));
    else
        for (const OffsetCoord step : {OffsetCoord{1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}, {0, 1}, {1, 1}})
            cells.push_back({cell.column + step.column, cell.row + step.row});
    return cells;
}

}  // namespace seahex
