#include "contest/LatticeSearch.h"

#include <seahex/search/AStar.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/LengthWeight.h>

#include <limits>

namespace seahex::contest
{

LatticeSearch::LatticeSearch(const HexOccupancy &occupancy, int rings, Guidance guidance)
    : occupancy_(&occupancy, [](const HexOccupancy *) {}), guidance_(guidance),
      jumps_(occupancy.layout(), rings, JumpSet::Primitive)
{
}

Answer LatticeSearch::solve(const Query &query)
{
    const HexLattice &lattice = occupancy_->lattice();
    LengthWeight weight(lattice, jumps_, LengthMetric::Euclidean, guidance_, lattice.centre(query.start),
                        lattice.centre(query.goal));
    weight.setOccupancy(occupancy_);
    JumpGraph<LengthWeight> graph(*occupancy_, jumps_, {{query.goal, 0.0}}, std::move(weight));
    AStar<JumpGraph<LengthWeight>> search(graph);
    search.addStart(occupancy_->layout().index(query.start), 0.0);
    search.run([] { return false; }, 500);
    const std::vector<CellIndex> path = search.path();
    return {path.empty() ? std::numeric_limits<double>::infinity() : search.cost(), search.counters().expanded,
            search.counters().generated, search.memory()};
}

}  // namespace seahex::contest
