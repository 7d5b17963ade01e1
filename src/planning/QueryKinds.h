#pragma once

#include "planning/LatticeQuery.h"
#include "planning/QueryParts.h"

#include <memory>

namespace seahex
{

// A maker for each kind of weight, in a source of its own: each of them compiles searches for two lattices, read and
// asked.

/// Of lengths that are known beforehand: QueryParts::metric.
std::unique_ptr<LatticeQuery> makeLengthQuery(std::unique_ptr<QueryParts> parts);

/// Of path length on the hexagons of a chart that is read, with safe jumps, from one start to one goal: as
/// makeLengthQuery() with Guidance::Distance, and several times as fast.
std::unique_ptr<LatticeQuery> makeShortestQuery(std::unique_ptr<QueryParts> parts);

/// Of safety weights charged on arrival: QueryParts::safety.
std::unique_ptr<LatticeQuery> makeSafetyQuery(std::unique_ptr<QueryParts> parts);

/// Of costs that depend on courses, QueryParts::courses, over cells and headings.
/// @throws std::bad_alloc if the memory does not last
std::unique_ptr<LatticeQuery> makeHeadingQuery(std::unique_ptr<QueryParts> parts);

/// Of any objective.
std::unique_ptr<LatticeQuery> makeObjectiveQuery(std::unique_ptr<QueryParts> parts);

}  // namespace seahex
