#pragma once

#include <seahex/geometry/HexCoord.h>

#include <vector>

namespace seahex
{

/// One of the jumps that a search may make from a cell.
struct RingOffset
{
    HexCoord offset;  ///< from the cell to its successor
    int ring;         ///< 1, 2 or 3: the hex distance D of the jump
    /// True if the jump passes no other cell's centre on its way (gcd of its coordinates is 1). A jump that is not
    /// primitive repeats shorter collinear ones.
    bool primitive;
};

/// The successors of ring expansion, [Cheng2020] eq. 11: the 3 n (n + 1) cells within `rings` steps: 6, 18, 36 for 1,
/// 2, 3. Of these 6, 12, 24 are primitive. Sorted by ring, within a ring counter-clockwise from east.
/// @throws std::domain_error if rings is not 1, 2 or 3
std::vector<RingOffset> ringOffsets(int rings);

}  // namespace seahex
