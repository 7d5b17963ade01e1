#include <seahex/geometry/HexLattice.h>
#include <seahex/geometry/Shape.h>

#include "support/HexOracle.h"
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

const double infinity = std::numeric_limits<double>::infinity();
const double notANumber = std::numeric_limits<double>::quiet_NaN();

double largestCoordinate(const HexLattice &lattice, const Point &p)
{
    return std::max({p.cwiseAbs().maxCoeff(), lattice.northWest().cwiseAbs().maxCoeff(), lattice.pitch()});
}

/// Lattices near the origin and far from it, of all sizes of cells.
HexLattice randomLattice(Random &random)
{
    const double reach = std::pow(10.0, random.real(0.0, 9.0));
    const double pitch = std::max(std::pow(10.0, random.real(-3.0, 3.0)), 1e-7 * reach);
    const Box box{Point(-reach, -reach), Point(reach, reach)};
    return {random.pointIn(box), pitch, random.integer(1, 50), random.integer(1, 50)};
}

Polygon outline(const HexLattice &lattice, HexCoord cell)
{
    Polygon polygon;
    for (const Point &corner : lattice.corners(cell))
        polygon.outer().push_back(corner);
    polygon.outer().push_back(polygon.outer().front());
    return polygon;
}

bool isCovered(const HexLattice &lattice, const Point &p)
{
    // the nearest cells may meet in a point of the border: any of them will do
    const HexCoord cell = lattice.cellAt(p);
    for (std::int64_t q = -1; q <= 1; ++q)
        for (std::int64_t s = -1; s <= 1; ++s)
            if (lattice.contains(cell + HexCoord{q, s}) &&
                lattice.distance(p, cell + HexCoord{q, s}) <= 1e-9 * largestCoordinate(lattice, p))
                return true;
    return false;
}

}  // namespace

TEST(HexLattice, publishedScenario)
{
    // [Cheng2020] section 3: cell width root 3 * 0.002 degrees, 143 x 159 cells south-east of 21.98 N 112.50 E
    const HexLattice lattice({112.50, 21.98}, std::sqrt(3.0) * 0.002, 143, 159);
    EXPECT_EQ(toOffset(lattice.cellAt({112.521, 21.635})), (OffsetCoord{5, 114}));
    EXPECT_EQ(toOffset(lattice.cellAt({112.901, 21.669})), (OffsetCoord{115, 103}));
    EXPECT_NEAR(lattice.side(), 0.002, 1e-15);
    EXPECT_EQ(lattice.cellCount(), 143 * 159);
}

