#include <seahex/geometry/SegmentSpans.h>

#include "support/LatticeKinds.h"
#include "support/Property.h"
#include "support/Random.h"
#include "support/TouchedCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

using namespace seahex;
using namespace seahex::test;

namespace
{

const double infinity = std::numeric_limits<double>::infinity();
const double notANumber = std::numeric_limits<double>::quiet_NaN();

template <class LatticeType>
class SegmentSpansOf : public testing::Test
{
};
TYPED_TEST_SUITE(SegmentSpansOf, LatticeKinds, LatticeKindNames);

template <class LatticeType>
std::vector<typename LatticeType::Cell> cellsOf(const SegmentSpans &spans)
{
    std::vector<typename LatticeType::Cell> cells;
    for (std::int64_t row = spans.firstRow(); row <= spans.lastRow(); ++row)
    {
        const RowSpan span = spans.span(row);
        for (std::int64_t column = span.firstColumn; column <= span.lastColumn; ++column)
            cells.push_back(LatticeType::cell({column, row}));
    }
    return cells;
}

std::string text(const Point &p)
{
    std::array<char, 64> written{};
    std::snprintf(written.data(), written.size(), "(%.17g, %.17g)", p.x(), p.y());
    return written.data();
}

/// A segment, a disc and a lattice under test.
template <class LatticeType>
struct Query
{
    using Cell = typename LatticeType::Cell;

    LatticeType lattice;
    Point a;
    Point b;
    double radius;

    std::string describe(Cell cell) const
    {
        const OffsetCoord o = toOffset(cell);
        return "column " + std::to_string(o.column) + " row " + std::to_string(o.row) + ", segment " + text(a) + " " +
               text(b) + ", radius " + std::to_string(radius) + ", pitch " + std::to_string(lattice.pitch()) +
               ", origin " + text(lattice.northWest());
    }
};

/// What is wrong with the answer for one cell; empty if nothing is.
template <class LatticeType>
std::string judge(const Query<LatticeType> &query, const SegmentSpans &spans, typename LatticeType::Cell cell)
{
    const OffsetCoord o = toOffset(cell);
    bool inSpan = false;
    if (o.row >= spans.firstRow() && o.row <= spans.lastRow())
    {
        const RowSpan span = spans.span(o.row);
        inSpan = o.column >= span.firstColumn && o.column <= span.lastColumn;
    }
    const long double distance = CellOracle<LatticeType>(query.lattice).distance(query.a, query.b, cell);
    if (!inSpan && distance <= query.radius)
        return "missing: " + query.describe(cell);
    if (inSpan && distance > query.radius + static_cast<long double>(spans.tolerance()))
        return "too far: " + query.describe(cell);
    return "";
}

/// Holds every cell that matters against the oracle: around each row's ends, and in the rows before and after. Between
/// the ends of a span all cells belong to it, for what is near a segment is convex. `all` looks at every cell of the
/// box.
template <class LatticeType>
std::string judge(const Query<LatticeType> &query, bool all)
{
    const SegmentSpans spans(query.lattice, query.a, query.b, query.radius);
    const SegmentSpans back(query.lattice, query.b, query.a, query.radius);
    if (spans.firstRow() != back.firstRow() || spans.lastRow() != back.lastRow())
        return "other rows backwards: " + query.describe({});
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
            return "another span backwards: " + query.describe(LatticeType::cell({span.firstColumn, row}));
        const bool empty = span.lastColumn < span.firstColumn;
        for (std::int64_t column = westmost; column <= eastmost; ++column)
        {
            const bool nearEnd = std::abs(column - span.firstColumn) <= 1 || std::abs(column - span.lastColumn) <= 1;
            if (!all && !empty && !nearEnd)
                continue;
            const std::string verdict = judge(query, spans, LatticeType::cell({column, row}));
            if (!verdict.empty())
                return verdict;
        }
    }
    return "";
}

}  // namespace

TYPED_TEST(SegmentSpansOf, throughCentresEqualsTheIntegers)
{
    // cells that are touched only in a corner or along an edge are found with doubles too, and no others
    for (const Point &origin : {Point(0.0, 0.0), Point(112.5, 21.98), Point(-4e5, 7e6)})
    {
        const TypeParam lattice(origin, std::sqrt(3.0) * 2.0, 30, 30);
        const auto a = TypeParam::cell({3, 5});
        for (std::int64_t column = -6; column <= 12; ++column)
            for (std::int64_t row = -4; row <= 14; ++row)
            {
                const auto b = TypeParam::cell({column, row});
                ASSERT_EQ(touchedCells(lattice, lattice.centre(a), lattice.centre(b)), touchedCells(a, b))
                    << "to " << column << ", " << row << " at " << origin.transpose();
            }
    }
}

