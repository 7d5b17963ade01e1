#include <seahex/world/ScanlineFill.h>

#include "support/AsciiWorld.h"
#include "support/LatticeKinds.h"
#include "support/RandomShapes.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

#include <boost/geometry/geometry.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

template <class Cell>
bool isSet(const CellBits &bits, Cell cell)
{
    const CellIndex index = bits.layout().index(cell);
    return ((bits.words()[index >> 6] >> (index & 63)) & 1) != 0;
}

std::string pictureOf(const HexLattice &lattice, const CellBits &bits)
{
    return toPicture(HexOccupancy(lattice, bits.layout(), bits.words()));
}

Ring ringOf(std::initializer_list<Point> points)
{
    Ring ring(points.begin(), points.end());
    ring.push_back(ring.front());
    return ring;
}

template <class LatticeType>
class ScanlineFillOf : public ::testing::Test
{
};

TYPED_TEST_SUITE(ScanlineFillOf, LatticeKinds, LatticeKindNames);

}  // namespace

TYPED_TEST(ScanlineFillOf, setsTheCentresInsideAndNoOthers)
{
    for (std::uint64_t seed = 1; seed <= 1500; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double pitch = random.real(0.1, 10.0);
        const TypeParam lattice({random.real(-50, 50), random.real(-50, 50)}, pitch, random.integer(1, 90),
                                random.integer(1, 20));
        ScanlineFill fill(lattice);
        // two polygons, one after the other, with the same buffers
        for (int i = 0; i < 2; ++i)
        {
            const Point centre = random.pointIn(lattice.bounds());
            Polygon area = randomArea(random, centre, pitch * random.real(0.5, 30.0), random.chance(0.5));
            CellBits bits(CellLayout(lattice.columns(), lattice.rows()));
            fill.fill(area, bits);
            const CellOracle<TypeParam> oracle(lattice);
            boost::geometry::correct(area);
            forEachCell(lattice, 0,
                        [&](typename TypeParam::Cell cell)
                        {
                            const bool inside = boost::geometry::within(lattice.centre(cell), area);
                            ASSERT_EQ(oracle.isCentreInside(area, cell), inside) << "the oracles disagree";
                            ASSERT_EQ(isSet(bits, cell), inside) << lattice.centre(cell).transpose();
                        });
        }
    }
}

TYPED_TEST(ScanlineFillOf, cutsWhatReachesBeyondTheLattice)
{
    const TypeParam lattice(Point::Zero(), 1.0, 70, 8);
    const CellLayout layout(70, 8);
    Polygon around;
    around.outer() = ringOf({Point(-1e6, -1e6), Point(1e6, -1e6), Point(1e6, 1e6), Point(-1e6, 1e6)});
    CellBits bits(layout);
    ScanlineFill(lattice).fill(around, bits);
    forEachCell(lattice, CellLayout::frame,
                [&](typename TypeParam::Cell cell)
                { ASSERT_EQ(isSet(bits, cell), lattice.contains(cell)) << "the frame is not written"; });

    CellBits none(layout);
    for (const Point &shift : {Point(500, 0), Point(-500, 0), Point(0, 500), Point(0, -500)})
    {
        Polygon elsewhere;
        elsewhere.outer() = ringOf({Point(shift + Point(-90, -90)), Point(shift + Point(90, -90)),
                                    Point(shift + Point(90, 90)), Point(shift + Point(-90, 90))});
        ScanlineFill(lattice).fill(elsewhere, none);
    }
    EXPECT_EQ(none.words(), CellBits(layout).words());
}

TEST(ScanlineFill, holesStayOpenWhateverTheirOrientation)
{
    const HexLattice lattice(Point::Zero(), 1.0, 7, 7);
    Ring outer = ringOf({Point(1.1, -6.1), Point(6.9, -6.1), Point(6.9, -1.0), Point(1.1, -1.0)});
    Ring hole = ringOf({Point(3, -4.5), Point(5, -4.5), Point(5, -2.5), Point(3, -2.5)});
    std::string first;
    for (int i = 0; i < 4; ++i)
    {
        Polygon area;
        area.outer() = outer;
        area.inners() = {hole};
        CellBits bits(CellLayout(7, 7));
        ScanlineFill(lattice).fill(area, bits);
        first = i == 0 ? pictureOf(lattice, bits) : first;
        EXPECT_EQ(pictureOf(lattice, bits), first);
        EXPECT_FALSE(isSet(bits, lattice.cellAt({4.0, -3.5})));
        EXPECT_TRUE(isSet(bits, lattice.cellAt({2.0, -3.5})));
        std::reverse(outer.begin(), outer.end());
        if (i == 1)
            std::reverse(hole.begin(), hole.end());
    }
}

