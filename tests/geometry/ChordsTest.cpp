#include <seahex/geometry/Chords.h>
#include <seahex/geometry/Shape.h>

#include "support/CellOutline.h"
#include "support/LatticeKinds.h"
#include "support/Property.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

#include <boost/geometry.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace bg = boost::geometry;

namespace
{

template <class LatticeType>
class ChordsOf : public testing::Test
{
};
TYPED_TEST_SUITE(ChordsOf, LatticeKinds, LatticeKindNames);

using Lengths = std::map<OffsetCoord, double>;

Lengths chordsOf(const Lattice &lattice, const Point &a, const Point &b)
{
    Lengths lengths;
    forEachChord(lattice, a, b, [&lengths](OffsetCoord cell, double length) { lengths[cell] += length; });
    return lengths;
}

double lengthIn(const Lengths &lengths, OffsetCoord cell)
{
    const auto found = lengths.find(cell);
    return found == lengths.end() ? 0.0 : found->second;
}

/// The part of a segment in one cell: cut off by its edges one after the other, in long double. Half of it where it
/// runs along an edge.
template <class LatticeType>
double chordByClipping(const LatticeType &lattice, const Point &a, const Point &b, OffsetCoord cell)
{
    constexpr int sides = std::is_same_v<LatticeType, HexLattice> ? 6 : 4;
    const LongVector centre = CellOracle<LatticeType>(lattice).centre(LatticeType::cell(cell));
    const auto pitch = static_cast<long double>(lattice.pitch());
    const long double length =
        std::hypot(b.x() - static_cast<long double>(a.x()), b.y() - static_cast<long double>(a.y()));
    long double from = 0.0L;
    long double to = 1.0L;
    bool isAlongEdge = false;
    for (int side = 0; side < sides; ++side)
    {
        // how far beyond this edge's line the two ends are
        const long double angle = side * 2.0L * std::acos(-1.0L) / sides;
        const auto beyond = [&](const Point &p)
        {
            return std::cos(angle) * (p.x() - centre.x) + std::sin(angle) * (p.y() - centre.y) - 0.5L * pitch;
        };
        const long double atA = beyond(a);
        const long double atB = beyond(b);
        if (std::abs(atA) < 1e-9L * pitch && std::abs(atB) < 1e-9L * pitch)
            isAlongEdge = true;
        else if (atA > 0.0L && atB > 0.0L)
            return 0.0;
        else if (atA > 0.0L)
            from = std::max(from, atA / (atA - atB));
        else if (atB > 0.0L)
            to = std::min(to, atA / (atA - atB));
    }
    return static_cast<double>(std::max(0.0L, to - from) * length * (isAlongEdge ? 0.5L : 1.0L));
}

/// The same by Boost.Geometry, for segments that run along no edge.
template <class LatticeType>
double chordByBoost(const LatticeType &lattice, const Point &a, const Point &b, OffsetCoord cell)
{
    Polygon polygon = outline(lattice, LatticeType::cell(cell));
    bg::correct(polygon);
    bg::model::multi_linestring<LineString> parts;
    bg::intersection(LineString{a, b}, polygon, parts);
    return bg::length(parts);
}

/// Compares all cells around a segment, and the sum.
template <class LatticeType>
void expectSameChords(const LatticeType &lattice, const Point &a, const Point &b, double tolerance)
{
    const Lengths lengths = chordsOf(lattice, a, b);
    double sum = 0.0;
    for (const auto &[cell, length] : lengths)
    {
        EXPECT_GT(length, 0.0);
        sum += length;
        EXPECT_NEAR(length, chordByClipping(lattice, a, b, cell), tolerance)
            << "cell " << cell.column << ", " << cell.row;
    }
    // what adds up to the whole misses no cell
    EXPECT_NEAR(sum, (b - a).norm(), tolerance);
}

}  // namespace

TYPED_TEST(ChordsOf, halfOfAStepLiesInEitherCell)
{
    const Lattice lattice = TypeParam({3.0, -2.0}, 2.0, 9, 9);
    for (const OffsetCoord cell : {OffsetCoord{2, 3}, {3, 2}})
        for (const OffsetCoord neighbour : lattice.neighbours(cell))
        {
            const Point a = lattice.centre(cell);
            const Point b = lattice.centre(neighbour);
            const Lengths lengths = chordsOf(lattice, a, b);
            ASSERT_EQ(lengths.size(), 2u);
            EXPECT_NEAR(lengthIn(lengths, cell), 0.5 * (b - a).norm(), 1e-12);
            EXPECT_NEAR(lengthIn(lengths, neighbour), 0.5 * (b - a).norm(), 1e-12);
        }
}

