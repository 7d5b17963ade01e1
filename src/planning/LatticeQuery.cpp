#include "planning/LatticeQuery.h"

#include "planning/GraphQuery.h"
#include "planning/MotionGraph.h"
#include "planning/ObjectiveWeight.h"
#include "seahex/search/HexGraph.h"
#include "seahex/search/LengthWeight.h"

#include <utility>

namespace seahex
{
namespace
{

/// The graph of a query for one kind of weight: read from the occupancy, or asked of the problem's own checker.
template <class Weight, class MakeWeight>
std::unique_ptr<LatticeQuery> makeQuery(std::unique_ptr<QueryParts> parts, MakeWeight &&makeWeight)
{
    if (!parts->cache)
        return std::make_unique<GraphQuery<HexGraph<Weight>>>(
            std::move(parts), [&](QueryParts &p)
            { return HexGraph<Weight>(*p.question.occupancy, p.jumps, p.goalCells(), makeWeight(p)); });
    return std::make_unique<GraphQuery<MotionGraph<Weight>>>(std::move(parts),
                                                             [&](QueryParts &p)
                                                             {
                                                                 return MotionGraph<Weight>(
                                                                     *p.cache, p.question.lattice, p.layout, p.jumps,
                                                                     p.startHeadings, p.goalCells(), makeWeight(p));
                                                             });
}

}  // namespace

std::unique_ptr<LatticeQuery> makeLatticeQuery(const LatticeQuestion &question)
{
    auto parts = std::make_unique<QueryParts>(question);
    if (parts->metric)
        return makeQuery<LengthWeight>(std::move(parts),
                                       [](const QueryParts &p) {
                                           return LengthWeight(p.question.lattice, p.jumps, *p.metric,
                                                               p.question.guidance, p.firstStart(), p.firstGoal());
                                       });
    return makeQuery<ObjectiveWeight>(std::move(parts),
                                      [](const QueryParts &p)
                                      {
                                          return ObjectiveWeight(p.question.si, *p.question.objective, p.embedding,
                                                                 p.question.lattice, p.layout, p.jumps,
                                                                 p.question.guidance, p.firstStart(), p.firstGoal());
                                      });
}

}  // namespace seahex
