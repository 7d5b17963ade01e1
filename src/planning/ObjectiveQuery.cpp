#include "planning/MakeGraphQuery.h"
#include "planning/ObjectiveWeight.h"

namespace seahex
{

std::unique_ptr<LatticeQuery> makeObjectiveQuery(std::unique_ptr<QueryParts> parts)
{
    return makeGraphQuery<ObjectiveWeight>(std::move(parts),
                                           [](const QueryParts &p)
                                           {
                                               const LatticeQuestion &q = p.question;
                                               return ObjectiveWeight(q.si, *q.objective, p.embedding, q.lattice,
                                                                      p.layout, p.jumps, q.guidance, p.firstStart(),
                                                                      p.firstGoal());
                                           });
}

}  // namespace seahex
