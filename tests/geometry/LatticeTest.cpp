#include <seahex/geometry/Lattice.h>

#include "support/CellOutline.h"
#include "support/LatticeKinds.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <boost/geometry/geometry.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

template <class LatticeType>
class LatticeFaceOf : public testing::Test
{
};
TYPED_TEST_SUITE(LatticeFaceOf, LatticeKinds, LatticeKindNames);

template <class LatticeType>
LatticeType randomLattice(Random &random)
{
    const Point northWest = random.pointIn({Point(-1e3, -1e3), Point(1e3, 1e3)});
    return {northWest, random.real(0.1, 10.0), random.integer(1, 30), random.integer(1, 30)};
}

/// Corners that two cells have in common.
int sharedCorners(const Lattice &lattice, OffsetCoord a, OffsetCoord b)
{
    int shared = 0;
    for (const Point &corner : lattice.corners(a))
        for (const Point &other : lattice.corners(b))
            shared += (corner - other).norm() < 1e-9 ? 1 : 0;
    return shared;
}

}  // namespace

TYPED_TEST(LatticeFaceOf, saysWhatTheLatticeBehindItSays)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam kind = randomLattice<TypeParam>(random);
        const Lattice lattice = kind;
        ASSERT_EQ(lattice.northWest(), kind.northWest());
        ASSERT_EQ(lattice.pitch(), kind.pitch());
        ASSERT_EQ(lattice.columns(), kind.columns());
        ASSERT_EQ(lattice.rows(), kind.rows());
        ASSERT_EQ(lattice.cellCount(), kind.cellCount());
        ASSERT_EQ(lattice.bounds().min, kind.bounds().min);
        ASSERT_EQ(lattice.bounds().max, kind.bounds().max);
        for (int i = 0; i < 50; ++i)
        {
            const OffsetCoord cell{random.integer(-5, 35), random.integer(-5, 35)};
            const auto same = TypeParam::cell(cell);
            ASSERT_EQ(lattice.contains(cell), kind.contains(same));
            ASSERT_EQ(lattice.centre(cell), kind.centre(same));
            const auto corners = kind.corners(same);
            ASSERT_EQ(lattice.corners(cell), std::vector<Point>(corners.begin(), corners.end()));
            const Point p = random.pointOf(kind, same);
            ASSERT_EQ(lattice.cellAt(p), toOffset(kind.cellAt(p)));
        }
    }
}

TYPED_TEST(LatticeFaceOf, knowsItsKind)
{
    const TypeParam kind({3.0, 4.0}, 1.5, 10, 12);
    const Lattice lattice = kind;
    constexpr bool isHex = std::is_same_v<TypeParam, HexLattice>;
    ASSERT_EQ(lattice.hexagons() != nullptr, isHex);
    ASSERT_EQ(lattice.squares() != nullptr, !isHex);
    if constexpr (isHex)
    {
        EXPECT_EQ(*lattice.hexagons(), kind);
    }
    else
    {
        EXPECT_EQ(*lattice.squares(), kind);
    }
    EXPECT_EQ(lattice, Lattice(TypeParam({3.0, 4.0}, 1.5, 10, 12)));
    EXPECT_NE(lattice, Lattice(TypeParam({3.0, 4.0}, 1.5, 10, 13)));
}

TEST(Lattice, hexagonsAreNoSquares)
{
    EXPECT_NE(Lattice(HexLattice({3.0, 4.0}, 1.5, 10, 12)), Lattice(SquareLattice({3.0, 4.0}, 1.5, 10, 12)));
}

TYPED_TEST(LatticeFaceOf, rowsAreWhereTheCentresAre)
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam kind = randomLattice<TypeParam>(random);
        const Lattice lattice = kind;
        const CellOracle<TypeParam> oracle(kind);
        for (std::int64_t row = -3; row <= 3; ++row)
            for (const std::int64_t column : {-7, 0, 1, 12})
            {
                const LongVector centre = oracle.centre(TypeParam::cell({column, row}));
                const double x =
                    kind.northWest().x() + kind.pitch() * (lattice.firstColumn(row) + static_cast<double>(column));
                const double y =
                    kind.northWest().y() - lattice.halfHeight() - lattice.rowStep() * static_cast<double>(row);
                ASSERT_NEAR(x, static_cast<double>(centre.x), 1e-10);
                ASSERT_NEAR(y, static_cast<double>(centre.y), 1e-10);
            }
        double north = -1e9;
        for (const Point &corner : lattice.corners({2, 3}))
            north = std::max(north, corner.y() - lattice.centre({2, 3}).y());
        EXPECT_NEAR(lattice.halfHeight(), north, 1e-10);
        EXPECT_NEAR(lattice.cellArea(), boost::geometry::area(outline(kind, TypeParam::cell({2, 3}))), 1e-8);
    }
}

TYPED_TEST(LatticeFaceOf, neighboursAreTheCellsThatTouch)
{
    const Lattice lattice = TypeParam({-2.0, 5.0}, 0.75, 9, 9);
    for (const OffsetCoord cell : {OffsetCoord{4, 4}, {4, 5}, {0, 0}, {-3, -7}})
    {
        std::set<OffsetCoord> expected;
        for (std::int64_t row = cell.row - 3; row <= cell.row + 3; ++row)
            for (std::int64_t column = cell.column - 3; column <= cell.column + 3; ++column)
                if (OffsetCoord{column, row} != cell && sharedCorners(lattice, cell, {column, row}) > 0)
                    expected.insert({column, row});
        const std::vector<OffsetCoord> neighbours = lattice.neighbours(cell);
        EXPECT_EQ(std::set<OffsetCoord>(neighbours.begin(), neighbours.end()), expected);
        EXPECT_EQ(neighbours.size(), expected.size()) << "each once";
        // all the way round, counter-clockwise
        ASSERT_FALSE(neighbours.empty());
        EXPECT_EQ(neighbours.front(), (OffsetCoord{cell.column + 1, cell.row}));
        double last = -1.0;
        for (const OffsetCoord neighbour : neighbours)
        {
            const Point d = lattice.centre(neighbour) - lattice.centre(cell);
            const double angle = std::atan2(d.y(), d.x()) + (d.y() < -1e-9 ? 2.0 * M_PI : 0.0);
            EXPECT_GT(angle, last);
            last = angle;
        }
    }
}
