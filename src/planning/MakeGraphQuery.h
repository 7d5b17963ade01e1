#pragma once

#include "planning/GraphQuery.h"
#include "planning/MotionGraph.h"
#include "planning/QueryKinds.h"
#include "seahex/search/JumpGraph.h"

#include <memory>
#include <utility>

namespace seahex
{

/// The query of one kind of weight: read from the occupancy, or asked of the problem's own checker.
/// @param makeWeight  Weight(const QueryParts &)
template <class Weight, class MakeWeight>
std::unique_ptr<LatticeQuery> makeGraphQuery(std::unique_ptr<QueryParts> parts, MakeWeight &&makeWeight)
{
    if (!parts->cache)
        return std::make_unique<GraphQuery<JumpGraph<Weight>>>(
            std::move(parts), [&](QueryParts &p)
            { return JumpGraph<Weight>(*p.question.occupancy, p.jumps, p.goalCells(), makeWeight(p)); });
    return std::make_unique<GraphQuery<MotionGraph<Weight>>>(
        std::move(parts), [&](QueryParts &p)
        { return MotionGraph<Weight>(*p.cache, p.layout, p.jumps, p.startHeadings, p.goalCells(), makeWeight(p)); });
}

}  // namespace seahex
