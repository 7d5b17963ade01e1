#include "CellCorners.h"

#include <array>
#include <cmath>

namespace seahex
{

CellCorners cornersOf(const Lattice &lattice, OffsetCoord cell)
{
    if (lattice.squares() != nullptr)
    {
        const std::int64_t x = 2 * cell.column;
        const std::int64_t y = 4 * cell.row;
        return {{x, y}, {x + 2, y}, {x + 2, y + 4}, {x, y + 4}};
    }
    const std::int64_t x = 2 * cell.column + ((cell.row & 1) != 0 ? 1 : 2);
    const std::int64_t y = 3 * cell.row;
    return {{x, y}, {x + 1, y + 1}, {x + 1, y + 3}, {x, y + 4}, {x - 1, y + 3}, {x - 1, y + 1}};
}

OffsetCoord cellBeyond(const Lattice &lattice, OffsetCoord cell, std::size_t edge)
{
    static constexpr std::array<OffsetCoord, 4> beyondSquare{{{0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    static constexpr std::array<HexCoord, 6> beyondHexagon{{{1, -1}, {1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}}};
    if (lattice.squares() != nullptr)
        return {cell.column + beyondSquare[edge].column, cell.row + beyondSquare[edge].row};
    return toOffset(toCube(cell) + beyondHexagon[edge]);
}

Point toPlane(const Lattice &lattice, CellCorner corner)
{
    return {lattice.northWest().x() + 0.5 * lattice.pitch() * static_cast<double>(corner.x),
            lattice.northWest().y() - 0.5 * lattice.halfHeight() * static_cast<double>(corner.y)};
}

Point toPage(const PictureFrame &frame, const Lattice &lattice, CellCorner corner)
{
    const Point page = frame.toPage(toPlane(lattice, corner));
    return {std::round(8.0 * page.x()) / 8.0, std::round(8.0 * page.y()) / 8.0};
}

}  // namespace seahex
