#include <seahex/geometry/LatticeNorm.h>

#include "support/LatticeKinds.h"
#include "support/Random.h"

#include <cmath>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

template <class LatticeType>
class LatticeNormOf : public testing::Test
{
};
TYPED_TEST_SUITE(LatticeNormOf, LatticeKinds, LatticeKindNames);

}  // namespace

TEST(LatticeNorm, theyAreThoseOfTheKind)
{
    const Lattice hexagons = HexLattice({300.0, -70.0}, 2.5, 10, 10);
    const Lattice squares = SquareLattice({300.0, -70.0}, 2.5, 10, 10);
    Random random(1);
    SCOPED_TRACE(random.seedText());
    for (int i = 0; i < 1000; ++i)
    {
        const Point vector = random.pointIn({Point(-90.0, -90.0), Point(90.0, 90.0)});
        ASSERT_EQ(latticeNorm(vector, hexagons), hexNorm(vector, *hexagons.hexagons()));
        ASSERT_EQ(latticeNorm(vector, squares), octileNorm(vector, 2.5));
    }
    // [Cheng2020]'s scenario: start and goal are 115 steps apart on hexagons
    EXPECT_EQ(latticeDistance({5, 114}, {115, 103}, hexagons), 115.0);
    // and on squares 10 of 109 columns are crossed aslant
    EXPECT_NEAR(latticeDistance({6, 99}, {115, 89}, squares), 99.0 + 10.0 * std::sqrt(2.0), 1e-12);
}

TYPED_TEST(LatticeNormOf, cellsAreAsFarAsTheirCentres)
{
    const Lattice lattice = TypeParam({300.0, -70.0}, 2.5, 10, 10);
    for (const OffsetCoord a : {OffsetCoord{4, 4}, {4, 5}})
        for (std::int64_t column = -9; column <= 15; ++column)
            for (std::int64_t row = -9; row <= 15; ++row)
            {
                const OffsetCoord b{column, row};
                const double norm = latticeNorm(lattice.centre(b) - lattice.centre(a), lattice);
                ASSERT_NEAR(latticeDistance(a, b, lattice), norm, 1e-9) << column << ", " << row;
                ASSERT_EQ(latticeDistance(b, a, lattice), latticeDistance(a, b, lattice));
            }
}

TYPED_TEST(LatticeNormOf, aStepToANeighbourCostsWhatItIsLong)
{
    const Lattice lattice = TypeParam({300.0, -70.0}, 2.5, 10, 10);
    for (const OffsetCoord cell : {OffsetCoord{4, 4}, {4, 5}})
        for (const OffsetCoord neighbour : lattice.neighbours(cell))
        {
            const double length = (lattice.centre(neighbour) - lattice.centre(cell)).norm() / lattice.pitch();
            EXPECT_NEAR(latticeDistance(cell, neighbour, lattice), length, 1e-9);
        }
}
