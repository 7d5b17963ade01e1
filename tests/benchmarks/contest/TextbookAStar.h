#pragma once

#include "contest/Contender.h"

#include <vector>

namespace seahex::contest
{

/// A* as textbooks have it [Hart1968]: a binary heap (std::priority_queue), costs and parents in hash maps
/// (std::unordered_map), neighbours by a table of offsets. Outdated entries of the heap are skipped, and among equal
/// estimates the deepest cell goes first, since both cost a line and help a lot.
///
/// Its heuristic is the length that remains where nothing is in the way: on one ring the distance D of hexagons, on
/// more the norm of their jumps (D overestimates there). It shares with the library the definition of the lattice, that
/// norm, and which cells a jump touches.
class TextbookAStar : public Contender
{
public:
    /// @param guided  false: Dijkstra's algorithm, whose costs owe nothing to a bound
    TextbookAStar(const HexOccupancy &occupancy, int rings, bool guided = true);

    Answer solve(const Query &query) override;

private:
    struct Neighbour
    {
        HexCoord offset;
        double length;                  // in pitches
        std::vector<HexCoord> touched;  // offsets of the cells that must be free
    };

    bool isValid(HexCoord cell, const Neighbour &neighbour) const;
    double remaining(HexCoord cell, HexCoord goal) const;

    const HexOccupancy &occupancy_;
    int rings_;
    bool guided_;
    std::vector<Neighbour> neighbours_;
};

}  // namespace seahex::contest
