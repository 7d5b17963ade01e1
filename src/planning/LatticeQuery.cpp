#include "planning/LatticeQuery.h"

#include "planning/QueryKinds.h"

#include <ompl/base/objectives/PathLengthOptimizationObjective.h>

#include <new>
#include <typeinfo>
#include <utility>

namespace seahex
{
bool suitsLengthSearch(const LatticeQuestion &q)
{
    const ompl::base::OptimizationObjective &objective = *q.objective;
    return q.guidance == Guidance::Automatic &&
           typeid(objective) == typeid(ompl::base::PathLengthOptimizationObjective) && q.occupancy && q.direct &&
           q.lattice.hexagons() != nullptr && q.jumps.rule == JumpRule::Safe && !q.jumps.allJumps &&
           q.starts.size() == 1 && q.goals.size() == 1 && !PlanarEmbedding(q.si->getStateSpace().get()).hasHeading();
}

std::unique_ptr<LatticeQuery> makeLatticeQuery(const LatticeQuestion &question)
{
    LatticeQuestion asked = question;
    if (question.guidance == Guidance::Automatic)
        asked.guidance = Guidance::Relaxed;
    auto parts = std::make_unique<QueryParts>(asked);
    if (suitsLengthSearch(question))
        return makeShortestQuery(std::move(parts));
    if (parts->courses)
        try
        {
            return makeHeadingQuery(std::move(parts));
        }
        catch (const std::bad_alloc &)
        {
            // a good path is better than none
            asked.knowsHeadings = false;
            return makeLatticeQuery(asked);
        }
    if (parts->safety != nullptr)
        return makeSafetyQuery(std::move(parts));
    return parts->metric ? makeLengthQuery(std::move(parts)) : makeObjectiveQuery(std::move(parts));
}

}  // namespace seahex
