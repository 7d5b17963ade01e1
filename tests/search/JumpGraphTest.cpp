#include <seahex/search/JumpGraph.h>
#include <seahex/search/LengthWeight.h>

#include "support/AsciiWorld.h"
#include "support/HexOracle.h"
#include "support/Random.h"

#include <iterator>
#include <set>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

std::set<HexCoord> successorsOf(const HexOccupancy &occupancy, HexCoord cell, int rings, JumpSet set)
{
    const HexJumps jumps(occupancy.layout(), rings, set);
    const Point nowhere = Point::Zero();
    JumpGraph<LengthWeight> graph(
        occupancy, jumps, {},
        LengthWeight(occupancy.lattice(), jumps, LengthMetric::Euclidean, Guidance::None, nowhere, nowhere));
    std::set<HexCoord> successors;
    const CellIndex index = occupancy.layout().index(cell);
    EXPECT_TRUE(graph.expand(index, 255,
                             [&](CellIndex successor, std::uint8_t jump, double cost)
                             {
                                 EXPECT_TRUE(successors.insert(occupancy.layout().cell(successor)).second);
                                 EXPECT_EQ(graph.predecessor(successor, jump), index);
                                 EXPECT_EQ(cost, jumps.length(jump));
                             }));
    return successors;
}

}  // namespace

TEST(JumpGraph, aJumpIsNoHop)
{
    // A reef one cell thick: of the 36 jumps none leads across. (Jumps of the third ring reach the far side.)
    const AsciiWorld reef(R"(
         . . . # . . .
        . . . # . . .
         . . A # . . .
        . . . # . . .
         . . . # . . .
    )");
    for (const HexCoord cell : successorsOf(reef.occupancy(), reef.cell('A'), 3, JumpSet::All))
        EXPECT_LT(toOffset(cell).column, 3);
    // Two rocks that meet in an edge: between them there is no way, though the straight line only runs along the edge.
    const AsciiWorld gate(R"(
         . . A . .
        . . # # .
         . . B . .
    )");
    EXPECT_EQ(successorsOf(gate.occupancy(), gate.cell('A'), 3, JumpSet::All).count(gate.cell('B')), 0u);
    // One rock on one side of that edge is enough.
    const AsciiWorld post(R"(
         . . A . .
        . . # . .
         . . B . .
    )");
    EXPECT_EQ(successorsOf(post.occupancy(), post.cell('A'), 3, JumpSet::All).count(post.cell('B')), 0u);
    const AsciiWorld open(R"(
         . . A . .
        . . . . .
         . . B . .
    )");
    EXPECT_EQ(successorsOf(open.occupancy(), open.cell('A'), 3, JumpSet::All).count(open.cell('B')), 1u);
    EXPECT_EQ(successorsOf(open.occupancy(), open.cell('A'), 1, JumpSet::All).count(open.cell('B')), 0u);
}

TEST(JumpGraph, successorsAreTheJumpsThatTouchFreeCellsOnly)
{
    for (std::uint64_t seed = 1; seed <= 150; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice(Point::Zero(), 1.0, random.integer(1, 9), random.integer(1, 8));
        const auto occupancy = randomOccupancy(random, lattice, random.real(0.0, 0.5));
        for (int i = 0; i < 5; ++i)
        {
            const HexCoord cell = random.cellOf(lattice);
            const int rings = static_cast<int>(random.integer(1, 3));
            const JumpSet set = random.chance(0.5) ? JumpSet::All : JumpSet::Primitive;
            std::set<HexCoord> expected;
            for (const RingOffset &jump : ringOffsets(rings))
                if (set == JumpSet::All || jump.primitive)
                    expected.insert(cell + jump.offset);
            for (auto to = expected.begin(); to != expected.end();)
            {
                // the cell itself may be a rock here: whoever stands in it may leave
                bool valid = lattice.contains(*to);
                forEachCell(lattice, CellLayout::frame,
                            [&](HexCoord touched)
                            {
                                valid = valid && (touched == cell || occupancy->isFree(touched) ||
                                                  !touchesExactly<std::int64_t>(cell, *to, touched));
                            });
                to = valid ? std::next(to) : expected.erase(to);
            }
            ASSERT_EQ(successorsOf(*occupancy, cell, rings, set), expected) << toPicture(*occupancy, {cell});
        }
    }
}
