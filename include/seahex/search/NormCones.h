#pragma once

#include <seahex/geometry/HexCoord.h>
#include <seahex/search/UnitLengths.h>

#include <array>
#include <cstdint>
#include <vector>

namespace seahex
{

/// How much a jump adds to the estimate of a search by length (its own length, more or less what it brings nearer to
/// the goal), looked up instead of computed.
///
/// A ring norm is linear in each of 6, 12 or 24 cones, those between neighbouring jump directions: there a jump always
/// adds the same, wherever it is made, as long as both its ends see the goal through that cone. Inside a cone, more
/// than a jump away from its sides, none leaves it.
class NormCones
{
public:
    static constexpr std::size_t mostJumps = 24;

    struct Cone
    {
        // what a difference lies inside of the two sides, as determinants with their directions
        std::int32_t q1, s1, q2, s2;
        std::array<std::uint32_t, mostJumps> added;  ///< by each jump, in units

        /// Is every jump from here made within the cone? @param q, s  from the cell to the goal
        bool holds(std::int32_t q, std::int32_t s) const
        {
            return q1 * q + s1 * s >= margin && q2 * q + s2 * s >= margin;
        }
    };

    /// @param jumps  primitive ones within the rings, in the order of HexJumps
    NormCones(int rings, const std::vector<HexCoord> &jumps);

    /// The cone that holds a difference; nullptr where it lies near a side or the goal.
    const Cone *find(std::int32_t q, std::int32_t s) const;

private:
    static constexpr std::int32_t margin = 8;  // the largest determinant of two jumps of three rings

    std::vector<Cone> cones_;
};

}  // namespace seahex
