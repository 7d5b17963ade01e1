#pragma once

#include "contest/Contender.h"

#include <seahex/search/Guidance.h>
#include <seahex/search/HexJumps.h>

namespace seahex::contest
{

/// The library's own general search, AStar on a JumpGraph for the Euclidean length, made anew for each query as
/// HexAStar does.
class LatticeSearch : public Contender
{
public:
    LatticeSearch(const HexOccupancy &occupancy, int rings, Guidance guidance);

    Answer solve(const Query &query) override;

private:
    std::shared_ptr<const HexOccupancy> occupancy_;  // does not own it
    Guidance guidance_;
    HexJumps jumps_;
};

}  // namespace seahex::contest
