#include <seahex/geometry/HexChords.h>
#include <seahex/geometry/Shape.h>

#include "support/HexOracle.h"
#include "support/Property.h"
#include "support/Random.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include <boost/geometry.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace bg = boost::geometry;

namespace
{

using Lengths = std::map<HexCoord, double>;

Lengths chordsOf(const HexLattice &lattice, const Point &a, const Point &b)
{
    Lengths lengths;
    forEachChord(lattice, a, b, [&lengths](HexCoord cell, double length) { lengths[cell] += length; });
    return lengths;
}

double lengthIn(const Lengths &lengths, HexCoord cell)
{
    const auto found = lengths.find(cell);
    return found == lengths.end() ? 0.0 : found->second;
}

/// The part of a segment in one hexagon: cut off by its six edges one after the other, in long double. Half of it where
/// it runs along an edge.
double chordByClipping(const HexLattice &lattice, const Point &a, const Point &b, HexCoord cell)
{
    const HexOracle::Vector centre = HexOracle(lattice).centre(cell);
    const auto pitch = static_cast<long double>(lattice.pitch());
    const long double length =
        std::hypot(b.x() - static_cast<long double>(a.x()), b.y() - static_cast<long double>(a.y()));
    long double from = 0.0L;
    long double to = 1.0L;
    bool isAlongEdge = false;
    for (int side = 0; side < 6; ++side)
    {
        // how far beyond this edge's line the two ends are
        const long double angle = side * std::acos(-1.0L) / 3.0L;
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
double chordByBoost(const HexLattice &lattice, const Point &a, const Point &b, HexCoord cell)
{
    Polygon hexagon;
    for (const Point &corner : lattice.corners(cell))
        hexagon.outer().push_back(corner);
    hexagon.outer().push_back(hexagon.outer().front());
    bg::correct(hexagon);
    bg::model::multi_linestring<LineString> parts;
    bg::intersection(LineString{a, b}, hexagon, parts);
    return bg::length(parts);
}

/// Compares all cells around a segment, and the sum.
void expectSameChords(const HexLattice &lattice, const Point &a, const Point &b, double tolerance)
{
    const Lengths lengths = chordsOf(lattice, a, b);
    double sum = 0.0;
    for (const auto &[cell, length] : lengths)
    {
        EXPECT_GT(length, 0.0);
        sum += length;
        EXPECT_NEAR(length, chordByClipping(lattice, a, b, cell), tolerance) << "cell " << cell.q << ", " << cell.s;
    }
    // what adds up to the whole misses no cell
    EXPECT_NEAR(sum, (b - a).norm(), tolerance);
}

}  // namespace

TEST(HexChords, halfOfAStepLiesInEitherCell)
{
    const HexLattice lattice({3.0, -2.0}, 2.0, 9, 9);
    const HexCoord cell{2, 3};
    for (const HexCoord step :
         {HexCoord{1, 0}, HexCoord{0, 1}, HexCoord{-1, 1}, HexCoord{-1, 0}, HexCoord{0, -1}, HexCoord{1, -1}})
    {
        const Lengths lengths = chordsOf(lattice, lattice.centre(cell), lattice.centre(cell + step));
        ASSERT_EQ(lengths.size(), 2u);
        EXPECT_NEAR(lengthIn(lengths, cell), 1.0, 1e-12);
        EXPECT_NEAR(lengthIn(lengths, cell + step), 1.0, 1e-12);
    }
}

TEST(HexChords, betweenTwoCellsAnEdgeIsShared)
{
    // a jump over the edge of two neighbours: a side within each end's cell, a side along the edge
    const HexLattice lattice({3.0, -2.0}, 2.0, 9, 9);
    const HexCoord cell{2, 3};
    const Lengths lengths = chordsOf(lattice, lattice.centre(cell), lattice.centre(cell + HexCoord{1, 1}));
    ASSERT_EQ(lengths.size(), 4u);
    EXPECT_NEAR(lengthIn(lengths, cell), lattice.side(), 1e-12);
    EXPECT_NEAR(lengthIn(lengths, cell + HexCoord{1, 1}), lattice.side(), 1e-12);
    EXPECT_NEAR(lengthIn(lengths, cell + HexCoord{1, 0}), 0.5 * lattice.side(), 1e-12);
    EXPECT_NEAR(lengthIn(lengths, cell + HexCoord{0, 1}), 0.5 * lattice.side(), 1e-12);
}

TEST(HexChords, noLengthNoPieces)
{
    const HexLattice lattice({0.0, 0.0}, 1.0, 9, 9);
    EXPECT_TRUE(chordsOf(lattice, {3.0, -3.0}, {3.0, -3.0}).empty());
    EXPECT_TRUE(chordsOf(lattice, lattice.centre({2, 2}), lattice.centre({2, 2})).empty());
}

TEST(HexChords, everySegmentBetweenPointsOfAFineGrid)
{
    // Quarters of the width and the side: centres, corners, middles of edges, and points between, so that a large part
    // of the segments runs along edges or through corners. From one cell and its surroundings to all within two cells.
    const HexLattice lattice({-1.0, 2.0}, 1.5, 9, 9);
    const HexCoord middle{3, 4};
    const auto at = [&](int x, int y)
    {
        return Point(lattice.centre(middle) + Point(0.25 * x * lattice.pitch(), 0.25 * y * lattice.side()));
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
                    const HexChords chords(lattice, at(ax, ay), at(bx, by));
                    for (HexChords walk = chords; walk.next();)
                        along += walk.left() == walk.right() ? 0 : 1;
                }
    EXPECT_GT(along, 100) << "segments along edges";
}

TEST(HexChords, randomSegmentsOfAllSizes)
{
    for (std::uint64_t seed = 1; seed <= 3000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double pitch = std::pow(10.0, random.real(-3.0, 3.0));
        const HexLattice lattice({pitch * random.real(-100, 100), pitch * random.real(-100, 100)}, pitch, 40, 40);
        const double reach = pitch * std::pow(10.0, random.real(-2.0, 1.3));
        const Point a = random.pointOf(lattice, random.cellOf(lattice));
        Point b = a + reach * random.pointIn({Point(-1, -1), Point(1, 1)});
        if (seed % 3 == 0)
            b = random.pointOf(lattice, random.cellOf(lattice));
        expectSameChords(lattice, a, b, 1e-9 * 100 * pitch);
        ASSERT_FALSE(::testing::Test::HasFailure());
    }
}

TEST(HexChords, randomSegmentsByBoost)
{
    for (std::uint64_t seed = 1; seed <= 1000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice({random.real(-9, 9), random.real(-9, 9)}, random.real(0.5, 5.0), 20, 20);
        const Box box = lattice.bounds();
        const Point a = random.pointIn(box);
        const Point b = random.pointIn(box);
        for (const auto &[cell, length] : chordsOf(lattice, a, b))
            ASSERT_NEAR(length, chordByBoost(lattice, a, b, cell), 1e-7) << "cell " << cell.q << ", " << cell.s;
    }
}

TEST(HexChords, theSamePiecesInTheSameOrderBackwards)
{
    for (std::uint64_t seed = 1; seed <= 2000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice({random.real(-1e4, 1e4), random.real(-1e4, 1e4)}, random.real(0.1, 10.0), 30, 30);
        const Point a = random.pointOf(lattice, random.cellOf(lattice));
        Point b = random.pointOf(lattice, random.cellOf(lattice));
        if (seed % 4 == 0)
            b.y() = a.y();
        HexChords there(lattice, a, b);
        HexChords back(lattice, b, a);
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

TEST(HexChords, propertyCuttingASegmentInTwoChangesNoLength)
{
    checkProperty(3000,
                  []
                  {
                      const HexLattice lattice({*rc::gen::inRange(-9, 10) * 0.7, 1.0}, 1.4, 12, 12);
                      // halves of width and side: many segments along edges
                      const auto point = [&lattice]
                      {
                          const double x = 0.5 * lattice.pitch() * *rc::gen::inRange(0, 20);
                          return Point(lattice.northWest() +
                                       Point(x, -0.5 * lattice.side() * *rc::gen::inRange(0, 40)));
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

TEST(HexChords, longSegments)
{
    // 10^5 cells: the sum, and no end of time
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice({-1e5, 1e5}, 3.0, 10, 10);
        const Point a(random.real(-1e5, 1e5), random.real(-1e5, 1e5));
        const Point b(random.real(-1e5, 1e5), random.real(-1e5, 1e5));
        double sum = 0.0;
        forEachChord(lattice, a, b, [&sum](HexCoord, double length) { sum += length; });
        EXPECT_NEAR(sum / (b - a).norm(), 1.0, 1e-12);
    }
}
