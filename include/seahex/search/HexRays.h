#pragma once

#include <seahex/geometry/HexCoord.h>
#include <seahex/world/Occupancy.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace seahex
{

/// How far one can go straight on over hexagons: 64 cells at a look, along three of the six directions.
///
/// The directions are every second one around the compass: east, north-west, south-west. For each there is a plane of
/// bits, in which the cells of a line in that direction lie one after the other: one bit that tells blocked cells, and
/// one that tells where a ray that passes has to stop, its *turns*. A free cell x on a ray is a turn if, on one of the
/// ray's two sides, the neighbour of x behind (120 degrees off the ray) is blocked and the neighbour of x ahead
/// (60 degrees off) is free: the ray has just passed the end of an obstacle.
///
/// Bits are addressed by one number, linear in the cell's coordinates: a step in any direction adds a constant to it.
/// Made once for an occupancy, in time and memory by its size: 6 bits a cell, times 1 + rows / (2 columns) because
/// lines lie aslant in the rectangle, lines of less than 64 cells as those of 64. Immutable afterwards, so that
/// searches of several threads may share it.
class HexRays
{
public:
    static constexpr unsigned int directions = 3;
    /// One step of each ray.
    static constexpr std::array<HexCoord, directions> steps = {HexCoord{1, 0}, HexCoord{0, -1}, HexCoord{-1, 1}};

    using Address = std::int64_t;

    /// Where a ray ends.
    struct Stop
    {
        Address distance;     ///< in cells, at least 1
        bool isTurn;          ///< else the cell is blocked
        std::uint32_t words;  ///< looked at
    };

    /// @param occupancy  of hexagons
    explicit HexRays(const Occupancy &occupancy);

    /// The address of a cell of the rectangle or next to it in the plane of a direction.
    Address address(unsigned int direction, HexCoord cell) const
    {
        const Plane &plane = planes_[direction];
        return plane.origin + delta(plane, cell);
    }
    /// What a step adds to the address.
    Address delta(unsigned int direction, HexCoord step) const { return delta(planes_[direction], step); }

    bool isBlocked(unsigned int direction, Address address) const
    {
        return (planes_[direction].words[static_cast<std::size_t>(address >> 6)].blocked >> (address & 63)) & 1;
    }

    /// The first turn or blocked cell beyond a cell.
    [[gnu::always_inline]] Stop firstStop(unsigned int direction, Address from) const
    {
        const Address first = from + 1;
        const Pair *pair = planes_[direction].words.data() + (first >> 6);
        std::uint64_t stops = (pair->blocked | pair->turns) >> (first & 63) << (first & 63);
        std::uint32_t looked = 1;
        for (; stops == 0; ++looked)
        {
            ++pair;
            stops = pair->blocked | pair->turns;
        }
        const int bit = __builtin_ctzll(stops);
        const Address at = ((first >> 6) + looked - 1) * 64 + bit;
        return {at - from, ((pair->turns >> bit) & 1) != 0, looked};
    }

    /// Memory held, in bytes.
    std::size_t bytes() const;

private:
    struct Pair
    {
        std::uint64_t blocked;
        std::uint64_t turns;
    };

    struct Plane
    {
        std::vector<Pair> words;
        Address origin = 0;  ///< address of the cell (0, 0)
        Address perQ = 0;
        Address perS = 0;
        std::int64_t lines = 0;
        std::int64_t lineWords = 0;
    };

    static Address delta(const Plane &plane, HexCoord step) { return plane.perQ * step.q + plane.perS * step.s; }

    std::array<Plane, directions> planes_;
};

}  // namespace seahex
