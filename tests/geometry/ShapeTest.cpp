#include <seahex/geometry/Shape.h>

#include <utility>
#include <vector>

#include <boost/geometry/geometry.hpp>
#include <gtest/gtest.h>

using namespace seahex;

TEST(Shape, visitsTheSegmentsOfLinesAndRingsInOrder)
{
    Shape shape;
    EXPECT_TRUE(shape.empty());
    shape.points = {Point(50, 50)};
    shape.lines = {LineString{Point(0, 0), Point(1, 0), Point(1, 1)}, LineString{Point(7, 7)}, LineString{}};
    Polygon area;
    area.outer() = {Point(0, 0), Point(9, 0), Point(0, 9), Point(0, 0)};
    area.inners().push_back({Point(1, 1), Point(2, 1), Point(1, 2), Point(1, 1)});
    shape.areas = {area};
    EXPECT_FALSE(shape.empty());

    std::vector<std::pair<Point, Point>> segments;
    forEachSegment(shape, [&](const Point &a, const Point &b) { segments.emplace_back(a, b); });
    const std::vector<std::pair<Point, Point>> expected = {
        {Point(0, 0), Point(1, 0)}, {Point(1, 0), Point(1, 1)}, {Point(0, 0), Point(9, 0)}, {Point(9, 0), Point(0, 9)},
        {Point(0, 9), Point(0, 0)}, {Point(1, 1), Point(2, 1)}, {Point(2, 1), Point(1, 2)}, {Point(1, 2), Point(1, 1)}};
    EXPECT_EQ(segments, expected);
}

TEST(Shape, isUnderstoodByBoostGeometry)
{
    Polygon area;
    area.outer() = {Point(0, 0), Point(4, 0), Point(4, 4), Point(0, 4), Point(0, 0)};
    EXPECT_DOUBLE_EQ(boost::geometry::distance(Point(7, 8), area), 5.0);
    EXPECT_DOUBLE_EQ(boost::geometry::distance(Point(2, 2), area), 0.0);
}
