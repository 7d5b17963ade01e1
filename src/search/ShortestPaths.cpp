#include "seahex/search/ShortestPaths.h"

#include "seahex/search/LengthSearch.h"
#include "search/WorkTeam.h"

namespace seahex
{

std::vector<ShortestPath> shortestPaths(const Occupancy &occupancy, int rings, const std::vector<CellQuery> &queries,
                                        const BatchControl &control)
{
    std::vector<ShortestPath> answers(queries.size());
    const auto makeWorker = [&](std::function<bool()> stop)
    {
        return [&, stop = std::move(stop), search = LengthSearch(occupancy, rings)](std::size_t k) mutable
        {
            ShortestPath &answer = answers[k];
            const auto [start, goal] = queries[k];
            answer.status = SearchStatus::Exhausted;
            if (occupancy.isBlocked(toOffset(start)) || occupancy.isBlocked(toOffset(goal)))
                return true;
            search.begin(start, goal);
            answer.status = search.run(stop);
            if (answer.status == SearchStatus::Found)
            {
                answer.length = search.cost();
                answer.cells = search.path();
            }
            return answer.status != SearchStatus::Stopped;
        };
    };
    WorkTeam(control).run(queries.size(), makeWorker);
    return answers;
}

}  // namespace seahex
