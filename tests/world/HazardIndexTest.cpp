#include "seahex/world/HazardIndex.h"

#include "support/Random.h"
#include "support/RandomShapes.h"

#include <boost/geometry.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace seahex
{
namespace
{

namespace bg = boost::geometry;
using Segment = bg::model::segment<Point>;
using test::Random;

Hazard hazardOf(const Shape &shape)
{
    auto object = std::make_shared<HazardObject>();
    object->objectClass = "OBSTRN";
    return {object, shape};
}

/// Distance of a segment to a shape by Boost.Geometry, part by part.
double bruteForce(const Segment &segment, const Shape &shape)
{
    double best = std::numeric_limits<double>::infinity();
    for (const Point &p : shape.points)
        best = std::min(best, bg::distance(p, segment));
    for (const LineString &line : shape.lines)
        best = std::min(best, bg::distance(segment, line));
    for (const Polygon &area : shape.areas)
        best = std::min(best, bg::distance(segment, area));
    return best;
}

std::vector<Hazard> randomHazards(Random &random)
{
    const Box box{Point(-100, -100), Point(100, 100)};
    std::vector<Hazard> hazards;
    const std::int64_t count = random.integer(1, 40);
    for (std::int64_t i = 0; i < count; ++i)
    {
        Shape shape;
        if (random.chance(0.4))
            shape.points.push_back(random.pointIn(box));
        if (random.chance(0.3))
            shape.lines.push_back({random.pointIn(box), random.pointIn(box), random.pointIn(box)});
        if (random.chance(0.4) || shape.empty())
        {
            Polygon area = randomArea(random, random.pointIn(box), random.real(1.0, 30.0), random.chance(0.5));
            bg::correct(area);
            shape.areas.push_back(area);
        }
        hazards.push_back(hazardOf(shape));
    }
    return hazards;
}

TEST(HazardIndex, agreesWithBruteForce)
{
    for (std::uint64_t seed = 1; seed <= 150; ++seed)
    {
        Random random(seed);
        SCOPED_TRACE(random.seedText());
        const std::vector<Hazard> hazards = randomHazards(random);
        const HazardIndex index(hazards, [](const Hazard &) { return true; });
        for (int i = 0; i < 20; ++i)
        {
            const Point a = random.pointIn({Point(-150, -150), Point(150, 150)});
            const Point b = random.chance(0.2) ? a : random.pointIn({Point(-150, -150), Point(150, 150)});
            const Segment segment(a, b);
            double least = std::numeric_limits<double>::infinity();
            std::size_t within = 0;
            const double radius = random.real(0.0, 30.0);
            for (const Hazard &hazard : hazards)
            {
                const double distance = a == b ? bruteForce(Segment(a, a + Point(1e-12, 0)), hazard.shape)
                                               : bruteForce(segment, hazard.shape);
                least = std::min(least, distance);
                within += distance <= radius ? 1 : 0;
            }
            EXPECT_NEAR(index.nearest(a, b).distance, least, 1e-9);
            EXPECT_EQ(index.within(a, b, radius).size(), within);
        }
    }
}

TEST(HazardIndex, isZeroInsideAnAreaAndWhereSegmentsCross)
{
    Shape area;
    bg::read_wkt("POLYGON((0 0,10 0,10 10,0 10,0 0),(4 4,4 6,6 6,6 4,4 4))", area.areas.emplace_back());
    const std::vector<Hazard> hazards = {hazardOf(area)};
    const HazardIndex index(hazards, [](const Hazard &) { return true; });
    EXPECT_EQ(index.nearest(Point(1, 1), Point(2, 2)).distance, 0.0);
    EXPECT_EQ(index.nearest(Point(-5, 5), Point(15, 5)).distance, 0.0);
    EXPECT_EQ(index.nearest(Point(-5, -5), Point(5, -5)).distance, 5.0);
    EXPECT_EQ(index.nearest(Point(5, 5), Point(5, 5)).distance, 1.0) << "in the hole";
    EXPECT_EQ(index.nearest(Point(10, 20), Point(10, 10)).distance, 0.0) << "touches a corner";
}

TEST(HazardIndex, holdsOnlyWhatWasSelected)
{
    Shape near;
    near.points.push_back(Point(1, 0));
    Shape far;
    far.points.push_back(Point(5, 0));
    const std::vector<Hazard> hazards = {hazardOf(near), hazardOf(far)};
    const HazardIndex index(hazards, [&](const Hazard &hazard) { return &hazard == &hazards[1]; });
    const HazardIndex::Near found = index.nearest(Point(0, 0), Point(0, 0));
    EXPECT_EQ(found.hazard, &hazards[1]);
    EXPECT_EQ(found.distance, 5.0);
}

TEST(HazardIndex, isInfinitelyFarFromNothing)
{
    const std::vector<Hazard> none;
    const HazardIndex index(none, [](const Hazard &) { return true; });
    EXPECT_EQ(index.nearest(Point(0, 0), Point(1, 1)).hazard, nullptr);
    EXPECT_EQ(index.nearest(Point(0, 0), Point(1, 1)).distance, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(index.within(Point(0, 0), Point(1, 1), 1e9).empty());
}

}  // namespace
}  // namespace seahex
