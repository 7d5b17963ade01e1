#include "planning/LatticeQuery.h"

#include "planning/GraphQuery.h"
#include "planning/HeadingQuery.h"
#include "planning/MotionGraph.h"
#include "planning/ObjectiveWeight.h"
#include "seahex/search/JumpGraph.h"
#include "seahex/search/LengthWeight.h"
#include "seahex/search/SafetyLengthWeight.h"

#include <new>
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
        return std::make_unique<GraphQuery<JumpGraph<Weight>>>(
            std::move(parts), [&](QueryParts &p)
            { return JumpGraph<Weight>(*p.question.occupancy, p.jumps, p.goalCells(), makeWeight(p)); });
    return std::make_unique<GraphQuery<MotionGraph<Weight>>>(
        std::move(parts), [&](QueryParts &p)
        { return MotionGraph<Weight>(*p.cache, p.layout, p.jumps, p.startHeadings, p.goalCells(), makeWeight(p)); });
}

/// The weights that are known beforehand, on one kind of lattice.
template <class Norm>
std::unique_ptr<LatticeQuery> makeTabledQuery(std::unique_ptr<QueryParts> parts,
                                              const typename Norm::KnownLattice &lattice)
{
    if (parts->metric)
        return makeQuery<LatticeLengthWeight<Norm>>(
            std::move(parts),
            [&](const QueryParts &p)
            {
                LatticeLengthWeight<Norm> weight(lattice, p.jumps, *p.metric, p.question.guidance, p.firstStart(),
                                                 p.firstGoal());
                if (p.question.jumps.rule == JumpRule::Safe && p.question.goals.size() == 1)
                    weight.setOccupancy(p.question.occupancy);
                return weight;
            });
    return makeQuery<SafetyLengthWeight<Norm>>(std::move(parts),
                                               [&](const QueryParts &p) {
                                                   return SafetyLengthWeight<Norm>(lattice, p.jumps, *p.safety,
                                                                                   p.question.guidance, p.firstStart(),
                                                                                   p.firstGoal());
                                               });
}

}  // namespace

std::unique_ptr<LatticeQuery> makeLatticeQuery(const LatticeQuestion &question)
{
    auto parts = std::make_unique<QueryParts>(question);
    if (parts->courses)
        try
        {
            if (question.lattice.hexagons() != nullptr)
                return std::make_unique<HeadingQuery<HexJumpNorm>>(std::move(parts), *question.lattice.hexagons());
            return std::make_unique<HeadingQuery<SquareJumpNorm>>(std::move(parts), *question.lattice.squares());
        }
        catch (const std::bad_alloc &)
        {
            // a good path is better than none
            LatticeQuestion modest = question;
            modest.knowsHeadings = false;
            return makeLatticeQuery(modest);
        }
    if (parts->isTabled() && question.lattice.hexagons() != nullptr)
        return makeTabledQuery<HexJumpNorm>(std::move(parts), *question.lattice.hexagons());
    if (parts->isTabled())
        return makeTabledQuery<SquareJumpNorm>(std::move(parts), *question.lattice.squares());
    return makeQuery<ObjectiveWeight>(std::move(parts),
                                      [](const QueryParts &p)
                                      {
                                          return ObjectiveWeight(p.question.si, *p.question.objective, p.embedding,
                                                                 p.question.lattice, p.layout, p.jumps,
                                                                 p.question.guidance, p.firstStart(), p.firstGoal());
                                      });
}

}  // namespace seahex