TEST(Chords, betweenTwoHexagonsAnEdgeIsShared)
{
    // a jump over the edge of two neighbours: a side within each end's cell, a side along the edge
    const HexLattice lattice({3.0, -2.0}, 2.0, 9, 9);
    const HexCoord cell{2, 3};
    const Lengths lengths = chordsOf(lattice, lattice.centre(cell), lattice.centre(cell + HexCoord{1, 1}));
    const auto lengthOf = [&](HexCoord c)
    {
        return lengthIn(lengths, toOffset(c));
    };
    ASSERT_EQ(lengths.size(), 4u);
    EXPECT_NEAR(lengthOf(cell), lattice.side(), 1e-12);
    EXPECT_NEAR(lengthOf(cell + HexCoord{1, 1}), lattice.side(), 1e-12);
    EXPECT_NEAR(lengthOf(cell + HexCoord{1, 0}), 0.5 * lattice.side(), 1e-12);
    EXPECT_NEAR(lengthOf(cell + HexCoord{0, 1}), 0.5 * lattice.side(), 1e-12);
}

TEST(Chords, betweenTwoSquaresAnEdgeIsShared)
{
    // along two edges and a half, level and upright
    const SquareLattice lattice({3.0, -2.0}, 2.0, 9, 9);
    const Point corner = lattice.corners({4, 4})[0];
    const auto expectLengths = [&](const Point &end, const Lengths &expected)
    {
        const Lengths lengths = chordsOf(lattice, corner, end);
        ASSERT_EQ(lengths.size(), expected.size());
        for (const auto &[cell, length] : expected)
            EXPECT_NEAR(lengthIn(lengths, cell), length, 1e-12) << "cell " << cell.column << ", " << cell.row;
    };
    expectLengths(corner + Point(5.0, 0.0),
                  {{{4, 3}, 1.0}, {{5, 3}, 1.0}, {{6, 3}, 0.5}, {{4, 4}, 1.0}, {{5, 4}, 1.0}, {{6, 4}, 0.5}});
    expectLengths(corner - Point(0.0, 3.0), {{{3, 4}, 1.0}, {{4, 4}, 1.0}, {{3, 5}, 0.5}, {{4, 5}, 0.5}});
}

TYPED_TEST(ChordsOf, noLengthNoPieces)
{
    const TypeParam lattice({0.0, 0.0}, 1.0, 9, 9);
    EXPECT_TRUE(chordsOf(lattice, {3.0, -3.0}, {3.0, -3.0}).empty());
    const Point centre = lattice.centre(TypeParam::cell({2, 2}));
    EXPECT_TRUE(chordsOf(lattice, centre, centre).empty());
}

TYPED_TEST(ChordsOf, everySegmentBetweenPointsOfAFineGrid)
{
    // A grid of centres, corners, middles of edges, and points between, so that a large part
    // of the segments runs along edges or through corners. From one cell and its surroundings to all within two cells.
    const TypeParam lattice({-1.0, 2.0}, 1.5, 9, 9);
    const Point middle = lattice.centre(TypeParam::cell({5, 4}));
    const Point grid = cornerGrid(lattice);
    const auto at = [&](int x, int y)
    {
        return Point(middle + Point(x * grid.x(), y * grid.y()));
    };
    int along = 0;
    for (int ax = 0; ax <= 3; ++ax)
        for (int ay = 0; ay <= 5; ++ay)
            for (int bx = -8; bx <= 8; ++bx)
                for (int by = -10; by <= 10; ++by)
                {
                    expectSameChords(lattice, at(ax, ay), at(bx, by), 1e-9);
                    ASSERT_FALSE(::testing::Test::HasFailure())
                        << "from " << ax << ", " << ay << " to " << bx << ", " << by;
                    const Chords chords(lattice, at(ax, ay), at(bx, by));
                    for (Chords walk = chords; walk.next();)
                        along += walk.left() == walk.right() ? 0 : 1;
                }
    EXPECT_GT(along, 100) << "segments along edges";
}