TYPED_TEST(SegmentSpansOf, aPointTouchesTheCellsThatMeetThere)
{
    const TypeParam lattice({5.0, 6.0}, 2.0, 30, 30);
    const auto cell = TypeParam::cell({4, 7});
    ASSERT_EQ(touchedCells(lattice, lattice.centre(cell), lattice.centre(cell)).size(), 1u);
    EXPECT_EQ(touchedCells(lattice, lattice.centre(cell), lattice.centre(cell)).front(), cell);
    const auto corners = lattice.corners(cell);
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        const Point midway = 0.5 * (corners[i] + corners[(i + 1) % corners.size()]);
        EXPECT_EQ(touchedCells(lattice, corners[i], corners[i]).size(), cellsAtCorner<TypeParam>) << "corner " << i;
        EXPECT_EQ(touchedCells(lattice, midway, midway).size(), 2u) << "edge " << i;
    }
}

TYPED_TEST(SegmentSpansOf, alongAnEdgeBothItsCellsAreTouched)
{
    const TypeParam lattice({5.0, 6.0}, 2.0, 30, 30);
    const auto corners = lattice.corners(TypeParam::cell({4, 7}));
    // the two cells of the edge, and those beyond either end
    const std::size_t expected = 2 + 2 * (cellsAtCorner<TypeParam> - 2);
    for (std::size_t i = 0; i < corners.size(); ++i)
        EXPECT_EQ(touchedCells(lattice, corners[i], corners[(i + 1) % corners.size()]).size(), expected)
            << "edge " << i;
}

TYPED_TEST(SegmentSpansOf, stopsWhenTheVisitorSaysSo)
{
    const Lattice lattice = TypeParam(Point::Zero(), 1.0, 20, 20);
    int visited = 0;
    EXPECT_FALSE(forEachTouchedCell(lattice, {1, -1}, {9, -9}, [&visited](OffsetCoord) { return ++visited < 3; }));
    EXPECT_EQ(visited, 3);
    EXPECT_TRUE(forEachTouchedCell(lattice, {1, -1}, {9, -9}, [](OffsetCoord) { return true; }));
}

TYPED_TEST(SegmentSpansOf, whatIsNoNumberTouchesNoCell)
{
    const TypeParam lattice(Point::Zero(), 1.0, 20, 20);
    const double values[] = {1.0, notANumber, infinity, -infinity};
    for (int i = 1; i < 256; ++i)
    {
        const Point a(values[i % 4], values[i / 4 % 4]);
        const Point b(values[i / 16 % 4], values[i / 64]);
        const SegmentSpans spans(lattice, a, b);
        EXPECT_GT(spans.firstRow(), spans.lastRow()) << text(a) << " " << text(b);
    }
    for (const double radius : {notANumber, infinity})
    {
        const SegmentSpans spans(lattice, {1.0, 1.0}, {2.0, 3.0}, radius);
        EXPECT_GT(spans.firstRow(), spans.lastRow()) << radius;
    }
}

