#include <seahex/geometry/HexTraversal.h>

#include "support/HexOracle.h"
#include "support/Property.h"
#include "support/Random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

using Wide = boost::multiprecision::checked_int256_t;

std::vector<HexCoord> touchedCells(HexCoord a, HexCoord b)
{
    std::vector<HexCoord> cells;
    forEachTouchedCell(a, b,
                       [&cells](HexCoord cell)
                       {
                           cells.push_back(cell);
                           return true;
                       });
    return cells;
}

std::vector<HexCoord> touchedCells(const HexLattice &lattice, const Point &a, const Point &b)
{
    std::vector<HexCoord> cells;
    forEachTouchedCell(lattice, a, b,
                       [&cells](HexCoord cell)
                       {
                           cells.push_back(cell);
                           return true;
                       });
    return cells;
}

std::vector<HexCoord> cellsOf(const SegmentSpans &spans)
{
    std::vector<HexCoord> cells;
    for (std::int64_t row = spans.firstRow(); row <= spans.lastRow(); ++row)
    {
        const RowSpan span = spans.span(row);
        for (std::int64_t column = span.firstColumn; column <= span.lastColumn; ++column)
            cells.push_back(toCube({column, row}));
    }
    return cells;
}

std::set<HexCoord> asSet(const std::vector<HexCoord> &cells)
{
    return {cells.begin(), cells.end()};
}

std::string text(const Point &p)
{
    std::array<char, 64> written{};
    std::snprintf(written.data(), written.size(), "(%.17g, %.17g)", p.x(), p.y());
    return written.data();
}

/// A segment, a disc and a lattice under test.
struct Query
{
    HexLattice lattice;
    Point a;
    Point b;
    double radius;

    std::string describe(HexCoord cell) const
    {
        const OffsetCoord o = toOffset(cell);
        return "column " + std::to_string(o.column) + " row " + std::to_string(o.row) + ", segment " + text(a) + " " +
               text(b) + ", radius " + std::to_string(radius) + ", pitch " + std::to_string(lattice.pitch()) +
               ", origin " + text(lattice.northWest());
    }
};

/// What is wrong with the answer for one cell; empty if nothing is.
std::string judge(const Query &query, const SegmentSpans &spans, HexCoord cell)
{
    const OffsetCoord o = toOffset(cell);
    bool inSpan = false;
    if (o.row >= spans.firstRow() && o.row <= spans.lastRow())
    {
        const RowSpan span = spans.span(o.row);
        inSpan = o.column >= span.firstColumn && o.column <= span.lastColumn;
    }
    const long double distance = HexOracle(query.lattice).distance(query.a, query.b, cell);
    if (!inSpan && distance <= query.radius)
        return "missing: " + query.describe(cell);
    if (inSpan && distance > query.radius + static_cast<long double>(spans.tolerance()))
        return "too far: " + query.describe(cell);
    return "";
}

/// Holds every cell that matters against the oracle: around each row's ends, and in the rows before and after. Between
/// the ends of a span all cells belong to it, for what is near a segment is convex. `all` looks at every cell of the
/// box.
std::string judge(const Query &query, bool all)
{
    const SegmentSpans spans(query.lattice, query.a, query.b, query.radius);
    const SegmentSpans back(query.lattice, query.b, query.a, query.radius);
    if (spans.firstRow() != back.firstRow() || spans.lastRow() != back.lastRow())
        return "other rows backwards: " + query.describe({0, 0});
    const double reach = query.radius + 2.0 * query.lattice.pitch() + spans.tolerance();
    const auto columnOf = [&query](double x)
    {
        return static_cast<std::int64_t>(std::floor((x - query.lattice.northWest().x()) / query.lattice.pitch()));
    };
    const std::int64_t westmost = columnOf(std::min(query.a.x(), query.b.x()) - reach);
    const std::int64_t eastmost = columnOf(std::max(query.a.x(), query.b.x()) + reach);
    for (std::int64_t row = spans.firstRow() - 2; row <= spans.lastRow() + 2; ++row)
    {
        const RowSpan span = spans.span(row);
        const RowSpan backSpan = back.span(row);
        if (span.firstColumn != backSpan.firstColumn || span.lastColumn != backSpan.lastColumn)
            return "another span backwards: " + query.describe(toCube({span.firstColumn, row}));
        const bool empty = span.lastColumn < span.firstColumn;
        for (std::int64_t column = westmost; column <= eastmost; ++column)
        {
            const bool nearEnd = std::abs(column - span.firstColumn) <= 1 || std::abs(column - span.lastColumn) <= 1;
            if (!all && !empty && !nearEnd)
                continue;
            const std::string verdict = judge(query, spans, toCube({column, row}));
            if (!verdict.empty())
                return verdict;
        }
    }
    return "";
}

}  // namespace