TYPED_TEST(ChordsOf, randomSegmentsOfAllSizes)
{
    for (std::uint64_t seed = 1; seed <= 3000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double pitch = std::pow(10.0, random.real(-3.0, 3.0));
        const TypeParam lattice({pitch * random.real(-100, 100), pitch * random.real(-100, 100)}, pitch, 40, 40);
        const double reach = pitch * std::pow(10.0, random.real(-2.0, 1.3));
        const Point a = random.pointOf(lattice, random.cellOf(lattice));
        Point b = a + reach * random.pointIn({Point(-1, -1), Point(1, 1)});
        if (seed % 3 == 0)
            b = random.pointOf(lattice, random.cellOf(lattice));
        expectSameChords(lattice, a, b, 1e-9 * 100 * pitch);
        ASSERT_FALSE(::testing::Test::HasFailure());
    }
}

TYPED_TEST(ChordsOf, randomSegmentsByBoost)
{
    for (std::uint64_t seed = 1; seed <= 1000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice({random.real(-9, 9), random.real(-9, 9)}, random.real(0.5, 5.0), 20, 20);
        const Box box = lattice.bounds();
        const Point a = random.pointIn(box);
        const Point b = random.pointIn(box);
        for (const auto &[cell, length] : chordsOf(lattice, a, b))
            ASSERT_NEAR(length, chordByBoost(lattice, a, b, cell), 1e-7) << "cell " << cell.column << ", " << cell.row;
    }
}

TYPED_TEST(ChordsOf, theSamePiecesInTheSameOrderBackwards)
{
    for (std::uint64_t seed = 1; seed <= 2000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice({random.real(-1e4, 1e4), random.real(-1e4, 1e4)}, random.real(0.1, 10.0), 30, 30);
        const Point a = random.pointOf(lattice, random.cellOf(lattice));
        Point b = random.pointOf(lattice, random.cellOf(lattice));
        if (seed % 4 == 0)
            b.y() = a.y();
        Chords there(lattice, a, b);
        Chords back(lattice, b, a);
        while (there.next())
        {
            ASSERT_TRUE(back.next());
            ASSERT_EQ(there.left(), back.left());
            ASSERT_EQ(there.right(), back.right());
            ASSERT_EQ(there.length(), back.length());
        }
        ASSERT_FALSE(back.next());
    }
}

TYPED_TEST(ChordsOf, propertyCuttingASegmentInTwoChangesNoLength)
{
    checkProperty(3000,
                  []
                  {
                      const TypeParam lattice({*rc::gen::inRange(-9, 10) * 0.7, 1.0}, 1.4, 12, 12);
                      // many segments along edges
                      const auto point = [&lattice]
                      {
                          const Point grid = 2.0 * cornerGrid(lattice);
                          const double x = grid.x() * *rc::gen::inRange(0, 20);
                          return Point(lattice.northWest() + Point(x, -grid.y() * *rc::gen::inRange(0, 40)));
                      };
                      const Point a = point();
                      const Point b = point();
                      const Point cut = a + *rc::gen::inRange(0, 101) / 100.0 * (b - a);
                      Lengths parts = chordsOf(lattice, a, cut);
                      for (const auto &[cell, length] : chordsOf(lattice, cut, b))
                          parts[cell] += length;
                      const Lengths whole = chordsOf(lattice, a, b);
                      for (const auto &[cell, length] : parts)
                          RC_ASSERT(std::abs(length - lengthIn(whole, cell)) < 1e-7);
                      for (const auto &[cell, length] : whole)
                          RC_ASSERT(std::abs(length - lengthIn(parts, cell)) < 1e-7);
                  });
}

TYPED_TEST(ChordsOf, longSegments)
{
    // 10^5 cells: the sum, and no end of time
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice({-1e5, 1e5}, 3.0, 10, 10);
        const Point a(random.real(-1e5, 1e5), random.real(-1e5, 1e5));
        const Point b(random.real(-1e5, 1e5), random.real(-1e5, 1e5));
        double sum = 0.0;
        forEachChord(lattice, a, b, [&sum](OffsetCoord, double length) { sum += length; });
        EXPECT_NEAR(sum / (b - a).norm(), 1.0, 1e-12);
    }
}
