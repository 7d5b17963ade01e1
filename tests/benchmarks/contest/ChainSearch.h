#pragma once

#include "contest/Contender.h"

#include <seahex/search/LengthSearch.h>

namespace seahex::contest
{

/// The library's search for shortest chains of jumps, LengthSearch; one for all queries.
class ChainSearch : public Contender
{
public:
    ChainSearch(const HexOccupancy &occupancy, int rings) : search_(occupancy, rings) {}

    Answer solve(const Query &query) override;

private:
    LengthSearch search_;
};

}  // namespace seahex::contest
