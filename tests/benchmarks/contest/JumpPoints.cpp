#include "contest/JumpPoints.h"

namespace seahex::contest
{

Answer JumpPoints::solve(const Query &query)
{
    search_.begin(query.start, query.goal);
    search_.run();
    const std::vector<CellIndex> path = search_.path();
    return {path.empty() ? std::numeric_limits<double>::infinity() : search_.cost(), search_.counters().expanded,
            search_.counters().generated, search_.memory()};
}

}  // namespace seahex::contest
