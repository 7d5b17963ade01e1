#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/SquareLattice.h>

#include "support/CellOutline.h"
#include "support/LatticeKinds.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <boost/geometry/geometry.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

template <class LatticeType>
class LatticeOf : public testing::Test
{
};
TYPED_TEST_SUITE(LatticeOf, LatticeKinds, LatticeKindNames);

const double infinity = std::numeric_limits<double>::infinity();
const double notANumber = std::numeric_limits<double>::quiet_NaN();

template <class LatticeType>
double largestCoordinate(const LatticeType &lattice, const Point &p)
{
    return std::max({p.cwiseAbs().maxCoeff(), lattice.northWest().cwiseAbs().maxCoeff(), lattice.pitch()});
}

/// Lattices near the origin and far from it, of all sizes of cells.
template <class LatticeType>
LatticeType randomLattice(Random &random)
{
    const double reach = std::pow(10.0, random.real(0.0, 9.0));
    const double pitch = std::max(std::pow(10.0, random.real(-3.0, 3.0)), 1e-7 * reach);
    const Box box{Point(-reach, -reach), Point(reach, reach)};
    return {random.pointIn(box), pitch, random.integer(1, 50), random.integer(1, 50)};
}

template <class LatticeType>
bool isCovered(const LatticeType &lattice, const Point &p)
{
    // the nearest cells may meet in a point of the border: any of them will do
    const OffsetCoord nearest = toOffset(lattice.cellAt(p));
    for (std::int64_t row = nearest.row - 1; row <= nearest.row + 1; ++row)
        for (std::int64_t column = nearest.column - 1; column <= nearest.column + 1; ++column)
        {
            const auto cell = LatticeType::cell({column, row});
            if (lattice.contains(cell) && lattice.distance(p, cell) <= 1e-9 * largestCoordinate(lattice, p))
                return true;
        }
    return false;
}

bool near(OffsetCoord a, OffsetCoord b)
{
    return std::abs(a.column - b.column) <= 1 && std::abs(a.row - b.row) <= 1;
}

}  // namespace

TYPED_TEST(LatticeOf, cellOfItsOwnCentre)
{
    for (const Point &northWest : {Point(0.0, 0.0), Point(1e9, -1e9), Point(-1e9, 1e9), Point(112.5, 21.98)})
        for (const double pitch : {std::sqrt(3.0) * 0.002, 1.0, 20.0, 1852.0})
        {
            if (pitch < 1e-8 * northWest.cwiseAbs().maxCoeff())
                continue;  // such cells are smaller than what doubles are promised to tell apart
            const TypeParam lattice(northWest, pitch, 1, 1);
            for (std::int64_t column = -40; column <= 40; ++column)
                for (std::int64_t row = -40; row <= 40; ++row)
                    ASSERT_EQ(toOffset(lattice.cellAt(lattice.centre(TypeParam::cell({column, row})))),
                              (OffsetCoord{column, row}))
                        << pitch;
        }
}

TYPED_TEST(LatticeOf, everyPointLiesInItsCell)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice = randomLattice<TypeParam>(random);
        const CellOracle<TypeParam> oracle(lattice);
        const double reach = lattice.northWest().cwiseAbs().maxCoeff() + 100.0 * lattice.pitch();
        for (int i = 0; i < 200; ++i)
        {
            const Point p = i % 2 == 0 ? random.pointIn({Point(-reach, -reach), Point(reach, reach)})
                                       : random.pointOf(lattice, random.cellOf(lattice));
            ASSERT_LE(oracle.distance(p, lattice.cellAt(p)), 1e-9L * largestCoordinate(lattice, p)) << p.transpose();
        }
    }
}

