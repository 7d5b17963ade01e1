// What a jump needs, safe and hopping: the tables, and the optima of searches by either rule.

#include "support/JumpKinds.h"

#include "support/AsciiWorld.h"

#include <cmath>

using namespace seahex;
using namespace seahex::test;

namespace
{

template <class Kind>
class JumpRules : public ::testing::Test
{
public:
    static double searched(const RandomWorld<Kind> &world, int reach, JumpRule rule, Guidance guidance)
    {
        const auto jumps = Kind::jumps(world.occupancy->layout(), reach, rule);
        const LatticeLengthWeight<typename Kind::Norm> weight(world.lattice, jumps, LengthMetric::Euclidean, guidance,
                                                              world.centre(world.start), world.centre(world.goal));
        return searchedCost(*world.occupancy, jumps, weight, world.start, world.goal);
    }

    static double leastCost(const RandomWorld<Kind> &world, int reach, JumpRule rule)
    {
        const auto length = [&world](OffsetCoord from, OffsetCoord to)
        {
            return lengthBetween(world.lattice, from, to);
        };
        return Kind::graph(*world.occupancy, reach, rule, length)
            .cheapest({{vertexOf(world.lattice, world.start), 0.0}}, {{vertexOf(world.lattice, world.goal), 0.0}});
    }
};

TYPED_TEST_SUITE(JumpRules, JumpKinds, JumpKindNames);

}  // namespace

TEST(JumpRules, haveNames)
{
    EXPECT_STREQ(toString(JumpRule::Safe), "safe");
    EXPECT_STREQ(toString(JumpRule::Hopping), "hopping");
}

TYPED_TEST(JumpRules, aHopNeedsItsLastCellOnly)
{
    const CellLayout layout(9, 8);
    for (const int reach : TypeParam::reaches())
    {
        const auto hops = TypeParam::jumps(layout, reach, JumpRule::Hopping);
        const auto safe = TypeParam::jumps(layout, reach, JumpRule::Safe);
        ASSERT_EQ(hops.size(), safe.size());
        for (const int parity : {0, 1})
            for (std::size_t k = 0; k < hops.size(); ++k)
            {
                const Jump &hop = hops.from(parity)[k];
                ASSERT_EQ(hop.endTouch, hop.firstTouch + 1);
                ASSERT_EQ(hops.touched()[hop.firstTouch], hop.delta);
                ASSERT_EQ(hop.delta, safe.from(parity)[k].delta);
                ASSERT_EQ(hops.length(k), safe.length(k));
            }
    }
}

TYPED_TEST(JumpRules, costsEqualDijkstrasAndHopsCostNoMore)
{
    int cheaper = 0;
    int onlyByHops = 0;
    forEachSeed(600,
                [&](Random &random)
                {
                    const RandomWorld<TypeParam> world(random);
                    SCOPED_TRACE(toPicture(*world.occupancy));
                    for (const int reach : TypeParam::reaches())
                    {
                        double cost[2];
                        for (const JumpRule rule : {JumpRule::Safe, JumpRule::Hopping})
                        {
                            const double least = this->leastCost(world, reach, rule);
                            cost[rule == JumpRule::Hopping] = least;
                            for (const Guidance guidance : {Guidance::None, Guidance::Distance, Guidance::TieBreak})
                            {
                                const double found = this->searched(world, reach, rule, guidance);
                                ASSERT_TRUE(isSame(found, least)) << found << ", not " << least << ": "
                                                                  << toString(rule) << ", " << toString(guidance);
                            }
                        }
                        ASSERT_LE(cost[1], cost[0] + 1e-9);
                        cheaper += std::isfinite(cost[0]) && cost[1] < cost[0] - 1e-9 ? 1 : 0;
                        onlyByHops += std::isinf(cost[0]) && std::isfinite(cost[1]) ? 1 : 0;
                    }
                });
    EXPECT_GT(cheaper, 50);
    EXPECT_GT(onlyByHops, 20);
}

TEST(JumpRules, aHopCrossesAReefOfItsOwnLength)
{
    const AsciiWorld world(R"(
         . . # . . .
        . . # . . .
         A . # . B .
        . . # . . .
         . . # . . .
    )");
    const auto costOf = [&](int rings, JumpSet set, JumpRule rule)
    {
        const HexJumps jumps(world.occupancy().layout(), rings, set, rule);
        const LengthWeight weight(world.lattice(), jumps, LengthMetric::Lattice, Guidance::Distance, world.centre('A'),
                                  world.centre('B'));
        return searchedCost(world.occupancy(), jumps, weight, toOffset(world.cell('A')), toOffset(world.cell('B')));
    };
    EXPECT_TRUE(std::isinf(costOf(3, JumpSet::All, JumpRule::Safe)));
    EXPECT_TRUE(std::isinf(costOf(1, JumpSet::All, JumpRule::Hopping))) << "a neighbour is hopped to or blocked";
    EXPECT_EQ(costOf(2, JumpSet::All, JumpRule::Hopping), 4.0);
    // those that are no multiples of shorter ones cross it too, and it takes them a step more
    EXPECT_GT(costOf(2, JumpSet::Primitive, JumpRule::Hopping), 4.0);
}

TEST(JumpRules, squaresCutCornersByHopsOnly)
{
    const auto stepsBetween = [](const SquareWorld &world, JumpRule rule)
    {
        const SquareJumps jumps(world.occupancy().layout(), 8, rule);
        const SquareLengthWeight weight(world.lattice(), jumps, LengthMetric::Euclidean, Guidance::Distance,
                                        world.centre('A'), world.centre('B'));
        return searchedCost(world.occupancy(), jumps, weight, world.cell('A'), world.cell('B'));
    };
    const SquareWorld corner(R"(
        A #
        . B
    )");
    EXPECT_DOUBLE_EQ(stepsBetween(corner, JumpRule::Safe), 2.0);
    EXPECT_DOUBLE_EQ(stepsBetween(corner, JumpRule::Hopping), std::sqrt(2.0));
    const SquareWorld gate(R"(
        A #
        # B
    )");
    EXPECT_TRUE(std::isinf(stepsBetween(gate, JumpRule::Safe)));
    EXPECT_DOUBLE_EQ(stepsBetween(gate, JumpRule::Hopping), std::sqrt(2.0));
}
