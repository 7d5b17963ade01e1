#pragma once

#include <seahex/geometry/CellLayout.h>
#include <seahex/geometry/Point.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace seahex
{

/// What a jump needs in order to be valid.
enum class JumpRule
{
    /// Every cell that its straight segment touches is free. On squares this forbids cutting corners: a diagonal step
    /// touches the two cells beside it in their common corner.
    Safe,
    /// Its last cell is free, whatever lies between. A path of such jumps may pass over land: for the reproduction of
    /// published figures, never for a vessel. On squares: diagonal steps cut corners.
    Hopping
};

/// "safe", "hopping".
const char *toString(JumpRule rule);

/// One jump as index arithmetic, for cells of one row parity.
struct Jump
{
    std::int32_t delta;        ///< index of the successor minus index of the cell
    std::uint16_t firstTouch;  ///< range in Jumps::touched(): the cells that must be free, the successor included, the
    std::uint16_t endTouch;    ///< cell itself not, as index differences
};

/// The jumps that a search may make on one layout, worked out once: for each row parity and each jump the index offset
/// of the successor and of every cell that must be free. See HexJumps and SquareJumps for which there are.
class Jumps
{
public:
    std::size_t size() const { return lengths_.size(); }
    /// How many rings the jumps reach; 1 on squares.
    int rings() const { return rings_.empty() ? 0 : rings_.back(); }
    /// How many of the jumps lie within the first rings; these come first.
    std::size_t countWithin(int rings) const;

    /// Where a jump leads, in pitches (x east, y north).
    const Point &vector(std::size_t jump) const { return vectors_[jump]; }
    /// Its Euclidean length in pitches.
    double length(std::size_t jump) const { return lengths_[jump]; }
    /// Its length in the lattice's own metric (latticeNorm).
    double steps(std::size_t jump) const { return steps_[jump]; }
    /// The jump that leads back.
    std::size_t opposite(std::size_t jump) const { return opposites_[jump]; }

    int parity(CellIndex cell) const { return static_cast<int>((cell / stride_ + CellLayout::frame) & 1); }
    /// The jumps from cells of a row parity (0 even, 1 odd).
    const std::vector<Jump> &from(int parity) const { return jumps_[static_cast<std::size_t>(parity)]; }
    const std::int32_t *touched() const { return touched_.data(); }

    /// The cell to which `jump` leads from `from`.
    CellIndex successor(CellIndex from, std::size_t jump) const
    {
        return static_cast<CellIndex>(static_cast<std::int64_t>(from) + this->from(parity(from))[jump].delta);
    }
    /// The cell from which `jump` leads to `to`.
    CellIndex predecessor(CellIndex to, std::size_t jump) const
    {
        const int fromParity = parity(to) ^ static_cast<int>(changesParity_[jump]);
        return static_cast<CellIndex>(static_cast<std::int64_t>(to) - from(fromParity)[jump].delta);
    }

protected:
    explicit Jumps(const CellLayout &layout) : stride_(static_cast<CellIndex>(layout.stride())) {}
    // copied by those who know which they are
    Jumps(const Jumps &) = default;
    Jumps &operator=(const Jumps &) = default;

    /// Adds a jump; those of inner rings come first.
    /// @param cells  for each row parity where it leads from (0, parity), and the cells that must be free, this
    /// included
    void add(const Point &vector, double steps, int ring, const std::array<std::vector<OffsetCoord>, 2> &cells);
    /// To be called when all jumps were added.
    void findOpposites();

private:
    CellIndex stride_;
    std::vector<Point> vectors_;
    std::vector<double> lengths_;
    std::vector<double> steps_;
    std::vector<int> rings_;
    std::vector<std::size_t> opposites_;
    std::vector<bool> changesParity_;
    std::array<std::vector<Jump>, 2> jumps_;
    std::vector<std::int32_t> touched_;
};

}  // namespace seahex