TYPED_TEST(LatticeOf, edgesAndCornersBelongToACellThatMeetsThere)
{
    const TypeParam lattice({112.50, 21.98}, std::sqrt(3.0) * 0.002, 143, 159);
    for (std::int64_t row = 0; row < 12; ++row)
        for (std::int64_t column = 0; column < 12; ++column)
        {
            const auto cell = TypeParam::cell({column, row});
            const auto corners = lattice.corners(cell);
            for (std::size_t i = 0; i < corners.size(); ++i)
            {
                const Point midway = 0.5 * (corners[i] + corners[(i + 1) % corners.size()]);
                for (const Point &p : {corners[i], midway})
                {
                    ASSERT_TRUE(near(toOffset(lattice.cellAt(p)), {column, row}));
                    ASSERT_LE(lattice.distance(p, lattice.cellAt(p)), 1e-9 * 112.5);
                }
                // a little towards the centre, and it is this cell
                ASSERT_EQ(lattice.cellAt(corners[i] + 1e-6 * (lattice.centre(cell) - corners[i])), cell);
                ASSERT_EQ(lattice.cellAt(midway + 1e-6 * (lattice.centre(cell) - midway)), cell);
            }
        }
}

TYPED_TEST(LatticeOf, pointsBeyondAllCellsAreOutside)
{
    const TypeParam lattice(Point::Zero(), 1.0, 4, 4);
    const double values[] = {0.0, 1e18, -1e18, 1e19, -1e19, 1e300, -1e300, infinity, -infinity, notANumber};
    for (const double x : values)
        for (const double y : values)
        {
            if (x != 0.0 || y != 0.0)
            {
                EXPECT_FALSE(lattice.contains(lattice.cellAt({x, y}))) << x << ", " << y;
            }
        }
}

TYPED_TEST(LatticeOf, distanceIsThatToThePolygonOfTheCorners)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice({random.real(-100, 100), random.real(-100, 100)}, random.real(0.1, 10.0), 5, 5);
        const auto cell = random.cellOf(lattice);
        const Polygon polygon = outline(lattice, cell);
        const double reach = 3.0 * lattice.pitch();
        for (int i = 0; i < 50; ++i)
        {
            const Point p =
                i % 5 == 0 ? random.pointOf(lattice, cell)
                           : Point(lattice.centre(cell) + random.pointIn({Point(-reach, -reach), Point(reach, reach)}));
            ASSERT_NEAR(lattice.distance(p, cell), boost::geometry::distance(p, polygon), 1e-11) << p.transpose();
        }
    }
}

TYPED_TEST(LatticeOf, boundsAreThoseOfAllCells)
{
    for (const std::int64_t rows : {1, 2, 3, 8})
        for (const std::int64_t columns : {1, 2, 7})
        {
            const TypeParam lattice({-5.0, 9.0}, 0.7, columns, rows);
            Point low(infinity, infinity);
            Point high(-infinity, -infinity);
            forEachCell(lattice, 0,
                        [&](typename TypeParam::Cell cell)
                        {
                            for (const Point &corner : lattice.corners(cell))
                            {
                                low = low.cwiseMin(corner);
                                high = high.cwiseMax(corner);
                            }
                        });
            EXPECT_NEAR((lattice.bounds().min - low).norm(), 0.0, 1e-12) << columns << " x " << rows;
            EXPECT_NEAR((lattice.bounds().max - high).norm(), 0.0, 1e-12) << columns << " x " << rows;
        }
}

TYPED_TEST(LatticeOf, coveringLeavesNoPointOut)
{
    for (std::uint64_t seed = 1; seed <= 2000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double reach = std::pow(10.0, random.real(0.0, 9.0));
        const Point corner = random.pointIn({Point(-reach, -reach), Point(reach, reach)});
        const double pitch = std::max(std::pow(10.0, random.real(-2.0, 2.0)), 1e-7 * reach);
        Box box{corner, corner + pitch * Point(random.real(0.0, 30.0), random.real(0.0, 30.0))};
        if (random.chance(0.2))
            box.max.x() = box.min.x() + 0.5 * pitch * static_cast<double>(random.integer(0, 20));
        if (random.chance(0.2))
            box.max.y() = box.min.y() + 0.5 * pitch / std::sqrt(3.0) * static_cast<double>(random.integer(0, 60));
        const TypeParam lattice = TypeParam::covering(box, pitch);
        for (const double x : {box.min.x(), box.max.x()})
            for (const double y : {box.min.y(), box.max.y()})
                ASSERT_TRUE(isCovered(lattice, {x, y})) << x << ", " << y;
        for (int i = 0; i < 100; ++i)
        {
            Point p = random.pointIn(box);
            if (i % 4 == 0)
                p.x() = random.chance(0.5) ? box.min.x() : box.max.x();
            if (i % 4 == 1)
                p.y() = random.chance(0.5) ? box.min.y() : box.max.y();
            ASSERT_TRUE(isCovered(lattice, p)) << p.transpose();
        }
    }
}