TYPED_TEST(ScanlineFillOf, ringsThatCrossThemselvesFillTooMuchRatherThanTooLittle)
{
    // an hourglass: both lobes, though they wind in opposite directions
    const TypeParam lattice(Point::Zero(), 1.0, 20, 20);
    Polygon hourglass;
    hourglass.outer() = ringOf({Point(3, -3), Point(15, -3), Point(3, -14), Point(15, -14)});
    CellBits bits(CellLayout(20, 20));
    ScanlineFill(lattice).fill(hourglass, bits);
    EXPECT_TRUE(isSet(bits, lattice.cellAt({9.0, -4.5})));
    EXPECT_TRUE(isSet(bits, lattice.cellAt({9.0, -12.5})));
    EXPECT_FALSE(isSet(bits, lattice.cellAt({4.0, -8.5})));

    // a pentagram: its middle, which is wound around twice
    Polygon pentagram;
    for (int i = 0; i <= 5; ++i)
        pentagram.outer().push_back(Point(10, -9) + 7.0 * Point(std::sin(0.8 * M_PI * i), std::cos(0.8 * M_PI * i)));
    pentagram.outer().back() = pentagram.outer().front();
    CellBits star(CellLayout(20, 20));
    ScanlineFill(lattice).fill(pentagram, star);
    EXPECT_TRUE(isSet(star, lattice.cellAt({10.0, -9.0})));

    for (std::uint64_t seed = 1; seed <= 500; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        Polygon area;
        area.outer() = crossedRing(random, lattice.bounds());
        CellBits crossed(CellLayout(20, 20));
        ScanlineFill(lattice).fill(area, crossed);
        const CellOracle<TypeParam> oracle(lattice);
        forEachCell(lattice, 0,
                    [&](typename TypeParam::Cell cell)
                    { ASSERT_TRUE(isSet(crossed, cell) || !oracle.isCentreInside(area, cell)); });
    }
}

TYPED_TEST(ScanlineFillOf, degenerateRingsFillNothing)
{
    const TypeParam lattice(Point::Zero(), 1.0, 10, 10);
    CellBits bits(CellLayout(10, 10));
    ScanlineFill fill(lattice);
    Polygon area;
    fill.fill(area, bits);
    area.outer() = {Point(3.3, -3.2)};
    fill.fill(area, bits);
    area.outer() = {Point(3.3, -3.2), Point(3.3, -3.2)};
    fill.fill(area, bits);
    area.outer() = {Point(3.3, -3.2), Point(7.1, -3.2), Point(3.3, -3.2)};
    fill.fill(area, bits);
    EXPECT_EQ(bits.words(), CellBits(CellLayout(10, 10)).words());
}

TYPED_TEST(ScanlineFillOf, verticesOnRowsOfCentresCountOnce)
{
    // corners and level edges exactly on the rows' centre lines
    const TypeParam lattice(Point::Zero(), 2.0, 12, 12);
    for (std::uint64_t seed = 1; seed <= 1000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const Point middle = lattice.centre(TypeParam::cell({6, 6}));
        const auto level = [&](std::int64_t row)
        {
            return lattice.centre(TypeParam::cell({0, row})).y();
        };
        const double west = middle.x() - random.real(1.0, 9.0);
        const double east = middle.x() + random.real(1.0, 9.0);
        Polygon area;
        // a diamond with a step, every corner on a row's line
        area.outer() =
            ringOf({Point(west, level(random.integer(5, 7))), Point(middle.x(), level(random.integer(8, 12))),
                    Point(east, level(7)), Point(east - 0.9, level(6)), Point(east, level(6)),
                    Point(middle.x(), level(random.integer(-2, 4)))});
        CellBits bits(CellLayout(12, 12));
        ScanlineFill(lattice).fill(area, bits);
        const CellOracle<TypeParam> oracle(lattice);
        forEachCell(lattice, 0,
                    [&](typename TypeParam::Cell cell)
                    {
                        // centres on an edge may fall either way
                        double gap = 1e9;
                        for (std::size_t i = 1; i < area.outer().size(); ++i)
                        {
                            const LineString edge{area.outer()[i - 1], area.outer()[i]};
                            gap = std::min(gap, boost::geometry::distance(lattice.centre(cell), edge));
                        }
                        ASSERT_TRUE(gap < 1e-9 || isSet(bits, cell) == oracle.isCentreInside(area, cell));
                    });
    }
}
