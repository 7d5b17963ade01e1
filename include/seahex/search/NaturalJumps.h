#pragma once

#include <seahex/search/HexJumps.h>

#include <array>
#include <cstdint>
#include <vector>

namespace seahex
{

/// Which jumps a search by length has to try from a cell, given the jump that led there: all others are pruned, and
/// nothing is lost.
///
/// Let a cell x be reached from p by a jump d. A jump e from x to y is pruned if another chain of jumps leads from p to
/// y whose cells are free, and which is
/// - shorter than d and e together, or
/// - as long, and its last jump comes before e in a fixed order of all jumps.
///
/// Why this is lossless. Say that every cell whose least cost is below that of y has its least cost, and an arrival by
/// which it has that, when it is expanded (a consistent bound sees to it). Among all x and e at the end of a best
/// path to y take those with the first e. Were e pruned after x's arrival, then by a chain that is not shorter, for
/// best paths have none; but then its last jump ends a best path to y as well, and comes before e. So e is tried.
///
/// The order has two classes, in turns around the compass: in open water a jump of the later class is followed by
/// itself or by its neighbours of the earlier, and one of the earlier class by itself only.
///
/// What must be free is a mask of the window around x (HexWindow); a chain that leaves the window is not looked at.
/// What d and e themselves touch is free anyway and left out of the chain's mask. Tables depend on the number of rings
/// only; they are made once a process, in milliseconds, and shared.
class NaturalJumps
{
public:
    /// In the place of an arrival where a path begins: nothing is pruned.
    static constexpr std::uint8_t start = 31;

    /// A jump that may have to be tried.
    struct Choice
    {
        static constexpr std::size_t chains = 3;

        std::uint64_t touched;                      ///< must be free for the jump
        std::array<std::uint64_t, chains> instead;  ///< if any of these is free, the jump is pruned
        std::uint32_t jump;
    };

    /// All about cells of one row parity that were reached by one jump.
    struct Arrival
    {
        std::uint64_t decisive;  ///< if all these are free, only `open` need be tried
        std::uint32_t open;      ///< bit k: jump k
        std::uint32_t firstChoice;
        std::uint32_t endChoice;
    };

    /// @param rings  1, 2 or 3
    static const NaturalJumps &ofRings(int rings);

    const Arrival &arrival(unsigned int parity, std::uint8_t arrivedBy) const
    {
        return arrivals_[32 * parity + arrivedBy];
    }

    /// The jumps to be tried, bit k for jump k of HexJumps (primitive).
    /// @param blocked  the window around the cell
    std::uint32_t toTry(const Arrival &arrival, std::uint64_t blocked) const
    {
        if ((blocked & arrival.decisive) == 0)
            return arrival.open;
        std::uint32_t jumps = 0;
        for (std::uint32_t k = arrival.firstChoice; k < arrival.endChoice; ++k)
        {
            const Choice &choice = choices_[k];
            const bool isTried = (blocked & choice.touched) == 0 && (blocked & choice.instead[0]) != 0 &&
                                 (blocked & choice.instead[1]) != 0 && (blocked & choice.instead[2]) != 0;
            jumps |= static_cast<std::uint32_t>(isTried) << choice.jump;
        }
        return jumps;
    }

private:
    explicit NaturalJumps(int rings);

    std::array<Arrival, 64> arrivals_;
    std::vector<Choice> choices_;
};

}  // namespace seahex
