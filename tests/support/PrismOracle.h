#pragma once

#include "support/ExplicitGraph.h"

#include <seahex/geometry/PrismLattice.h>

#include <functional>
#include <vector>

namespace seahex::test
{

/// May one go straight from one point to another? Both may lie anywhere.
using FreeMotion = std::function<bool(const Point3 &from, const Point3 &to)>;

/// What a search on prisms must find, written out: all motions between nodes of one layer or two neighbouring ones
/// whose hexagons are up to `rings` steps apart, collinear repetitions included; straight up and down only where the
/// climb is not limited (0). Costs in metres. It knows nothing of HexRing, HexJumps and PrismMoves.
struct PrismOracle
{
    PrismLattice lattice;
    int rings;
    double climb;
    FreeMotion isFree;

    std::size_t vertexOf(HexCoord cell, int layer) const;
    bool isMotion(const Point3 &from, const Point3 &to) const;
    ExplicitGraph graph() const;
    /// The motions between a point and the nodes of layers no farther than the thickness, in hexagons up to `steps`
    /// away.
    std::vector<ExplicitGraph::Terminal> joints(const Point3 &end, int steps, bool isStart) const;
};

}  // namespace seahex::test
