#pragma once

#include "CellCorners.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace seahex
{

/// Columns and rows of a block of cells, all included. May reach beyond the lattice.
struct CellWindow
{
    std::int64_t firstColumn = 0;
    std::int64_t lastColumn = -1;
    std::int64_t firstRow = 0;
    std::int64_t lastRow = -1;

    std::int64_t columns() const { return lastColumn - firstColumn + 1; }
    std::int64_t rows() const { return lastRow - firstRow + 1; }
    std::int64_t cellCount() const { return columns() * rows(); }
    bool contains(OffsetCoord cell) const
    {
        return cell.column >= firstColumn && cell.column <= lastColumn && cell.row >= firstRow && cell.row <= lastRow;
    }
    /// Position of a cell of the window, row by row.
    std::size_t position(OffsetCoord cell) const
    {
        return static_cast<std::size_t>((cell.row - firstRow) * columns() + cell.column - firstColumn);
    }
};

/// The cells that touch the box, of the lattice and of one cell around it. Empty (no columns or no rows) if there are
/// none.
CellWindow windowOver(const Lattice &lattice, const Box &box);

/// The boundary of a set of cells of the window as closed loops (the first corner is not repeated), holes included.
/// `inside` is asked for cells of the window only; all others count as outside. Loops may meet at a corner but never
/// cross: squares that have only a corner in common stay apart.
std::vector<std::vector<CellCorner>> outlineOf(const Lattice &lattice, const CellWindow &window,
                                               const std::function<bool(OffsetCoord)> &inside);

}  // namespace seahex
