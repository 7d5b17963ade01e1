#include "planning/ChartSearches.h"
#include "planning/GraphQuery.h"
#include "planning/QueryKinds.h"
#include "seahex/search/LengthSearch.h"

#include <memory>
#include <utility>
#include <vector>

namespace seahex
{
namespace
{

/// What GraphQuery takes for a graph: where LengthSearch is, and where it shall go.
struct ShortestGraph
{
    explicit ShortestGraph(const QueryParts &parts)
        : own(parts.question.searches != nullptr ? nullptr
                                                 : std::make_unique<LengthSearch>(*parts.question.occupancy, 3)),
          search(own ? *own : parts.question.searches->cells()), layout(parts.layout)
    {
        search.forget();
        search.useRings(parts.question.jumps.rings);
    }

    void useRings(int rings) { search.useRings(rings); }
    void setGoals(const std::vector<GoalCell> &cells)
    {
        if (!cells.empty())
            goal = cells.front();
    }
    CellIndex predecessor(CellIndex cell, std::uint8_t jump) const { return search.jumps().predecessor(cell, jump); }

    std::unique_ptr<LengthSearch> own;
    LengthSearch &search;
    const CellLayout &layout;
    GoalCell goal{OffsetCoord{}, 0.0};
};

/// What it takes for a search.
class ShortestSearch
{
public:
    static constexpr std::uint8_t noJump = LengthSearch::noJump;

    explicit ShortestSearch(ShortestGraph &graph) : graph_(graph) {}

    void addStart(CellIndex cell, double cost)
    {
        start_ = cost;
        graph_.search.begin(graph_.layout.cell(cell), toCube(graph_.goal.cell));
    }
    void reset() {}  // addStart() does

    template <class Stop>
    SearchStatus run(Stop &&stop, std::uint64_t pollInterval)
    {
        return graph_.search.run(std::forward<Stop>(stop), pollInterval);
    }

    std::vector<CellIndex> path() const { return graph_.search.path(); }
    std::vector<CellIndex> pathTo(CellIndex cell) const { return graph_.search.pathTo(cell); }
    double leastKey() const { return start_ + graph_.search.lowerBound() + graph_.goal.finish; }
    bool isReached(CellIndex cell) const { return graph_.search.isReached(cell); }
    std::size_t openSize() const { return graph_.search.openSize(); }
    const SearchCounters &counters() const { return graph_.search.counters(); }
    void setTrace(std::vector<CellIndex> *trace) { graph_.search.setTrace(trace); }

    template <class Visit>
    void forEachReached(Visit &&visit) const
    {
        graph_.search.forEachReached(std::forward<Visit>(visit));
    }

private:
    ShortestGraph &graph_;
    double start_ = 0.0;
};

}  // namespace

std::unique_ptr<LatticeQuery> makeShortestQuery(std::unique_ptr<QueryParts> parts)
{
    return std::make_unique<GraphQuery<ShortestGraph, ShortestSearch>>(std::move(parts), [](const QueryParts &p)
                                                                       { return ShortestGraph(p); });
}

}  // namespace seahex
