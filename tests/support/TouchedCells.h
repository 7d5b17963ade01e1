#pragma once

#include <seahex/geometry/HexTraversal.h>
#include <seahex/geometry/SquareTraversal.h>

#include <vector>

namespace seahex::test
{

/// The cells that the segment between two centres touches, in the order of forEachTouchedCell.
template <class Cell>
std::vector<Cell> touchedCells(Cell a, Cell b)
{
    std::vector<Cell> cells;
    forEachTouchedCell(a, b,
                       [&cells](Cell cell)
                       {
                           cells.push_back(cell);
                           return true;
                       });
    return cells;
}

/// The cells that the segment between two points touches, in the order of forEachTouchedCell.
template <class LatticeType>
std::vector<typename LatticeType::Cell> touchedCells(const LatticeType &lattice, const Point &a, const Point &b)
{
    std::vector<typename LatticeType::Cell> cells;
    forEachTouchedCell(lattice, a, b,
                       [&cells](typename LatticeType::Cell cell)
                       {
                           cells.push_back(cell);
                           return true;
                       });
    return cells;
}

}  // namespace seahex::test
