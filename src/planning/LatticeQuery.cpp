#include "planning/LatticeQuery.h"

#include "planning/QueryKinds.h"

#include <new>
#include <utility>

namespace seahex
{
namespace
{

bool suitsLengthSearch(const QueryParts &parts)
{
    const LatticeQuestion &q = parts.question;
    return parts.metric == LengthMetric::Euclidean && !parts.cache && q.lattice.hexagons() != nullptr &&
           q.jumps.rule == JumpRule::Safe && !q.jumps.allJumps && q.starts.size() == 1 && q.goals.size() == 1 &&
           !parts.embedding.hasHeading();
}

}  // namespace

std::unique_ptr<LatticeQuery> makeLatticeQuery(const LatticeQuestion &question)
{
    LatticeQuestion asked = question;
    const bool isAutomatic = question.guidance == Guidance::Automatic;
    if (isAutomatic)
        asked.guidance = Guidance::Relaxed;
    auto parts = std::make_unique<QueryParts>(asked);
    if (isAutomatic && suitsLengthSearch(*parts))
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