TYPED_TEST(LatticeOf, coveringWastesNoRowAndNoColumn)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Box box{Point(-3.0, 7.0), Point(-3.0 + random.real(0.0, 40.0), 7.0 + random.real(2.0, 40.0))};
        const TypeParam lattice = TypeParam::covering(box, 1.0);
        const TypeParam narrower(lattice.northWest(), 1.0, std::max<std::int64_t>(lattice.columns() - 1, 1),
                                 lattice.rows());
        const TypeParam shorter(lattice.northWest(), 1.0, lattice.columns(), lattice.rows() - 1);
        bool narrowerCovers = narrower.columns() < lattice.columns();
        bool shorterCovers = true;
        for (int i = 0; i <= 400; ++i)
        {
            const Point along = box.min + i / 400.0 * (box.max - box.min);
            narrowerCovers = narrowerCovers && isCovered(narrower, {box.max.x(), along.y()});
            shorterCovers = shorterCovers && isCovered(shorter, {along.x(), box.min.y()});
        }
        EXPECT_FALSE(narrowerCovers) << (box.max - box.min).transpose();
        EXPECT_FALSE(shorterCovers) << (box.max - box.min).transpose();
    }
}

TYPED_TEST(LatticeOf, refusesWhatIsNoLattice)
{
    const Point origin = Point::Zero();
    for (const double pitch : {0.0, -1.0, infinity, notANumber})
    {
        EXPECT_THROW(TypeParam(origin, pitch, 1, 1), std::domain_error) << pitch;
        EXPECT_THROW(TypeParam::covering({origin, Point(1.0, 1.0)}, pitch), std::domain_error) << pitch;
    }
    EXPECT_THROW(TypeParam({0.0, notANumber}, 1.0, 1, 1), std::domain_error);
    EXPECT_THROW(TypeParam({infinity, 0.0}, 1.0, 1, 1), std::domain_error);
    EXPECT_THROW(TypeParam(origin, 1.0, 0, 1), std::domain_error);
    EXPECT_THROW(TypeParam(origin, 1.0, 1, -1), std::domain_error);
    EXPECT_THROW(TypeParam::covering({origin, Point(-1.0, 1.0)}, 1.0), std::domain_error);
    EXPECT_THROW(TypeParam::covering({origin, Point(notANumber, 1.0)}, 1.0), std::domain_error);
    EXPECT_THROW(TypeParam::covering({origin, Point(1e6, 1e6)}, 0.1), std::domain_error) << "10^14 cells";
    EXPECT_THROW(TypeParam::covering({Point(-1e308, 0.0), Point(1e308, 1.0)}, 1.0), std::domain_error);
}

TYPED_TEST(LatticeOf, isEqualToTheSameCellsAtTheSamePlaces)
{
    const TypeParam lattice({3.0, 4.0}, 1.5, 10, 12);
    EXPECT_EQ(lattice, TypeParam({3.0, 4.0}, 1.5, 10, 12));
    EXPECT_NE(lattice, TypeParam({3.0, 4.5}, 1.5, 10, 12));
    EXPECT_NE(lattice, TypeParam({3.0, 4.0}, 1.6, 10, 12));
    EXPECT_NE(lattice, TypeParam({3.0, 4.0}, 1.5, 11, 12));
    EXPECT_NE(lattice, TypeParam({3.0, 4.0}, 1.5, 10, 11));
}