TEST(HexLattice, cellsLieAsDrawn)
{
    const HexLattice lattice({10.0, 20.0}, 2.0, 4, 3);
    const double side = 2.0 / std::sqrt(3.0);
    // row 0 is the northernmost and shifted east; row 1 begins at the western edge
    EXPECT_NEAR((lattice.centre(toCube({0, 0})) - Point(12.0, 20.0 - side)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((lattice.centre(toCube({0, 1})) - Point(11.0, 20.0 - 2.5 * side)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((lattice.centre(toCube({3, 2})) - Point(18.0, 20.0 - 4.0 * side)).norm(), 0.0, 1e-12);
    EXPECT_TRUE(lattice.contains(toCube({3, 2})));
    EXPECT_FALSE(lattice.contains(toCube({4, 2})));
    EXPECT_FALSE(lattice.contains(toCube({3, 3})));
    EXPECT_FALSE(lattice.contains(toCube({-1, 1})));
    EXPECT_FALSE(lattice.contains(toCube({0, -1})));
}

TEST(HexLattice, cellOfItsOwnCentre)
{
    for (const Point &northWest : {Point(0.0, 0.0), Point(1e9, -1e9), Point(-1e9, 1e9), Point(112.5, 21.98)})
        for (const double pitch : {std::sqrt(3.0) * 0.002, 1.0, 20.0, 1852.0})
        {
            if (pitch < 1e-8 * northWest.cwiseAbs().maxCoeff())
                continue;  // such cells are smaller than what doubles are promised to tell apart
            const HexLattice lattice(northWest, pitch, 1, 1);
            for (std::int64_t q = -40; q <= 40; ++q)
                for (std::int64_t s = -40; s <= 40; ++s)
                    ASSERT_EQ(lattice.cellAt(lattice.centre({q, s})), (HexCoord{q, s})) << pitch;
        }
}

TEST(HexLattice, everyPointLiesInItsCell)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice = randomLattice(random);
        const HexOracle oracle(lattice);
        const double reach = lattice.northWest().cwiseAbs().maxCoeff() + 100.0 * lattice.pitch();
        for (int i = 0; i < 200; ++i)
        {
            const Point p = i % 2 == 0 ? random.pointIn({Point(-reach, -reach), Point(reach, reach)})
                                       : random.pointOf(lattice, random.cellOf(lattice));
            ASSERT_LE(oracle.distance(p, lattice.cellAt(p)), 1e-9L * largestCoordinate(lattice, p)) << p.transpose();
        }
    }
}

TEST(HexLattice, edgesAndCornersBelongToACellThatMeetsThere)
{
    const HexLattice lattice({112.50, 21.98}, std::sqrt(3.0) * 0.002, 143, 159);
    for (std::int64_t row = 0; row < 12; ++row)
        for (std::int64_t column = 0; column < 12; ++column)
        {
            const HexCoord cell = toCube({column, row});
            const auto corners = lattice.corners(cell);
            for (std::size_t i = 0; i < 6; ++i)
            {
                const Point midway = 0.5 * (corners[i] + corners[(i + 1) % 6]);
                for (const Point &p : {corners[i], midway})
                {
                    ASSERT_LE(hexDistance(lattice.cellAt(p), cell), 1);
                    ASSERT_LE(lattice.distance(p, lattice.cellAt(p)), 1e-9 * 112.5);
                }
                // a little towards the centre, and it is this cell
                ASSERT_EQ(lattice.cellAt(corners[i] + 1e-6 * (lattice.centre(cell) - corners[i])), cell);
                ASSERT_EQ(lattice.cellAt(midway + 1e-6 * (lattice.centre(cell) - midway)), cell);
            }
        }
}

TEST(HexLattice, pointsBeyondAllCellsAreOutside)
{
    const HexLattice lattice(Point::Zero(), 1.0, 4, 4);
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

TEST(HexLattice, cornersAreARegularHexagonCounterClockwiseFromNorth)
{
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice = randomLattice(random);
        const HexCoord cell = random.cellOf(lattice);
        const auto corners = lattice.corners(cell);
        const double rounding = 1e-14 * largestCoordinate(lattice, lattice.centre(cell));
        EXPECT_NEAR((corners[0] - lattice.centre(cell) - Point(0.0, lattice.side())).norm(), 0.0, rounding);
        for (std::size_t i = 0; i < 6; ++i)
        {
            EXPECT_NEAR((corners[i] - lattice.centre(cell)).norm(), lattice.side(), rounding);
            EXPECT_NEAR((corners[i] - corners[(i + 1) % 6]).norm(), lattice.side(), rounding);
        }
        const double area = boost::geometry::area(outline(lattice, cell));
        const double expected = 0.5 * std::sqrt(3.0) * lattice.pitch() * lattice.pitch();
        EXPECT_NEAR(area, expected, 1e-3 * expected);  // positive: counter-clockwise
    }
}

TEST(HexLattice, neighboursShareTheirEdges)
{
    const HexLattice lattice({3.0, 4.0}, 1.5, 10, 10);
    for (const HexCoord step : {HexCoord{1, 0}, HexCoord{1, -1}, HexCoord{0, -1}})
    {
        int shared = 0;
        for (const Point &corner : lattice.corners({2, 5}))
            for (const Point &other : lattice.corners(HexCoord{2, 5} + step))
                shared += (corner - other).norm() < 1e-12 ? 1 : 0;
        EXPECT_EQ(shared, 2);
    }
}

TEST(HexLattice, distanceIsThatToThePolygonOfTheCorners)
{
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice({random.real(-100, 100), random.real(-100, 100)}, random.real(0.1, 10.0), 5, 5);
        const HexCoord cell = random.cellOf(lattice);
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

TEST(HexLattice, boundsAreThoseOfAllCells)
{
    for (const std::int64_t rows : {1, 2, 3, 8})
        for (const std::int64_t columns : {1, 2, 7})
        {
            const HexLattice lattice({-5.0, 9.0}, 0.7, columns, rows);
            Point low(infinity, infinity);
            Point high(-infinity, -infinity);
            forEachCell(lattice, 0,
                        [&](HexCoord cell)
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

TEST(HexLattice, coveringLeavesNoPointOut)
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
        const HexLattice lattice = HexLattice::covering(box, pitch);
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

TEST(HexLattice, coveringWastesNoRowAndNoColumn)
{
    for (std::uint64_t seed = 1; seed <= 200; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Box box{Point(-3.0, 7.0), Point(-3.0 + random.real(0.0, 40.0), 7.0 + random.real(2.0, 40.0))};
        const HexLattice lattice = HexLattice::covering(box, 1.0);
        const HexLattice narrower(lattice.northWest(), 1.0, std::max<std::int64_t>(lattice.columns() - 1, 1),
                                  lattice.rows());
        const HexLattice shorter(lattice.northWest(), 1.0, lattice.columns(), lattice.rows() - 1);
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

TEST(HexLattice, refusesWhatIsNoLattice)
{
    const Point origin = Point::Zero();
    for (const double pitch : {0.0, -1.0, infinity, notANumber})
    {
        EXPECT_THROW(HexLattice(origin, pitch, 1, 1), std::domain_error) << pitch;
        EXPECT_THROW(HexLattice::covering({origin, Point(1.0, 1.0)}, pitch), std::domain_error) << pitch;
    }
    EXPECT_THROW(HexLattice({0.0, notANumber}, 1.0, 1, 1), std::domain_error);
    EXPECT_THROW(HexLattice({infinity, 0.0}, 1.0, 1, 1), std::domain_error);
    EXPECT_THROW(HexLattice(origin, 1.0, 0, 1), std::domain_error);
    EXPECT_THROW(HexLattice(origin, 1.0, 1, -1), std::domain_error);
    EXPECT_THROW(HexLattice::covering({origin, Point(-1.0, 1.0)}, 1.0), std::domain_error);
    EXPECT_THROW(HexLattice::covering({origin, Point(notANumber, 1.0)}, 1.0), std::domain_error);
    EXPECT_THROW(HexLattice::covering({origin, Point(1e6, 1e6)}, 0.1), std::domain_error) << "10^14 cells";
    EXPECT_THROW(HexLattice::covering({Point(-1e308, 0.0), Point(1e308, 1.0)}, 1.0), std::domain_error);
}
