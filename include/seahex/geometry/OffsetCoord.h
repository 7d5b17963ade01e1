#pragma once

#include <cstdint>

namespace seahex
{

/// A cell of any lattice by its column and row, [Cheng2020]'s Cartesian (x, y): columns grow eastward, rows southward
/// from row 0 at the north edge.
struct OffsetCoord
{
    std::int64_t column = 0;
    std::int64_t row = 0;

    friend bool operator==(OffsetCoord a, OffsetCoord b) { return a.column == b.column && a.row == b.row; }
    friend bool operator!=(OffsetCoord a, OffsetCoord b) { return !(a == b); }
    friend bool operator<(OffsetCoord a, OffsetCoord b) { return a.row != b.row ? a.row < b.row : a.column < b.column; }
};

/// Column and row of a cell that is known by them; so code for any lattice may ask for either kind of coordinates.
inline OffsetCoord toOffset(OffsetCoord cell)
{
    return cell;
}

}  // namespace seahex
