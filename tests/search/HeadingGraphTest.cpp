#include <seahex/search/HeadingGraph.h>
#include <seahex/search/JumpGraph.h>
#include <seahex/search/TurnWeight.h>

#include "support/AsciiWorld.h"

#include <set>
#include <stdexcept>
#include <tuple>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

using Cells = JumpGraph<TurnWeight>;
using Graph = HeadingGraph<Cells>;
using Move = std::tuple<CellIndex, std::size_t, double>;  // cell, heading, cost

const AsciiWorld world(R"(
     . . . . .
    . . A # .
     . . . . B
)");

struct Fixture
{
    HexJumps jumps{world.occupancy().layout(), 3, JumpSet::Primitive};
    Graph graph{Cells{world.occupancy(),
                      jumps,
                      {{world.cell('B'), 0.5}},
                      TurnWeight(world.lattice(), jumps, LengthMetric::Euclidean, {2.0, 1.0}, Guidance::Distance,
                                 world.centre('A'), world.centre('B'))}};
    CellIndex a = world.occupancy().layout().index(world.cell('A'));
    CellIndex b = world.occupancy().layout().index(world.cell('B'));

    CellIndex state(CellIndex cell, std::size_t heading) const
    {
        return graph.beginning(cell) - static_cast<CellIndex>(jumps.size() - heading);
    }

    /// What a state leads to; each move must lead back.
    std::set<Move> movesFrom(CellIndex from, std::uint8_t arrivedBy)
    {
        std::set<Move> moves;
        EXPECT_TRUE(graph.expand(from, arrivedBy,
                                 [&](CellIndex to, std::uint8_t move, double cost)
                                 {
                                     EXPECT_EQ(graph.predecessor(to, move), from);
                                     moves.insert({graph.cellOf(to), graph.headingOf(to), cost});
                                 }));
        return moves;
    }
};

}  // namespace

TEST(HeadingGraph, aPathBeginsWithAnyHeadingForNothing)
{
    Fixture f;
    std::set<Move> expected;
    for (std::size_t k = 0; k < f.jumps.size(); ++k)
        expected.insert({f.a, k, 0.0});
    EXPECT_EQ(f.movesFrom(f.graph.beginning(f.a), 255), expected);
    EXPECT_EQ(f.graph.headingOf(f.graph.beginning(f.a)), f.jumps.size());
}

TEST(HeadingGraph, whoHasArrivedMayTurnAndWhoHasTurnedMayNot)
{
    Fixture f;
    const std::size_t west = 3;  // rings run counter-clockwise from east
    ASSERT_EQ(f.jumps.offset(west).offset, (HexCoord{-1, 0}));
    const Move ahead = {f.a - 1, west, 1.0};
    EXPECT_EQ(f.movesFrom(f.state(f.a, west), 255), std::set<Move>{ahead});
    EXPECT_EQ(f.movesFrom(f.state(f.a, west), 1), std::set<Move>{ahead});
    std::set<Move> expected = {ahead};
    for (std::size_t k = 0; k < f.jumps.size(); ++k)
        if (k != west)
            expected.insert({f.a, k, f.graph.cells().turn(west, k)});
    EXPECT_EQ(f.movesFrom(f.state(f.a, west), static_cast<std::uint8_t>(west)), expected);
}

TEST(HeadingGraph, noAdvanceIntoABlockedCell)
{
    Fixture f;
    const std::size_t east = 0;
    EXPECT_EQ(f.movesFrom(f.state(f.a, east), 255), std::set<Move>{});
    EXPECT_EQ(f.movesFrom(f.state(f.a, east), static_cast<std::uint8_t>(east)).size(), f.jumps.size() - 1);
}

TEST(HeadingGraph, fewerRingsHaveFewerHeadings)
{
    Fixture f;
    f.graph.useRings(1);
    EXPECT_EQ(f.movesFrom(f.graph.beginning(f.a), 255).size(), 6u);
    EXPECT_EQ(f.movesFrom(f.state(f.a, 3), 3).size(), 6u) << "five turns and a step";
}

TEST(HeadingGraph, aPathEndsWithAnyHeading)
{
    Fixture f;
    for (std::size_t k = 0; k <= f.jumps.size(); ++k)
    {
        EXPECT_EQ(f.graph.finish(f.state(f.b, k)), 0.5);
        EXPECT_EQ(f.graph.bound(f.state(f.b, k)), 0.5);
        EXPECT_EQ(f.graph.finish(f.state(f.a, k)), f.graph.worst());
    }
}

TEST(HeadingGraph, statesHave32BitNumbersOrThereIsNoGraph)
{
    EXPECT_TRUE(headingsFit(116'000'000, 36));
    EXPECT_FALSE(headingsFit(117'000'000, 36));
    const HexLattice wide(Point::Zero(), 1.0, 20'000'000, 6);
    const CellLayout layout(wide.columns(), wide.rows());
    EXPECT_FALSE(headingsFit(layout.size(), 24));
    const auto occupancy = occupancyWith(wide, {});
    const HexJumps jumps(layout, 3, JumpSet::Primitive);
    EXPECT_THROW(Graph(Cells{*occupancy,
                             jumps,
                             {},
                             TurnWeight(wide, jumps, LengthMetric::Euclidean, {}, Guidance::None, Point::Zero(),
                                        Point::Zero())}),
                 std::length_error);
}
