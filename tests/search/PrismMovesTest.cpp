#include <seahex/search/PrismMoves.h>

#include "support/PrismOracle.h"
#include "support/Random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seahex::test
{
namespace
{

struct RandomPrisms
{
    int rings;
    double climb;
    PrismLattice lattice;

    explicit RandomPrisms(Random &random, std::int64_t across = 9)
        : rings(static_cast<int>(random.integer(1, 3))), climb(random.chance(0.3) ? 0.0 : random.real(0.05, 3.0)),
          lattice(HexLattice(Point(random.real(-1e4, 1e4), random.real(-1e4, 1e4)), random.real(0.5, 200.0), across,
                             across),
                  random.real(-50.0, 50.0), 1.0, 1)
    {
        const double reach = climb == 0.0 ? random.real(0.05, 2.0) : climb * random.real(0.1, rings);
        lattice = PrismLattice(lattice.plane(), lattice.top(), reach * lattice.pitch(), 7);
    }
    CellLayout layout() const { return {lattice.plane().columns(), lattice.plane().rows()}; }
};

TEST(PrismMoves, noneIsTooSteepAndTheyLeadWhereTheySay)
{
    forEachSeed(200,
                [](Random &random)
                {
                    const RandomPrisms prisms(random);
                    const CellLayout layout = prisms.layout();
                    const PrismMoves moves(prisms.lattice, layout, prisms.rings, prisms.climb);
                    EXPECT_TRUE(moves.canClimb());
                    EXPECT_LT(moves.all().size(), 255u);
                    for (const std::int64_t row : {4, 5})
                        for (const PrismMove &move : moves.all())
                        {
                            const CellIndex from = layout.index(OffsetCoord{4, row});
                            const CellIndex to = moves.successor(from, move);
                            EXPECT_EQ(moves.predecessor(to, move), from);
                            const Point3 by = prisms.lattice.node(layout.cell(to), 3 + move.layers) -
                                              prisms.lattice.node(layout.cell(from), 3);
                            EXPECT_TRUE(isClimbable(by, prisms.climb));
                            EXPECT_NEAR(by.norm() / prisms.lattice.pitch(), move.length, 1e-9);
                            EXPECT_LE(moves.norm(by), move.length * (1.0 + 1e-9));
                        }
                });
}

TEST(PrismMoves, theNormIsOneAndNoChainIsShorter)
{
    forEachSeed(40,
                [](Random &random)
                {
                    const RandomPrisms prisms(random);
                    const CellLayout layout = prisms.layout();
                    const PrismMoves moves(prisms.lattice, layout, prisms.rings, prisms.climb);
                    const auto anyVector = [&]
                    {
                        const double size = 5.0 * prisms.lattice.pitch();
                        return Point3(random.real(-size, size), random.real(-size, size),
                                      random.chance(0.2) ? 0.0 : random.real(-1.0, 1.0) * prisms.lattice.thickness());
                    };
                    for (int i = 0; i < 200; ++i)
                    {
                        const Point3 a = anyVector();
                        const Point3 b = anyVector();
                        EXPECT_LE(moves.norm(a + b), (moves.norm(a) + moves.norm(b)) * (1.0 + 1e-12));
                        EXPECT_NEAR(moves.norm(-2.5 * a), 2.5 * moves.norm(a), 1e-9);
                        EXPECT_GE(moves.norm(a) * prisms.lattice.pitch(), a.norm() * (1.0 - 1e-12));
                    }
                    const PrismOracle oracle{prisms.lattice, prisms.rings, prisms.climb,
                                             [](const Point3 &, const Point3 &)
                                             {
                                                 return true;
                                             }};
                    const HexCoord centre = toCube({4, 4});
                    const auto costs = oracle.graph().costsFrom({{oracle.vertexOf(centre, 3), 0.0}});
                    for (int layer = 0; layer < 7; ++layer)
                        for (std::int64_t row = 0; row < 9; ++row)
                            for (std::int64_t column = 0; column < 9; ++column)
                            {
                                const HexCoord cell = toCube({column, row});
                                const double cost = costs[oracle.vertexOf(cell, layer)] / prisms.lattice.pitch();
                                const double norm =
                                    moves.norm(prisms.lattice.node(cell, layer) - prisms.lattice.node(centre, 3));
                                EXPECT_LE(norm, cost * (1.0 + 1e-9));
                                if (layer == 3 && hexDistance(cell, centre) < 4)
                                {
                                    EXPECT_NEAR(norm, cost, 1e-9);
                                }
                            }
                });
}

}  // namespace
}  // namespace seahex::test
