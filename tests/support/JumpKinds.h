#pragma once

#include <seahex/search/AStar.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/LengthWeight.h>

#include "support/ExplicitGraph.h"
#include "support/Random.h"

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace seahex::test
{

/// Cost of a jump as an oracle counts it.
using CostOfJump = std::function<double(OffsetCoord from, OffsetCoord to)>;

// The jumps on either kind of cells, and the same written out edge by edge, for tests of what holds for both:
//
//     template <class Kind>
//     class Xyz : public testing::Test {};
//     TYPED_TEST_SUITE(Xyz, JumpKinds, JumpKindNames);

struct HexKind
{
    using KnownLattice = HexLattice;
    using Norm = HexJumpNorm;
    using TableOfJumps = HexJumps;

    /// Rings.
    static std::vector<int> reaches() { return {1, 2, 3}; }
    static HexJumps jumps(const CellLayout &layout, int reach, JumpRule rule)
    {
        return HexJumps(layout, reach, JumpSet::All, rule);
    }
    static ExplicitGraph graph(const HexOccupancy &occupancy, int reach, JumpRule rule, const CostOfJump &cost)
    {
        return jumpGraph(
            occupancy, reach, [&cost](HexCoord from, HexCoord to) { return cost(toOffset(from), toOffset(to)); }, rule);
    }
    static double steps(OffsetCoord from, OffsetCoord to)
    {
        return static_cast<double>(hexDistance(toCube(from), toCube(to)));
    }
};

struct SquareKind
{
    using KnownLattice = SquareLattice;
    using Norm = SquareJumpNorm;
    using TableOfJumps = SquareJumps;

    /// Neighbours.
    static std::vector<int> reaches() { return {4, 8}; }
    static SquareJumps jumps(const CellLayout &layout, int reach, JumpRule rule)
    {
        return SquareJumps(layout, reach, rule);
    }
    static ExplicitGraph graph(const SquareOccupancy &occupancy, int reach, JumpRule rule, const CostOfJump &cost)
    {
        return stepGraph(occupancy, reach, rule, cost);
    }
    /// A step's length: octile costs.
    static double steps(OffsetCoord from, OffsetCoord to)
    {
        return from.column == to.column || from.row == to.row ? 1.0 : std::sqrt(2.0);
    }
};

using JumpKinds = testing::Types<HexKind, SquareKind>;

struct JumpKindNames
{
    template <class Kind>
    static std::string GetName(int)
    {
        return std::is_same_v<Kind, HexKind> ? "Hexagons" : "Squares";
    }
};

/// Length of the straight way between two centres, in pitches.
template <class KnownLattice>
double lengthBetween(const KnownLattice &lattice, OffsetCoord from, OffsetCoord to)
{
    return (lattice.centre(KnownLattice::cell(to)) - lattice.centre(KnownLattice::cell(from))).norm() / lattice.pitch();
}

/// Cost of the path that A* finds from one cell to another; infinity if it finds none.
template <class Weight>
double searchedCost(const Occupancy &occupancy, const Jumps &jumps, const Weight &weight, OffsetCoord start,
                    OffsetCoord goal)
{
    JumpGraph<Weight> graph(occupancy, jumps, {{goal, 0.0}}, weight);
    AStar<JumpGraph<Weight>> search(graph);
    search.addStart(occupancy.layout().index(start), 0.0);
    search.run([] { return false; }, 1000);
    return search.cost();
}

/// Are two costs the same but for rounding, or both infinite?
inline bool isSame(double a, double b)
{
    return a == b || std::abs(a - b) < 1e-9;
}

/// A small random world with a free start and goal.
template <class Kind>
struct RandomWorld
{
    using KnownLattice = typename Kind::KnownLattice;

    explicit RandomWorld(Random &random)
        : lattice(Point(random.real(-9, 9), random.real(-9, 9)), random.real(0.2, 5.0), random.integer(2, 9),
                  random.integer(2, 9))
    {
        do
            occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.5));
        while (occupancy->blockedCount() == lattice.cellCount());
        start = freeCell(random);
        goal = freeCell(random);
    }

    OffsetCoord freeCell(Random &random) const
    {
        for (;;)
        {
            const OffsetCoord cell = toOffset(random.cellOf(lattice));
            if (occupancy->isFree(KnownLattice::cell(cell)))
                return cell;
        }
    }

    Point centre(OffsetCoord cell) const { return lattice.centre(KnownLattice::cell(cell)); }

    KnownLattice lattice;
    std::shared_ptr<const LatticeOccupancy<KnownLattice>> occupancy;
    OffsetCoord start;
    OffsetCoord goal;
};

}  // namespace seahex::test
