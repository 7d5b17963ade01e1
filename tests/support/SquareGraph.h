#pragma once

#include "support/ExplicitGraph.h"

#include <seahex/world/Occupancy.h>

namespace seahex::test
{

/// Vertex number of a cell of the rectangle in a graph made by squareGraph().
std::size_t vertexOf(const SquareLattice &lattice, OffsetCoord cell);

/// All steps between free squares, at their length in cells, diagonal ones with 8 neighbours only, and unless corners
/// may be cut only where both cells beside them are free. It knows nothing of SquareJumps.
ExplicitGraph squareGraph(const SquareOccupancy &occupancy, int neighbours, bool cornerCutting);

}  // namespace seahex::test