// --- from centre to centre, in integers ---

TEST(HexTraversal, centreToCentreIsExactWithinEightSteps)
{
    // from one cell of an even and one of an odd row to all cells within 8 steps: by symmetry all pairs that near
    for (const HexCoord a : {HexCoord{0, 0}, HexCoord{-4, 1}, HexCoord{5, -3}})
        for (std::int64_t q = -8; q <= 8; ++q)
            for (std::int64_t s = -8; s <= 8; ++s)
            {
                const HexCoord b = a + HexCoord{q, s};
                std::set<HexCoord> expected;
                for (std::int64_t cq = -10; cq <= 10; ++cq)
                    for (std::int64_t cs = -10; cs <= 10; ++cs)
                        if (touchesExactly<std::int64_t>(a, b, a + HexCoord{cq, cs}))
                            expected.insert(a + HexCoord{cq, cs});
                const std::vector<HexCoord> cells = touchedCells(a, b);
                ASSERT_EQ(asSet(cells), expected) << "to " << q << ", " << s;
                ASSERT_EQ(cells.size(), expected.size()) << "each cell once";
                ASSERT_EQ(touchedCells(b, a), cells) << "the same backwards";
            }
}

TEST(HexTraversal, edgesAndCornersCount)
{
    // To the cell two rows due south: along the edge that two cells of the row between share.
    EXPECT_EQ(touchedCells({0, 0}, {-1, 2}), (std::vector<HexCoord>{{0, 0}, {-1, 1}, {0, 1}, {-1, 2}}));
    // Due east nothing else is touched, for level neighbours meet in edges.
    EXPECT_EQ(touchedCells({0, 0}, {3, 0}), (std::vector<HexCoord>{{0, 0}, {1, 0}, {2, 0}, {3, 0}}));
    // The jump of the third ring passes two cells besides its ends.
    EXPECT_EQ(touchedCells({0, 0}, {2, 1}), (std::vector<HexCoord>{{0, 0}, {1, 0}, {1, 1}, {2, 1}}));
    EXPECT_EQ(touchedCells({7, -3}, {7, -3}), (std::vector<HexCoord>{{7, -3}}));
}

TEST(HexTraversal, centreToCentreIsExactHoweverFar)
{
    for (std::uint64_t seed = 1; seed <= 2000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        // 10^9 cells, and as far as the header promises
        const std::int64_t reach = seed % 3 == 0 ? std::int64_t{1} << 60 : 1000000000;
        HexCoord a{random.integer(-reach, reach), random.integer(-reach, reach)};
        HexCoord b{random.integer(-reach, reach), random.integer(-reach, reach)};
        if (seed % 5 == 0)
            b.s = a.s + random.integer(-2, 2);  // nearly level
        if (seed % 5 == 1)
            b = a + random.integer(-reach / 8, reach / 8) * HexCoord{1, 1};  // through corners all the way
        if (seed % 5 == 2)
            b = a + random.integer(-reach / 8, reach / 8) * HexCoord{-1, 2};  // along edges all the way
        b.q = std::clamp(b.q, -reach, reach);
        b.s = std::clamp(b.s, -reach, reach);
        const std::int64_t north = std::min(a.s, b.s);
        const std::int64_t south = std::max(a.s, b.s);
        for (int i = 0; i < 12; ++i)
        {
            const std::int64_t row = i == 0 ? north : i == 1 ? south : random.integer(north, south);
            const RowSpan span = touchedSpan(a, b, row);
            ASSERT_LE(span.firstColumn, span.lastColumn);
            for (const std::int64_t end : {span.firstColumn, span.lastColumn})
                ASSERT_TRUE(touchesExactly<Wide>(a, b, toCube({end, row})));
            ASSERT_FALSE(touchesExactly<Wide>(a, b, toCube({span.firstColumn - 1, row})));
            ASSERT_FALSE(touchesExactly<Wide>(a, b, toCube({span.lastColumn + 1, row})));
            const RowSpan back = touchedSpan(b, a, row);
            ASSERT_EQ(back.firstColumn, span.firstColumn);
            ASSERT_EQ(back.lastColumn, span.lastColumn);
        }
    }
}

