#pragma once

#include <seahex/geometry/CellLayout.h>
#include <seahex/geometry/HexCoord.h>
#include <seahex/geometry/HexRing.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace seahex
{

/// Which successors a ring expansion tries.
enum class JumpSet
{
    /// Those that pass no other centre: 6, 12, 24. The others repeat collinear steps, so nothing is lost where cost
    /// adds up along the line.
    Primitive,
    /// All 6, 18, 36, as published. Needed where a weight is charged on arrival; turn counts can differ.
    All
};

/// One jump as index arithmetic, for cells of one row parity.
struct Jump
{
    std::int32_t delta;  ///< index of the successor minus index of the cell
    std::uint16_t
        firstTouch;          ///< range in HexJumps::touched(): the cells that the jump's segment touches, the successor
    std::uint16_t endTouch;  ///< included, the cell itself not, as index differences
};

/// The jumps of a ring expansion on one layout, worked out once: for each row parity and each jump the index offset of
/// the successor and of every cell that the straight segment between the two centres touches (closed cells, exact).
///
/// A jump is no hop: it is valid only if all cells it touches are free.
class HexJumps
{
public:
    /// @param rings  1, 2 or 3
    HexJumps(const CellLayout &layout, int rings, JumpSet set);

    std::size_t size() const { return offsets_.size(); }
    /// How many of the jumps lie within the first rings; these come first.
    std::size_t countWithin(int rings) const;
    int rings() const { return rings_; }
    const RingOffset &offset(std::size_t jump) const { return offsets_[jump]; }
    /// Euclidean length of a jump in pitches: 1, root 3, root 7 for the primitive ones.
    double length(std::size_t jump) const { return lengths_[jump]; }
    /// The jump that leads back.
    std::size_t opposite(std::size_t jump) const { return opposites_[jump]; }

    int parity(CellIndex cell) const { return static_cast<int>((cell / stride_ + CellLayout::frame) & 1); }
    /// The jumps from cells of a row parity (0 even, 1 odd).
    const std::vector<Jump> &from(int parity) const { return jumps_[static_cast<std::size_t>(parity)]; }
    const std::int32_t *touched() const { return touched_.data(); }

    /// The cell from which `jump` leads to `to`.
    CellIndex predecessor(CellIndex to, std::size_t jump) const
    {
        const int fromParity = parity(to) ^ static_cast<int>(offsets_[jump].offset.s & 1);
        return static_cast<CellIndex>(static_cast<std::int64_t>(to) - from(fromParity)[jump].delta);
    }

private:
    int rings_;
    CellIndex stride_;
    std::vector<RingOffset> offsets_;
    std::vector<double> lengths_;
    std::vector<std::size_t> opposites_;
    std::array<std::vector<Jump>, 2> jumps_;
    std::vector<std::int32_t> touched_;
};

}  // namespace seahex
