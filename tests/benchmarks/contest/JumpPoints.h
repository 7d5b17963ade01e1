#pragma once

#include "contest/Contender.h"

#include <seahex/search/JumpPointSearch.h>

namespace seahex::contest
{

/// The library's search for shortest chains of steps, JumpPointSearch; one for all queries.
class JumpPoints : public Contender
{
public:
    explicit JumpPoints(const HexOccupancy &occupancy) : search_(occupancy) {}

    Answer solve(const Query &query) override;

private:
    JumpPointSearch search_;
};

}  // namespace seahex::contest
