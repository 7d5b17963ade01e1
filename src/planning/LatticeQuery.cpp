#include "planning/LatticeQuery.h"

#include "planning/QueryKinds.h"

#include <new>
#include <utility>

namespace seahex
{

std::unique_ptr<LatticeQuery> makeLatticeQuery(const LatticeQuestion &question)
{
    auto parts = std::make_unique<QueryParts>(question);
    if (parts->courses)
        try
        {
            return makeHeadingQuery(std::move(parts));
        }
        catch (const std::bad_alloc &)
        {
            // a good path is better than none
            LatticeQuestion modest = question;
            modest.knowsHeadings = false;
            return makeLatticeQuery(modest);
        }
    if (parts->safety != nullptr)
        return makeSafetyQuery(std::move(parts));
    return parts->metric ? makeLengthQuery(std::move(parts)) : makeObjectiveQuery(std::move(parts));
}

}  // namespace seahex