TEST(HexTraversal, stopsWhenTheVisitorSaysSo)
{
    int visited = 0;
    EXPECT_FALSE(forEachTouchedCell(HexCoord{0, 0}, HexCoord{9, 4}, [&visited](HexCoord) { return ++visited < 3; }));
    EXPECT_EQ(visited, 3);
    const HexLattice lattice(Point::Zero(), 1.0, 20, 20);
    visited = 0;
    EXPECT_FALSE(forEachTouchedCell(lattice, {1, -1}, {9, -9}, [&visited](HexCoord) { return ++visited < 3; }));
    EXPECT_EQ(visited, 3);
    EXPECT_TRUE(forEachTouchedCell(lattice, {1, -1}, {9, -9}, [](HexCoord) { return true; }));
}

// --- between any two points ---

TEST(HexTraversal, throughCentresEqualsTheIntegers)
{
    // cells that are touched only in a corner or along an edge are found with doubles too, and no others
    for (const Point &origin : {Point(0.0, 0.0), Point(112.5, 21.98), Point(-4e5, 7e6)})
    {
        const HexLattice lattice(origin, std::sqrt(3.0) * 2.0, 30, 30);
        for (std::int64_t q = -9; q <= 9; ++q)
            for (std::int64_t s = -9; s <= 9; ++s)
            {
                const HexCoord a{3, 5};
                const HexCoord b = a + HexCoord{q, s};
                ASSERT_EQ(touchedCells(lattice, lattice.centre(a), lattice.centre(b)), touchedCells(a, b))
                    << "to " << q << ", " << s << " at " << origin.transpose();
            }
    }
}

TEST(HexTraversal, aPointTouchesTheCellsThatMeetThere)
{
    const HexLattice lattice({5.0, 6.0}, 2.0, 30, 30);
    const HexCoord cell{4, 7};
    EXPECT_EQ(touchedCells(lattice, lattice.centre(cell), lattice.centre(cell)), (std::vector<HexCoord>{cell}));
    const auto corners = lattice.corners(cell);
    for (std::size_t i = 0; i < 6; ++i)
    {
        const Point midway = 0.5 * (corners[i] + corners[(i + 1) % 6]);
        EXPECT_EQ(touchedCells(lattice, corners[i], corners[i]).size(), 3u) << "corner " << i;
        EXPECT_EQ(touchedCells(lattice, midway, midway).size(), 2u) << "edge " << i;
    }
}

TEST(HexTraversal, alongAnEdgeBothItsCellsAreTouched)
{
    const HexLattice lattice({5.0, 6.0}, 2.0, 30, 30);
    const auto corners = lattice.corners({4, 7});
    for (std::size_t i = 0; i < 6; ++i)
    {
        // the two cells of the edge, and the one beyond either end
        EXPECT_EQ(touchedCells(lattice, corners[i], corners[(i + 1) % 6]).size(), 4u) << "edge " << i;
    }
}

TEST(HexTraversal, propertyEveryCellWithinTheRadiusAndNoneBeyondTheTolerance)
{
    // Whole and fractional coordinates in a system of halves of width and side, so that segments often run through
    // corners, along edges, level and upright; RapidCheck shrinks them towards that.
    checkProperty(6000,
                  []
                  {
                      const double pitch = std::pow(10.0, *rc::gen::inRange(-3, 4));
                      const HexLattice lattice({pitch * *rc::gen::inRange(-9, 10), pitch * *rc::gen::inRange(-9, 10)},
                                               pitch, 9, 9);
                      const auto coordinate = [](double unit)
                      {
                          const int kind = *rc::gen::inRange(0, 3);
                          const int whole = *rc::gen::inRange(-8, 9);
                          return unit * (whole + (kind == 0 ? *rc::gen::inRange(-1000, 1000) / 1000.0 : 0.0));
                      };
                      const auto point = [&]
                      {
                          const double x = coordinate(0.5 * lattice.pitch());
                          return Point(lattice.northWest() + Point(x, coordinate(0.5 * lattice.side())));
                      };
                      const Point a = point();
                      const int shape = *rc::gen::inRange(0, 4);
                      Point b = shape == 0 ? a : point();
                      if (shape == 1)
                          b.y() = a.y();
                      const int radiusKind = *rc::gen::inRange(0, 3);
                      const double radius = radiusKind == 0   ? 0.0
                                            : radiusKind == 1 ? 0.5 * lattice.pitch() * *rc::gen::inRange(0, 7)
                                                              : 0.001 * lattice.pitch() * *rc::gen::inRange(0, 4000);
                      const std::string verdict = judge({lattice, a, b, radius}, true);
                      if (!verdict.empty())
                          RC_FAIL(verdict);
                  });
}

