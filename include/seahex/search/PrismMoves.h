#pragma once

#include <seahex/geometry/PrismLattice.h>
#include <seahex/search/HexJumps.h>

#include <cstdint>
#include <vector>

namespace seahex
{

/// May a vehicle that climbs and dives at most `climb` metres a metre of way over ground (0: without limit) go straight
/// by this vector? To a billionth, so that rounding forbids nothing.
inline bool isClimbable(const Point3 &by, double climb)
{
    return climb == 0.0 || std::abs(by.z()) <= climb * horizontal(by).norm() * (1.0 + 1e-9);
}

/// One move of a search on prisms.
struct PrismMove
{
    static constexpr std::uint8_t vertical = 255;

    std::uint8_t jump;   ///< in PrismMoves::jumps(); `vertical`: straight up or down
    std::int8_t layers;  ///< down; -1, 0 or 1
    double length;       ///< in pitches
};

/// The moves that a search on prisms may make: the jumps of a ring expansion within a layer, and those that end in the
/// layer above or below; straight up and down where the climb is not limited. None passes a node on its way: within a
/// layer only primitive jumps are made, and all of them to another layer.
class PrismMoves
{
public:
    /// @param layout  of the lattice's plane
    /// @param rings   1, 2 or 3
    /// @param climb   of the vehicle, as for isClimbable(); steeper moves are left out
    PrismMoves(const PrismLattice &lattice, const CellLayout &layout, int rings, double climb);

    const std::vector<PrismMove> &all() const { return moves_; }
    const HexJumps &jumps() const { return jumps_; }

    /// Can the vehicle change layers at all?
    bool canClimb() const { return canClimb_; }

    CellIndex successor(CellIndex from, const PrismMove &move) const
    {
        return move.jump == PrismMove::vertical ? from : jumps_.successor(from, move.jump);
    }
    CellIndex predecessor(CellIndex to, const PrismMove &move) const
    {
        return move.jump == PrismMove::vertical ? to : jumps_.predecessor(to, move.jump);
    }

    /// No chain of moves that adds up to this vector is shorter; in pitches, the vector in metres.
    ///
    /// Let H be the ring norm (vectorRingNorm) of its plane part, V its height, s the steepest slope of a move
    /// (infinite where it may go straight up), r the length of the longest jump and t the thickness of a layer. With H'
    /// = max(H, V / s) and x = min(H', V r / t) the norm is the length of the hypotenuse over x and V, and of the H' -
    /// x that are left to go in a layer.
    ///
    /// It is a norm: H and V are seminorms, the maximum of two is one, and the expression is the least of
    /// hypot(x, V) + H' - x over 0 <= x <= min(H', V r / t), convex and homogeneous in (H', V) and growing in both. And
    /// no move is shorter than its own norm: within a layer V = 0 and the length is H; to the next one V = t, the
    /// jump's length H is at least t / s and at most r, and the length is hypot(H, t); straight up it is t. By the
    /// triangle inequality no chain of moves is shorter than the norm of its sum, so that as a search's bound it is
    /// admissible and consistent. It is exact within a layer.
    double norm(const Point3 &vector) const;

private:
    HexJumps jumps_;
    std::vector<PrismMove> moves_;
    double pitch_;
    int rings_;
    bool canClimb_ = false;
    double leastRun_ = 0.0;     // 1 / s
    double greatestRun_ = 0.0;  // r / t
};

}  // namespace seahex