TYPED_TEST(SegmentSpansOf, propertyEveryCellWithinTheRadiusAndNoneBeyondTheTolerance)
{
    // Whole and fractional coordinates in a system that corners and centres are whole in, so that segments often run
    // through corners, along edges, level and upright; RapidCheck shrinks them towards that.
    checkProperty(6000,
                  []
                  {
                      const double pitch = std::pow(10.0, *rc::gen::inRange(-3, 4));
                      const TypeParam lattice({pitch * *rc::gen::inRange(-9, 10), pitch * *rc::gen::inRange(-9, 10)},
                                              pitch, 9, 9);
                      const auto coordinate = [](double unit)
                      {
                          const int kind = *rc::gen::inRange(0, 3);
                          const int whole = *rc::gen::inRange(-8, 9);
                          return unit * (whole + (kind == 0 ? *rc::gen::inRange(-1000, 1000) / 1000.0 : 0.0));
                      };
                      const auto point = [&]
                      {
                          const double x = coordinate(2.0 * cornerGrid(lattice).x());
                          return Point(lattice.northWest() + Point(x, coordinate(2.0 * cornerGrid(lattice).y())));
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
                      const std::string verdict = judge(Query<TypeParam>{lattice, a, b, radius}, true);
                      if (!verdict.empty())
                          RC_FAIL(verdict);
                  });
}

TYPED_TEST(SegmentSpansOf, randomSegmentsOfAllSlopesAndRadii)
{
    for (std::uint64_t seed = 1; seed <= 10000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const double pitch = std::pow(10.0, random.real(-3.0, 3.0));
        const TypeParam lattice({pitch * random.real(-100, 100), pitch * random.real(-100, 100)}, pitch, 100, 100);
        const double length = pitch * std::pow(10.0, random.real(-3.0, 2.0));
        const Point a = random.pointOf(lattice, random.cellOf(lattice));
        double angle = random.real(0.0, 2 * M_PI);
        if (seed % 4 == 0)
            angle = M_PI / 12 * static_cast<double>(random.integer(0, 23));  // along and across edges
        if (seed % 8 == 1)
            angle = std::pow(10.0, random.real(-14.0, -1.0)) + (random.chance(0.5) ? M_PI : 0.0);  // nearly level
        if (seed % 8 == 3)
            angle = M_PI / 2 + std::pow(10.0, random.real(-14.0, -1.0));  // nearly upright
        const Point b = seed % 16 == 5 ? random.pointOf(lattice, random.cellOf(lattice))
                                       : Point(a + length * Point(std::cos(angle), std::sin(angle)));
        const double radius = random.chance(0.4) ? 0.0 : pitch * std::pow(10.0, random.real(-9.0, 1.3));
        ASSERT_EQ(judge(Query<TypeParam>{lattice, a, b, radius}, false), "");
    }
}

TYPED_TEST(SegmentSpansOf, farFromTheOrigin)
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
        const TypeParam lattice(seed % 3 == 0 ? Point(0.0, 0.0) : origin, pitch, 100, 100);
        const Point a = origin + pitch * random.pointIn({Point(-20, -20), Point(20, 20)});
        Point b = origin + pitch * random.pointIn({Point(-20, -20), Point(20, 20)});
        if (seed % 5 == 0)
            b.y() = a.y() + random.real(-2.0, 2.0) * 1e-9 * away;  // level within the tolerance, or just not
        if (seed % 5 == 1)
            b = a;
        const double radius = random.chance(0.5) ? 0.0 : pitch * random.real(0.0, 5.0);
        ASSERT_EQ(judge(Query<TypeParam>{lattice, a, b, radius}, false), "");
    }
}

TYPED_TEST(SegmentSpansOf, longSegmentsKeepToTheLine)
{
    // 10^6 rows and columns: the rows at random
    for (std::uint64_t seed = 1; seed <= 300; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice({-3e6, 2e6}, 3.0, 10, 10);
        const double tilt = seed % 2 == 0 ? 1.0 : std::pow(10.0, random.real(-9.0, 0.0));
        const Point a(random.real(-3e6, 3e6), random.real(-3e6, 3e6));
        const Point b(random.real(-3e6, 3e6), a.y() + tilt * random.real(-3e6, 3e6));
        const Query<TypeParam> query{lattice, a, b, random.chance(0.5) ? 0.0 : random.real(0.0, 30.0)};
        const SegmentSpans spans(lattice, a, b, query.radius);
        for (int i = 0; i < 30; ++i)
        {
            const std::int64_t row = i < 6    ? spans.firstRow() - 3 + i
                                     : i < 12 ? spans.lastRow() - 9 + i
                                              : random.integer(spans.firstRow(), spans.lastRow());
            const RowSpan span = spans.span(row);
            for (const std::int64_t end : {span.firstColumn, span.lastColumn})
                for (std::int64_t column = end - 2; column <= end + 2; ++column)
                    ASSERT_EQ(judge(query, spans, TypeParam::cell({column, row})), "");
        }
    }
}

TYPED_TEST(SegmentSpansOf, sameCellsInTheSameOrderBackwards)
{
    using Cell = typename TypeParam::Cell;
    for (std::uint64_t seed = 1; seed <= 3000; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const TypeParam lattice({random.real(-1e4, 1e4), random.real(-1e4, 1e4)}, random.real(0.1, 10.0), 30, 30);
        const Point a = random.pointOf(lattice, random.cellOf(lattice));
        const Point b = random.pointOf(lattice, random.cellOf(lattice));
        const double radius = random.chance(0.5) ? 0.0 : random.real(0.0, 20.0);
        const std::vector<Cell> there = cellsOf<TypeParam>(SegmentSpans(lattice, a, b, radius));
        ASSERT_EQ(there, cellsOf<TypeParam>(SegmentSpans(lattice, b, a, radius)));
        ASSERT_EQ(std::set<Cell>(there.begin(), there.end()).size(), there.size()) << "each cell once";
        if (radius == 0.0)
        {
            ASSERT_EQ(touchedCells(lattice, a, b), there);
        }
    }
}
