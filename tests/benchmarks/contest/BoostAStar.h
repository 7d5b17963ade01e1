#pragma once

#include "contest/Contender.h"

#include <array>
#include <cstdint>
#include <vector>

namespace seahex::contest
{

/// Boost.Graph's A* on one ring of neighbours. The graph is implicit: edges are read from the occupancy as they are
/// asked for. Its property maps are arrays that are made once; after a query only what it touched is put back
/// (astar_search_no_init), so that the library is not charged for cells that it never saw.
class BoostAStar : public Contender
{
public:
    explicit BoostAStar(const HexOccupancy &occupancy);

    Answer solve(const Query &query) override;

private:
    const HexOccupancy &occupancy_;
    std::array<std::array<std::int32_t, 6>, 2> deltas_{};  // from cells of even and odd rows
    std::vector<CellIndex> predecessor_;
    std::vector<std::int32_t> distance_;
    std::vector<std::int32_t> estimate_;
    std::vector<unsigned char> colour_;
    std::vector<CellIndex> touched_;
};

}  // namespace seahex::contest
