#pragma once

#include <seahex/geometry/OffsetCoord.h>

#include <cstdint>
#include <cstdlib>

namespace seahex
{

// The frame of every cell coordinate in this project ([Cheng2020] section 1.2).
//
// Pointy-top hexagons in rows. Row 0 is the northernmost, rows grow southward, columns grow eastward; even rows are
// shifted half a cell to the east ("even-r"):
//
//       row 0       / \ / \ / \          q grows to the east, s to the south-east, r to the north-west... and in every
//                  |0,0|1,0|2,0|         cell q + r + s = 0.
//       row 1     / \ / \ / \ /
//                |0,1|1,1|2,1|           (column, row) as the paper's (x, y)
//                 \ / \ / \ /

/// A cell, or the difference of two cells, in cube coordinates (q, r, s) with q + r + s = 0. Only q and s are stored.
struct HexCoord
{
    std::int64_t q = 0;
    std::int64_t s = 0;

    std::int64_t r() const { return -q - s; }

    friend bool operator==(HexCoord a, HexCoord b) { return a.q == b.q && a.s == b.s; }
    friend bool operator!=(HexCoord a, HexCoord b) { return !(a == b); }
    friend bool operator<(HexCoord a, HexCoord b) { return a.s != b.s ? a.s < b.s : a.q < b.q; }
    friend HexCoord operator+(HexCoord a, HexCoord b) { return {a.q + b.q, a.s + b.s}; }
    friend HexCoord operator-(HexCoord a, HexCoord b) { return {a.q - b.q, a.s - b.s}; }
    friend HexCoord operator*(std::int64_t k, HexCoord a) { return {k * a.q, k * a.s}; }
};

/// Column and row of a cell, [Cheng2020] eq. 1. (`s & 1` is 0 or 1 for negative s too.)
inline OffsetCoord toOffset(HexCoord cell)
{
    return {cell.q + (cell.s + (cell.s & 1)) / 2, cell.s};
}

/// The cell at a column and row, [Cheng2020] eq. 2.
inline HexCoord toCube(OffsetCoord offset)
{
    return {offset.column - (offset.row + (offset.row & 1)) / 2, offset.row};
}

/// Number of steps between neighbouring cells that lead from the origin to `difference`, [Cheng2020] eq. 4.
inline std::int64_t hexNorm(HexCoord difference)
{
    return (std::abs(difference.q) + std::abs(difference.r()) + std::abs(difference.s)) / 2;
}

/// D(u, v) of [Cheng2020] eq. 4.
inline std::int64_t hexDistance(HexCoord u, HexCoord v)
{
    return hexNorm(u - v);
}

}  // namespace seahex