TEST(HexTraversal, randomSegmentsOfAllSlopesAndRadii)
{
    for (std::uint64_t seed = 1; seed <= 10000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double pitch = std::pow(10.0, random.real(-3.0, 3.0));
        const HexLattice lattice({pitch * random.real(-100, 100), pitch * random.real(-100, 100)}, pitch, 100, 100);
        const double length = pitch * std::pow(10.0, random.real(-3.0, 2.0));
        const Point a = random.pointOf(lattice, random.cellOf(lattice));
        double angle = random.real(0.0, 2 * M_PI);
        if (seed % 4 == 0)
            angle = M_PI / 6 * static_cast<double>(random.integer(0, 11));  // along and across edges
        if (seed % 8 == 1)
            angle = std::pow(10.0, random.real(-14.0, -1.0)) + (random.chance(0.5) ? M_PI : 0.0);  // nearly level
        if (seed % 8 == 3)
            angle = M_PI / 2 + std::pow(10.0, random.real(-14.0, -1.0));  // nearly upright
        const Point b = seed % 16 == 5 ? random.pointOf(lattice, random.cellOf(lattice))
                                       : Point(a + length * Point(std::cos(angle), std::sin(angle)));
        const double radius = random.chance(0.4) ? 0.0 : pitch * std::pow(10.0, random.real(-9.0, 1.3));
        ASSERT_EQ(judge({lattice, a, b, radius}, false), "");
    }
}

TEST(HexTraversal, farFromTheOrigin)
{
    // 10^9 m away the tolerance is a metre: a superset, and no cell farther than that
    for (std::uint64_t seed = 1; seed <= 1500; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double away = seed % 2 == 0 ? 1e9 : 1e7;
        const Point origin(random.chance(0.5) ? away : -away, random.chance(0.5) ? away : -away);
        // with the origin of the lattice there, or the lattice reaching out to there
        const double pitch = std::pow(10.0, random.real(0.5, 3.0));
        const HexLattice lattice(seed % 3 == 0 ? Point(0.0, 0.0) : origin, pitch, 100, 100);
        const Point a = origin + pitch * random.pointIn({Point(-20, -20), Point(20, 20)});
        Point b = origin + pitch * random.pointIn({Point(-20, -20), Point(20, 20)});
        if (seed % 5 == 0)
            b.y() = a.y() + random.real(-2.0, 2.0) * 1e-9 * away;  // level within the tolerance, or just not
        if (seed % 5 == 1)
            b = a;
        const double radius = random.chance(0.5) ? 0.0 : pitch * random.real(0.0, 5.0);
        ASSERT_EQ(judge({lattice, a, b, radius}, false), "");
    }
}

TEST(HexTraversal, longSegmentsKeepToTheLine)
{
    // 10^6 rows and columns: the rows at random
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice({-3e6, 2e6}, 3.0, 10, 10);
        const double tilt = seed % 2 == 0 ? 1.0 : std::pow(10.0, random.real(-9.0, 0.0));
        const Point a(random.real(-3e6, 3e6), random.real(-3e6, 3e6));
        const Point b(random.real(-3e6, 3e6), a.y() + tilt * random.real(-3e6, 3e6));
        const Query query{lattice, a, b, random.chance(0.5) ? 0.0 : random.real(0.0, 30.0)};
        const SegmentSpans spans(lattice, a, b, query.radius);
        for (int i = 0; i < 30; ++i)
        {
            const std::int64_t row = i < 6    ? spans.firstRow() - 3 + i
                                     : i < 12 ? spans.lastRow() - 9 + i
                                              : random.integer(spans.firstRow(), spans.lastRow());
            const RowSpan span = spans.span(row);
            for (const std::int64_t end : {span.firstColumn, span.lastColumn})
                for (std::int64_t column = end - 2; column <= end + 2; ++column)
                    ASSERT_EQ(judge(query, spans, toCube({column, row})), "");
        }
    }
}

TEST(HexTraversal, sameCellsInTheSameOrderBackwards)
{
    for (std::uint64_t seed = 1; seed <= 3000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const HexLattice lattice({random.real(-1e4, 1e4), random.real(-1e4, 1e4)}, random.real(0.1, 10.0), 30, 30);
        const Point a = random.pointOf(lattice, random.cellOf(lattice));
        const Point b = random.pointOf(lattice, random.cellOf(lattice));
        const double radius = random.chance(0.5) ? 0.0 : random.real(0.0, 20.0);
        const std::vector<HexCoord> there = cellsOf(SegmentSpans(lattice, a, b, radius));
        ASSERT_EQ(there, cellsOf(SegmentSpans(lattice, b, a, radius)));
        ASSERT_EQ(asSet(there).size(), there.size()) << "each cell once";
        if (radius == 0.0)
        {
            ASSERT_EQ(touchedCells(lattice, a, b), there);
        }
    }
}
